#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "engine/core/units.hpp"
#include "storage/sql/driver/driver.hpp"

namespace floeplan::sql {

/// A connection to the database of a store. Committed data survive a kill and a power cut; references between
/// tables are enforced; a connection waits up to ten seconds for another one's lock.
/// Threads  one thread at a time; open one connection for each thread
/// Edges    its statements must be destroyed before it
/// Errors   std::runtime_error when the database cannot be opened, is damaged, or belongs to another program;
///          it is then not changed
class Connection {
 public:
  /// Opens the database of a store; creates it, and its folder, if missing. Nobody can replace the database
  /// while the connection exists.
  [[nodiscard]] static Connection open(const std::filesystem::path& store);
  /// Opens (and creates) a database in `folder` for temporary data. It does not wait for the disk, so it may
  /// be lost, and nobody else may have it open for writing.
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

/// The version of the data that a connection sees (see Version). Cheap enough to be asked before every use of
/// a cached answer.
/// Edges    changes of the tables' definitions, and changes that are rolled back, may or may not change it
/// Errors   Failure when the database cannot be read
[[nodiscard]] inline Version version_of(Connection& db) { return db.driver().version(); }

/// The time of the store: the clock of the database server, which all machines share; of a store in a folder,
/// the clock of this machine. It goes on within a transaction.
[[nodiscard]] inline core::UtcTime time_of(Connection& db) { return core::from_unix_seconds(db.driver().time_s()); }

/// Whether processes on several machines may work on the store at the same time.
[[nodiscard]] inline bool is_shared(Connection& db) { return db.engine() == Engine::server; }

}  // namespace floeplan::sql
