#include "server/cli/serve.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <iostream>
#include <memory>

#include "api/routes/router.hpp"
#include "server/cli/api_handler.hpp"
#include "server/cli/command.hpp"
#include "server/http/server.hpp"
#include "server/jobs/watched_folder.hpp"
#include "server/jobs/worker_pool.hpp"
#include "storage/repository/migrations.hpp"
#include "storage/repository/upload_repository.hpp"

namespace floeplan::cli {
namespace {

constexpr std::size_t handler_threads = 4;

/// Structured lines on stderr; stdout is for answers to people and scripts.
void log_to_stderr(const std::string& level) {
  auto logger =
      std::make_shared<spdlog::logger>("floeplan", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e%z level=%l %v");
  logger->set_level(spdlog::level::from_str(level));
  spdlog::set_default_logger(std::move(logger));
}

/// The built client: where it was said to be, beside the program, or in the source tree the program was built
/// in.
std::filesystem::path find_web(const ServeOptions& options) {
  if (options.web) return *options.web;
  std::error_code error;
  const auto program = std::filesystem::canonical("/proc/self/exe", error).parent_path();
  for (const auto& folder : {program / "web/dist", program / "web", program / "../share/floeplan/web",
                             program / "../../web/dist"}) {
    if (std::filesystem::exists(folder / "index.html", error)) return folder;
  }
  return {};
}

std::string origin(const http::ListenAddress& address, std::uint16_t port) {
  const bool v6 = address.host.find(':') != std::string::npos;
  return "http://" + (v6 ? "[" + address.host + "]" : address.host) + ":" + std::to_string(port);
}

std::string without_slash(std::string url) {
  while (url.ends_with('/')) url.pop_back();
  return url;
}

void serve_until_stopped(const ServeOptions& options, const http::ListenAddress& address) {
  const auto open_store = [store = options.store] { return repository::open_store(store); };
  jobs::JobBoard board;
  routes::Handler handler;  // needs the port, so it is filled in once that is known
  constexpr std::uint64_t megabyte = 1'000'000;
  const std::filesystem::path uploads = options.store / "uploads";
  const jobs::IngestPlace place{{.program = own_program(), .staging = options.store / "incoming"}, uploads};
  http::Server server{address,
                      [&handler](const routes::Request& request) { return handler(request); },
                      handler_threads,
                      {},
                      {routes::streams_body, uploads, options.max_upload_mb * megabyte}};
  const std::string local = origin(address, server.port());
  handler = make_api_handler(open_store, board,
                             {.public_url = without_slash(options.public_url.value_or(local)),
                              .web = find_web(options),
                              .uploads = uploads});
  repository::UploadRepository{uploads}.remove_expired(now());
  jobs::WorkerPool workers{open_store, board, options.workers, place};
  std::optional<jobs::WatchedFolder> watched;
  if (options.watch) watched.emplace(*options.watch, open_store, place.guard);
  std::cerr << "floeplan: serving " << local << std::endl;
  server.run();
  workers.stop();
}

}  // namespace

int serve(const ServeOptions& options) {
  const auto address = http::parse_listen_address(options.listen);
  if (!address) {
    std::cerr << "floeplan: " << address.error() << "\n";
    return 2;
  }
  if (options.workers < 1 || options.workers > 64) {
    std::cerr << "floeplan: " << options.workers
              << " workers are not possible; choose 1 to 64 with --workers\n";
    return 2;
  }
  log_to_stderr(options.log_level);
  try {
    serve_until_stopped(options, *address);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "floeplan: " << error.what() << "\n";
    return 1;
  }
}

}  // namespace floeplan::cli
