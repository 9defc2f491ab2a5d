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

namespace floeplan::cli {

/// What `floeplan serve` was told.
struct ServeOptions {
  std::filesystem::path store;  // the data folder, created when missing
  std::optional<std::string>
      server;  // address of the database server that keeps the store; empty: the folder does
  std::string listen{"127.0.0.1:8080"};  // ADDR:PORT; port 0: any free port
  std::size_t workers{1};                // interactive jobs of one owner at the same time
  jobs::TimeLimits time_limits{};
  std::optional<std::filesystem::path> web;  // folder of the built client; default: found beside the program
  std::optional<std::filesystem::path> watch;  // folder whose files are ingested as they come
  std::uint64_t max_upload_mb{2000};           // the largest file that may be sent
  routes::Quotas quotas{};
  std::string log_level{"info"};                  // debug, info, warning, error or off
  std::optional<std::string> public_url;          // what links begin with; default: http://ADDR:PORT
  bool behind_proxy{false};                       // a proxy does TLS and names its client
  std::vector<std::string> allow_origins;         // of other sites whose pages may ask
  std::optional<std::filesystem::path> tls_cert;  // PEM; with tls_key
  std::optional<std::filesystem::path> tls_key;
  bool https_only{false};  // tell browsers to come by HTTPS alone; not for certificates that they do not know
  /// The same from the command line and the file of --config as it is now; std::runtime_error for one that is wrong.
  std::function<ServeOptions()> reread{};
  bool allow_weak_sandbox{false};  // read files even where their readers cannot be confined
};

/// SIGHUP takes certificate, limits, quotas and log level anew, without the end of any connection.
/// Serves until SIGTERM or SIGINT, then stops within ten seconds and hands unfinished jobs back to the queue.
/// Returns  the exit code: 0 stopped as asked, 1 could not listen or open the store, 2 wrong options
[[nodiscard]] int serve(const ServeOptions& options);

}  // namespace floeplan::cli
