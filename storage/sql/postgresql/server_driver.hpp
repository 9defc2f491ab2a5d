#pragma once

#include <memory>
#include <string>

#include "storage/sql/driver/driver.hpp"
#include "storage/sql/postgresql/server_session.hpp"

namespace floeplan::sql::postgresql {

/// A session at a PostgreSQL server, 15 or newer, whose database many machines use.
/// Writing    one transaction at a time writes to a store, so that changes are committed in the order of their numbers: who
///            begins one waits for the one before, by a lock that the server holds for the store's schema
/// Files      the database is the server's: it has no file that could be copied or checked here
class ServerDriver final : public Driver {
 public:
  /// `address`  a connection string or URL of libpq
  [[nodiscard]] static std::unique_ptr<Driver> open(const std::string& address);

  [[nodiscard]] Engine engine() const override { return Engine::server; }
  [[nodiscard]] std::unique_ptr<PreparedStatement> prepare(const std::string& sql) override;
  void run_script(const std::string& script) override { session_.run_script(script); }

  [[nodiscard]] bool is_in_transaction() override { return session_.is_in_transaction(); }
  void begin_writing(WriteTurn turn) override;
  void commit() override { session_.commit(); }
  void roll_back() override { session_.roll_back(); }
  void begin_reading() override;
  [[nodiscard]] Version version() override;
  [[nodiscard]] double time_s() override;
  void in_each_session(const std::string& statement) override { session_.run_in_each(statement); }
  [[nodiscard]] Announced announced(std::chrono::milliseconds at_most) override {
    return session_.announced(at_most);
  }

  void back_up(const std::filesystem::path& file) override;
  [[nodiscard]] bool has_page_checksums() override;
  [[nodiscard]] std::vector<std::uint32_t> damaged_pages() override;

 private:
  explicit ServerDriver(const std::string& address);

  ServerSession session_;
};

}  // namespace floeplan::sql::postgresql
