#include "server/cli/api_handler.hpp"

#include <spdlog/spdlog.h>

#include <memory>
#include <mutex>
#include <vector>

#include "api/routes/store_trouble.hpp"

namespace floeplan::cli {
namespace {

/// Connections that are lent to one call at a time and kept for the next.
class ConnectionPool {
 public:
  explicit ConnectionPool(std::function<sqlite::Connection()> open) : open_{std::move(open)} {}

  template <class Use>
  auto with_connection(const Use& use) {
    auto connection = take();
    auto result = use(connection);
    give_back(std::move(connection));  // not after an exception: then its state is not known
    return result;
  }

 private:
  sqlite::Connection take() {
    {
      const std::lock_guard lock{mutex_};
      if (!free_.empty()) {
        auto connection = std::move(free_.back());
        free_.pop_back();
        return connection;
      }
    }
    return open_();
  }

  void give_back(sqlite::Connection connection) {
    const std::lock_guard lock{mutex_};
    free_.push_back(std::move(connection));
  }

  std::function<sqlite::Connection()> open_;
  std::mutex mutex_;
  std::vector<sqlite::Connection> free_;
};

/// What `work` gives, or what a client is told when the store does not do its part.
template <class Result, class Work>
Result or_store_trouble(const routes::Request& request, const Work& work) {
  try {
    return work();
  } catch (const sqlite::Failure& failure) {
    spdlog::error("method={} path={} failed: {}", request.method, request.path, failure.what());
    return routes::store_trouble_reply(request, failure);
  }
}

}  // namespace

Api make_api(std::function<sqlite::Connection()> open_store, routes::JobGateway& jobs,
             routes::ServiceInfo service, routes::Doors doors) {
  auto doorkeeper =
      std::make_shared<routes::Doorkeeper>(std::move(doors), routes::Router{routes::all_routes()});
  auto pool = std::make_shared<ConnectionPool>(std::move(open_store));
  auto info = std::make_shared<const routes::ServiceInfo>(std::move(service));
  const auto with_context = [pool, info, &jobs](const auto& use) {
    return pool->with_connection(
        [&](sqlite::Connection& db) { return use(routes::Context{db, jobs, *info}); });
  };
  return {.answer =
              [doorkeeper, with_context](const routes::Request& request) {
                return or_store_trouble<routes::Response>(request, [&] {
                  return with_context(
                      [&](const routes::Context& context) { return doorkeeper->answer(context, request); });
                });
              },
          .refuse =
              [doorkeeper, with_context](const routes::Request& request) {
                return or_store_trouble<std::optional<routes::Response>>(request, [&] {
                  return with_context(
                      [&](const routes::Context& context) { return doorkeeper->refuse(context, request); });
                });
              }};
}

}  // namespace floeplan::cli
