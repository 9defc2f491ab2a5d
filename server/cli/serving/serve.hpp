#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/routes/request/context.hpp"
#include "server/jobs/job_class.hpp"
#include "server/jobs/worker_pool.hpp"

namespace floeplan::cli {

/// Options of `floeplan serve` and `floeplan worker`.
struct ServeOptions {
  std::filesystem::path store;  // the data folder, created when missing
  std::optional<std::string>
      server;  // address of the database server that keeps the store; empty: the folder does
  std::string listen{"127.0.0.1:8080"};  // ADDR:PORT; port 0: any free port
  // number of interactive jobs of one owner that run at the same time; 0: workers elsewhere run all jobs
  std::size_t workers{1};
  jobs::Lanes lanes{jobs::all_lanes};  // the jobs that this process runs
  bool only_works{false};              // `floeplan worker`: answers only health, readiness and metrics
  jobs::TimeLimits time_limits{};
  std::optional<std::filesystem::path> web;  // folder of the built client; default: found beside the program
  std::optional<std::filesystem::path> watch;  // folder in which new files are ingested
  std::uint64_t max_upload_mb{2000};           // largest upload
  routes::Quotas quotas{};
  std::string log_level{"info"};                  // debug, info, warning, error or off
  std::optional<std::string> public_url;          // beginning of links; default: http://ADDR:PORT
  bool behind_proxy{false};                       // a proxy terminates TLS and states the client's address
  std::vector<std::string> allow_origins;         // origins of other sites whose pages may send requests
  std::optional<std::filesystem::path> tls_cert;  // PEM; with tls_key
  std::optional<std::filesystem::path> tls_key;
  // tell browsers to use only HTTPS; not useful with certificates that they do not trust
  bool https_only{false};
  /// The options from the command line and the present file of --config; std::runtime_error if that is
  /// invalid.
  std::function<ServeOptions()> reread{};
  bool allow_weak_sandbox{false};  // read files even if their readers cannot be confined
};

/// Serves, works, or both, until SIGTERM or SIGINT, then stops within ten seconds and returns unfinished jobs to the queue.
/// SIGHUP reads certificate, limits, quotas and log level again; open connections continue.
/// Returns  the exit code: 0 stopped on request, 1 could not listen or open the store, 2 wrong options
[[nodiscard]] int serve(const ServeOptions& options);

}  // namespace floeplan::cli
