#include "server/cli/serving/serve.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <iostream>
#include <memory>

#include "api/log/log.hpp"
#include "api/routes/request/router.hpp"
#include "api/routes/request/site.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/serving/api_handler.hpp"
#include "server/cli/serving/store_watch.hpp"
#include "server/http/server.hpp"
#include "server/jobs/queue_watch.hpp"
#include "server/jobs/watched_folder.hpp"
#include "server/jobs/worker_pool.hpp"
#include "storage/ingest/process/guarded_ingest.hpp"
#include "storage/ingest/process/staging_folder.hpp"
#include "storage/repository/access/token_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/repository/store/store_lock.hpp"
#include "storage/repository/work/upload_folder.hpp"
#include "storage/sql/store_file.hpp"
#include "storage/sql/upkeep.hpp"

namespace floeplan::cli {
namespace {

constexpr std::size_t handler_threads = 4;
constexpr std::uint64_t megabyte = 1'000'000;
/// Size of the cache of current blocks, bytes. Ten days of hourly currents on 64 x 64 nodes at one depth need
/// a sixteenth.
constexpr std::size_t most_kept_blocks = std::size_t{128} << 20;

/// The folder of the built client: from the options, beside the program, or in the source tree from which the
/// program was built.
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

/// A host name for links. An address that means all addresses of the machine cannot be used in a link; it is
/// replaced by the machine's name.
std::string reachable_host(const http::ListenAddress& address) {
  if (address.host == "0.0.0.0" || address.host == "::") {
    std::array<char, 256> name{};
    if (gethostname(name.data(), name.size() - 1) == 0) return name.data();
  }
  const bool v6 = address.host.find(':') != std::string::npos;
  return v6 ? "[" + address.host + "]" : address.host;
}

std::string origin(const http::ListenAddress& address, std::uint16_t port, bool tls) {
  return (tls ? "https://" : "http://") + reachable_host(address) + ":" + std::to_string(port);
}

/// Raises the limit of file descriptors; every connection needs one, and the default limit is low.
void raise_descriptor_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  constexpr rlim_t enough = 16'384;
  limit.rlim_cur = std::max(limit.rlim_cur, std::min<rlim_t>(limit.rlim_max, enough));
  if (setrlimit(RLIMIT_NOFILE, &limit) != 0) log::warn({"the limit of open files could not be raised"});
}

std::optional<http::TlsFiles> tls_of(const ServeOptions& options) {
  if (!options.tls_cert || !options.tls_key) return std::nullopt;
  return http::TlsFiles{*options.tls_cert, *options.tls_key};
}

/// The limits of a server: as many connections as file descriptors and memory allow, with some descriptors
/// left for files.
http::Limits limits_of(const ServeOptions& options) {
  raise_descriptor_limit();
  http::Limits limits;
  // with TLS, buffers need 85 KB per connection (measured): 350 MB in all
  constexpr std::size_t fit_by_tls = 4096;
  if (options.tls_cert) limits.connections = fit_by_tls;
  rlimit descriptors{};
  constexpr rlim_t for_files = 256;
  if (getrlimit(RLIMIT_NOFILE, &descriptors) == 0) {
    const rlim_t left = std::max(descriptors.rlim_cur, 2 * for_files) - for_files;
    limits.connections = std::min<std::size_t>(limits.connections, left);
  }
  // because all come from the proxy
  if (options.behind_proxy) limits.connections_per_address = limits.connections;
  limits.connections_per_address = std::min(limits.connections_per_address, limits.connections);
  return limits;
}

/// The settings that can change while the server runs; all other options need a restart.
http::Settings settings_of(const ServeOptions& options) {
  return {.limits = limits_of(options),
          .most_upload_bytes = options.max_upload_mb * megabyte,
          .tls = tls_of(options),
          .https_only = options.https_only,
          .log_level = options.log_level};
}

std::string without_slash(std::string url) {
  while (url.ends_with('/')) url.pop_back();
  return url;
}

sql::Connection open_store(const ServeOptions& options) {
  return options.server ? repository::open_store_at_server(*options.server)
                        : repository::open_store(options.store);
}

/// Why the doors may not be opened like this, for a person; nothing when they may.
std::optional<std::string> fault_of(const ServeOptions& options, const http::ListenAddress& address) {
  for (const std::string& site : options.allow_origins) {
    if (!routes::is_origin(site)) return messages::command_text<"no-origin">(site);
  }
  if (options.only_works || (address.loopback && !options.behind_proxy)) return std::nullopt;
  auto db = open_store(options);
  const std::string others = options.behind_proxy ? "through a proxy" : "on " + address.host;
  if (!repository::TokenRepository{db}.any()) {
    return messages::command_text<"served-without-tokens">(others);
  }
  if (!options.behind_proxy && !options.tls_cert) {
    return messages::command_text<"served-without-tls">(address.host);
  }
  return std::nullopt;
}

/// Checks every page of the database. Requests for damaged data are then answered with an error, and damaged data
/// are not written over. All other data are served.
/// Returns  the number of damaged pages. 0 at a database server, which checks its pages itself
std::size_t logged_damage(const ServeOptions& options) {
  if (options.server) return 0;
  const bool is_new = !std::filesystem::exists(sql::database_in(options.store));
  auto db = open_store(options);
  if (is_new) log::warn({"store new=\"", options.store.string(), "\" it was created, and holds nothing"});
  const std::size_t pages = sql::damaged_pages(db).size();
  if (pages > 0)
    log::error({"store damaged_pages=", std::to_string(pages),
                " what lies there cannot be read; floeplan verify names it, floeplan repair saves the rest, "
                "floeplan restore puts back a backup"});
  return pages;
}

/// A server that nobody can ask says how to change that.
void log_shut_doors(const ServeOptions& options) {
  auto db = open_store(options);
  const repository::TokenRepository tokens{db};
  if (tokens.ever_any() && !tokens.any())
    log::warn(
        {"tokens=0 the last one was revoked, and nobody is let in until floeplan token add makes another"});
}

/// The sandbox layers of reading processes, as one of them reports; also logs them.
routes::ReaderLayers logged_layers(const ingest::Guard& guard) {
  const auto layers = ingest::layers_in_force(guard);
  const std::string text = layers ? sandbox::to_text(*layers) : "not known";
  const bool enough = layers && sandbox::is_enough(*layers);
  if (enough) {
    log::info({"readers layers=\"", text, "\""});
  } else if (guard.allow_weak_sandbox) {
    log::warn({"readers layers=\"", text, "\" a hostile file could read and change whatever this user can"});
  } else {
    log::error(
        {"readers layers=\"", text, "\" too few: every file will be refused; see --allow-weak-sandbox"});
  }
  return {.layers = text, .enough = enough};
}

void serve_until_stopped(const ServeOptions& options, const http::ListenAddress& address) {
  // Of the folder: each node at a database server has its own, for the files on their way.
  const repository::StoreLock lock{options.store};
  const std::size_t damaged_pages = logged_damage(options);
  log_shut_doors(options);
  const auto open_own = [&options] { return open_store(options); };
  jobs::JobBoard board;
  Api api;  // set after the port is known
  const std::filesystem::path uploads = options.store / "uploads";
  const service::IngestPlace place{{.program = own_program(),
                                    .staging = options.store / "incoming",
                                    .allow_weak_sandbox = options.allow_weak_sandbox},
                                   uploads};
  const auto counts = std::make_shared<routes::RequestCounts>();
  const auto quotas = std::make_shared<routes::QuotasInForce>(options.quotas);
  http::Server server{address,
                      [&api](const routes::Request& request) { return api.answer(request); },
                      handler_threads,
                      limits_of(options),
                      {.streaming = {routes::streams_body, uploads, options.max_upload_mb * megabyte,
                                     [&api](const routes::Request& request) { return api.refuse(request); }},
                       .tls = tls_of(options),
                       .https_only = options.https_only,
                       .settings =
                           [&options, quotas] {
                             const ServeOptions now = options.reread();
                             http::Settings settings = settings_of(now);
                             settings.taken = [quotas, of_now = now.quotas] { quotas->set(of_now); };
                             return settings;
                           },
                       .observe =
                           [counts](const http::Exchange& exchange) {
                             counts->add(exchange.method, exchange.route, exchange.status, exchange.taken);
                           },
                       .client_of = [&api](const routes::Request& request) { return api.client_of(request); },
                       .at_once = [&api](const routes::Request& request) { return api.at_once(request); }}};
  const std::string local = origin(address, server.port(), options.tls_cert.has_value());
  const bool secure = options.behind_proxy || options.tls_cert;
  api = make_api(open_own, options.only_works ? routes::node_routes() : routes::all_routes(), board,
                 {.public_url = without_slash(options.public_url.value_or(local)),
                  .web = find_web(options),
                  .uploads = uploads,
                  .secure = secure,
                  .quotas = quotas,
                  .store = options.store,
                  .damaged_pages = damaged_pages,
                  .counts = counts,
                  .reader_layers = logged_layers(place.guard),
                  .connections = [&server] { return server.connections(); },
                  .current_blocks = std::make_shared<repository::CurrentBlocks>(most_kept_blocks)},
                 {.open_without_tokens = address.loopback && !options.behind_proxy,
                  .secure = secure,
                  .behind_proxy = options.behind_proxy,
                  .origins = options.allow_origins});
  repository::UploadFolder{uploads}.remove_expired(now());
  ingest::StagingFolder::remove_abandoned(place.guard.staging);
  std::optional<jobs::QueueWatch> queue;
  if (options.server) queue.emplace(open_own(), board);
  std::optional<jobs::WorkerPool> workers;
  if (options.workers > 0)
    workers.emplace(open_own, board, options.workers, place, options.time_limits, options.lanes);
  std::optional<StoreWatch> files;
  if (!options.server) files.emplace(options.store);
  std::optional<jobs::WatchedFolder> watched;
  if (options.watch) watched.emplace(*options.watch, open_own, place.guard);
  std::cerr << "floeplan: " << (options.only_works ? "working, health at " : "serving ") << local << '\n'
            << std::flush;
  server.run();
  if (workers) workers->stop();
}

}  // namespace

int serve(const ServeOptions& options) {
  const auto address = http::parse_listen_address(options.listen);
  if (!address) return complain(wrong_usage, address.error());
  if (options.workers > 64 || (options.workers < 1 && (!options.server || options.only_works)))
    return complain<"wrong-number-of-workers">(wrong_usage, options.workers);
  if (options.only_works && !options.server) return complain<"worker-without-shared-store">(wrong_usage);
  if (options.https_only && !options.tls_cert && !options.behind_proxy)
    return complain<"https-only-without-tls">(wrong_usage);
  log::to_stderr(options.log_level);
  std::signal(SIGHUP, SIG_IGN);  // ignored until reloading is possible
  try {
    if (const auto fault = fault_of(options, *address)) return complain(wrong_usage, *fault);
    serve_until_stopped(options, *address);
    return 0;
  } catch (const std::exception& error) {
    return complain(could_not, error.what());
  }
}

}  // namespace floeplan::cli
