#include <memory>
#include <string>
#include <vector>

#include "server/cli/program/command.hpp"
#include "server/cli/serving/serve.hpp"

namespace floeplan::cli {
namespace {

void add_time_limit(CLI::App& command, const std::string& job_class, core::Seconds& limit) {
  constexpr double a_year_s = 3.2e7;
  command
      .add_option_function<double>(
          "--max-" + job_class + "-s", [&limit](double seconds) { limit = core::Seconds{seconds}; },
          "Longest that " + job_class + " jobs may run, seconds")
      ->check(CLI::Range(0.001, a_year_s, "FLOAT in [0.001 - 32000000]"))
      ->default_str(std::to_string(static_cast<long>(limit.count())));
}

/// Adds the flags of a process that runs jobs.
void add_work(CLI::App& command, ServeOptions& options) {
  command
      .add_option("--workers", options.workers,
                  "Interactive jobs of one token at the same time, and one of another; flights of one batch")
      ->capture_default_str();
  add_time_limit(command, "interactive", options.time_limits.interactive);
  add_time_limit(command, "batch", options.time_limits.batch);
  add_time_limit(command, "ingest", options.time_limits.ingest);
  command.add_flag("--allow-weak-sandbox", options.allow_weak_sandbox,
                   "Ingest files even where this machine cannot confine the processes that read them");
}

void run_by(CLI::App& command, const std::shared_ptr<ServeOptions>& options, Program& program) {
  command.callback([options, &program] {
    options->store = program.store;
    options->server = program.server;
    options->log_level = program.log_level;
    options->reread = program.reread_serve;
    program.exit_code = program.serve(*options);
  });
}

}  // namespace

void add_serve(CLI::App& app, Program& program) {
  auto options = std::make_shared<ServeOptions>();
  auto* command = app.add_subcommand("serve", "Serve the map, the HTTP API and the guide");
  command->add_option("--listen", options->listen, "ADDR:PORT; port 0: any free port")->capture_default_str();
  command->add_option("--web", options->web, "Folder of the built map client, for example web/dist");
  command->add_option(
      "--watch", options->watch,
      "Folder to watch, for example inbox/: complete files are ingested, then moved to done/ or "
      "refused/ in it with their reports");
  command->add_option("--max-upload-mb", options->max_upload_mb, "Largest file that may be sent, megabytes")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000}))
      ->capture_default_str();
  constexpr std::uint64_t megabyte = 1'000'000;
  command
      ->add_option_function<std::uint64_t>(
          "--max-stored-mb",
          [options](std::uint64_t megabytes) { options->quotas.stored_bytes = megabytes * megabyte; },
          "Files, plans and simulations that one token may have stored, megabytes")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}))
      ->default_str(std::to_string(options->quotas.stored_bytes / megabyte));
  command
      ->add_option("--max-uploads", options->quotas.uploads,
                   "Uploads of one token that may wait to be ingested")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000}))
      ->capture_default_str();
  add_work(*command, *options);
  command->add_option(
      "--public-url", options->public_url,
      "Address that links in answers begin with, if clients know the server by another than --listen; for "
      "example https://plan.example.org");
  auto* cert = command->add_option(
      "--tls-cert", options->tls_cert,
      "Certificate with its chain, PEM, for example chain.pem; the server then speaks only HTTPS");
  auto* key =
      command->add_option("--tls-key", options->tls_key, "Key of the certificate, PEM, for example key.pem");
  cert->needs(key);
  key->needs(cert);
  command->add_flag("--https-only", options->https_only,
                    "Tell browsers to use only HTTPS for a year (HSTS); not with a self-signed certificate");
  command->add_flag("--behind-proxy", options->behind_proxy,
                    "A reverse proxy handles TLS, and appends the client's address to X-Forwarded-For");
  command->add_option("--allow-origin", options->allow_origins,
                      "Site with pages that may send requests from a browser, for example "
                      "https://map.example; may be repeated");
  run_by(*command, options, program);
}

void add_worker(CLI::App& app, Program& program) {
  auto options = std::make_shared<ServeOptions>();
  options->only_works = true;
  options->listen = "127.0.0.1:0";
  auto* command =
      app.add_subcommand("worker", "Run jobs from the queue of a store that several machines share");
  command
      ->add_option("--listen", options->listen,
                   "ADDR:PORT of health, readiness and metrics; port 0: any free port")
      ->capture_default_str();
  command
      ->add_option_function<std::vector<std::string>>(
          "--lanes",
          [options](const std::vector<std::string>& names) {
            options->lanes.clear();
            for (const std::string& name : names) options->lanes.insert(repository::parse_class(name));
          },
          "Kinds of jobs to run, separated by commas: interactive, batch, ingest")
      ->delimiter(',')
      ->check(CLI::IsMember({"interactive", "batch", "ingest"}))
      ->default_str("interactive,batch,ingest");
  add_work(*command, *options);
  run_by(*command, options, program);
}

}  // namespace floeplan::cli
