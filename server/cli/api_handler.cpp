#include "server/cli/api_handler.hpp"

#include <memory>
#include <mutex>
#include <vector>

#include "api/routes/router.hpp"

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

}  // namespace

routes::Handler make_api_handler(std::function<sqlite::Connection()> open_store, routes::JobGateway& jobs,
                                 routes::ServiceInfo service) {
  auto router = std::make_shared<const routes::Router>(routes::all_routes());
  auto pool = std::make_shared<ConnectionPool>(std::move(open_store));
  auto info = std::make_shared<const routes::ServiceInfo>(std::move(service));
  return [router, pool, info, &jobs](const routes::Request& request) {
    return pool->with_connection(
        [&](sqlite::Connection& db) { return router->answer({db, jobs, *info}, request); });
  };
}

}  // namespace floeplan::cli
