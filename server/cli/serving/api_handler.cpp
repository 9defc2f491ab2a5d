#include "server/cli/serving/api_handler.hpp"

#include <memory>
#include <mutex>
#include <vector>

#include "api/log/log.hpp"
#include "api/routes/access/known_clients.hpp"
#include "api/routes/request/remembered.hpp"
#include "api/routes/request/store_trouble.hpp"
#include "engine/core/shown_text.hpp"

namespace floeplan::cli {
namespace {

/// A database connection with its caches.
struct Reader {
  sql::Connection db;
  routes::Remembered remembered{};
};

/// A pool of connections. Each is used by one call at a time. The most recently used one is given out first,
/// because its cache is the fullest.
class ConnectionPool {
 public:
  explicit ConnectionPool(std::function<sql::Connection()> open) : open_{std::move(open)} {}

  template <class Use>
  auto with_reader(const Use& use) {
    std::unique_ptr<Reader> reader = take();
    reader->remembered.refresh(reader->db);
    auto result = use(*reader);
    give_back(std::move(reader));  // not after an exception, because the connection's state is then unknown
    return result;
  }

 private:
  std::unique_ptr<Reader> take() {
    {
      const std::lock_guard lock{mutex_};
      if (!free_.empty()) {
        auto reader = std::move(free_.back());
        free_.pop_back();
        return reader;
      }
    }
    return std::make_unique<Reader>(Reader{open_()});
  }

  void give_back(std::unique_ptr<Reader> reader) {
    const std::lock_guard lock{mutex_};
    free_.push_back(std::move(reader));
  }

  std::function<sql::Connection()> open_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Reader>> free_;
};

/// The result of `work`, or the response for the client if the store fails.
template <class Result, class Work>
Result or_store_trouble(const routes::Request& request, const Work& work) {
  try {
    return work();
  } catch (const sql::Failure& failure) {
    log::error(
        {"method=", request.method, " path=", core::shown_target(request.path), " failed: ", failure.what()});
    return routes::store_trouble_reply(request, failure);
  }
}

/// The request as of the clock that all nodes share: what one node writes with a time, another compares with it.
routes::Request at_time_of_store(const routes::Context& context, routes::Request request) {
  request.now = sql::time_of(context.db);
  return request;
}

}  // namespace

Api make_api(std::function<sql::Connection()> open_store, std::vector<routes::Route> routes,
             routes::JobGateway& jobs, routes::ServiceInfo service, routes::Doors doors) {
  auto clients = std::make_shared<routes::KnownClients>(doors.behind_proxy);
  auto doorkeeper =
      std::make_shared<routes::Doorkeeper>(std::move(doors), routes::Router{std::move(routes)});
  auto pool = std::make_shared<ConnectionPool>(std::move(open_store));
  auto info = std::make_shared<const routes::ServiceInfo>(std::move(service));
  const auto with_context = [pool, info, &jobs](const auto& use) {
    return pool->with_reader(
        [&](Reader& reader) { return use(routes::Context{reader.db, jobs, *info, &reader.remembered}); });
  };
  return {.answer =
              [doorkeeper, with_context, clients](const routes::Request& request) {
                return or_store_trouble<routes::Response>(request, [&] {
                  auto response = with_context(
                      [&](const routes::Context& context) { return doorkeeper->answer(context, at_time_of_store(context, request)); });
                  clients->learn(request, response.caller);
                  return response;
                });
              },
          .at_once = [doorkeeper,
                      with_context](const routes::Request& request) -> std::optional<routes::Response> {
            const bool is_small = routes::asks_for_job_status(request);
            if (!is_small && !routes::follows_from_store(request)) return std::nullopt;
            return or_store_trouble<std::optional<routes::Response>>(request, [&] {
              return with_context([&](const routes::Context& context) -> std::optional<routes::Response> {
                if (!is_small && context.remembered->find(request) == nullptr) return std::nullopt;
                return doorkeeper->answer(context, at_time_of_store(context, request));
              });
            });
          },
          .client_of = [clients](const routes::Request& request) { return clients->client_of(request); },
          .refuse =
              [doorkeeper, with_context](const routes::Request& request) {
                return or_store_trouble<std::optional<routes::Response>>(request, [&] {
                  return with_context(
                      [&](const routes::Context& context) { return doorkeeper->refuse(context, at_time_of_store(context, request)); });
                });
              }};
}

}  // namespace floeplan::cli
