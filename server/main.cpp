#include <CLI/CLI.hpp>

#include "server/cli/serve.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Mission planning for underwater gliders in and under ice", "floeplan"};
  app.require_subcommand(1);

  floeplan::cli::ServeOptions serve_options;
  app.add_option("--data", serve_options.store, "Folder of the store")->required();
  auto* serve = app.add_subcommand("serve", "HTTP API, web client and planning in one process");
  serve->add_option("--listen", serve_options.listen, "ADDR:PORT; port 0: any free port")
      ->capture_default_str();
  serve->add_option("--workers", serve_options.workers, "Planning jobs at the same time")
      ->capture_default_str();
  serve->add_option("--web", serve_options.web, "Folder of the built client");
  serve->add_option("--public-url", serve_options.public_url, "What links begin with");
  CLI11_PARSE(app, argc, argv);
  return floeplan::cli::serve(serve_options);
}
