#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "storage/sql/driver/driver.hpp"

namespace floeplan::sql {

/// One connection to the database of a store. What was committed survives a kill and a power cut; references between tables
/// are enforced; who has to wait for another does so for ten seconds.
/// Threads  one thread at a time; open one connection for each thread
/// Edges    its statements are to be gone before it is
/// Errors   std::runtime_error when the database cannot be opened, is damaged, or belongs to another program; it is left as
///          it is then
class Connection {
 public:
  /// Opens (and creates, with its folder) the database of a store. Nobody puts another one in its place while the connection
  /// lasts.
  [[nodiscard]] static Connection open(const std::filesystem::path& store);
  /// Opens (and creates) a database in `folder` for data that are thrown away when anything goes wrong: nothing waits for
  /// the disk, and nobody else may have it open for writing.
  [[nodiscard]] static Connection open_scratch(const std::filesystem::path& folder);
  /// Opens a database that a server keeps. `address`  "postgresql://user@host/database?...", as its client library takes it
  [[nodiscard]] static Connection open_at_server(const std::string& address);
  /// A private database in memory, for tests.
  [[nodiscard]] static Connection in_memory();

  [[nodiscard]] Engine engine() const { return driver_->engine(); }
  [[nodiscard]] Driver& driver() { return *driver_; }

 private:
  explicit Connection(std::unique_ptr<Driver> driver) : driver_{std::move(driver)} {}

  std::unique_ptr<Driver> driver_;
};

/// Costs next to nothing, so that it may be asked before every answer that is kept.
/// Edges    changes of tables themselves, and what is undone again, may count or not
/// Errors   Failure when the database cannot be read
[[nodiscard]] inline Version version_of(Connection& db) { return db.driver().version(); }

}  // namespace floeplan::sql
