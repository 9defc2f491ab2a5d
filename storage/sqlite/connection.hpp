#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "storage/sqlite/store_use.hpp"

namespace SQLite {
class Database;
}

namespace floeplan::sqlite {

class PreparedStatements;

/// Marks a database file as ours in its header ("FLOE"), so that nobody else's file is ever written to.
inline constexpr std::int32_t application_id = 0x464C4F45;

/// One connection to the store's database, set to WAL, foreign keys on, full synchronisation and a busy
/// timeout, so that a committed transaction survives a kill and a power cut.
/// Threads  one thread at a time; open one connection for each thread
/// Edges    its statements are to be gone before it is
/// Errors   std::runtime_error when the file cannot be opened, is damaged, or is a database of another
///          program; such a file is left as it is
class Connection {
 public:
  /// Opens (and creates, with its folder) `<store>/floeplan.sqlite`, whose pages have checksums. Nobody puts another file in
  /// its place while the connection lasts.
  [[nodiscard]] static Connection open(const std::filesystem::path& store);
  /// Opens (and creates) `<folder>/floeplan.sqlite` for data that are thrown away when anything goes wrong: nothing
  /// waits for the disk, and nobody else may have it open for writing.
  [[nodiscard]] static Connection open_scratch(const std::filesystem::path& folder);
  /// A private database in memory, for tests.
  [[nodiscard]] static Connection in_memory();

  Connection(Connection&&) noexcept;
  Connection& operator=(Connection&&) noexcept;
  ~Connection();

  [[nodiscard]] SQLite::Database& handle() { return *database_; }
  [[nodiscard]] PreparedStatements& statements() { return *statements_; }
  /// False where nobody else has the database: it is in memory, or data to be thrown away.
  [[nodiscard]] bool has_write_ahead_log() const { return has_write_ahead_log_; }

 private:
  Connection(std::unique_ptr<SQLite::Database> database, bool has_write_ahead_log);

  std::optional<StoreUse> use_;  // ends after the database is closed
  std::unique_ptr<SQLite::Database> database_;
  std::unique_ptr<PreparedStatements> statements_;  // of database_
  bool has_write_ahead_log_;
};

}  // namespace floeplan::sqlite
