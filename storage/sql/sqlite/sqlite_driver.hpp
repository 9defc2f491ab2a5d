#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "storage/sql/driver/driver.hpp"
#include "storage/sql/sqlite/store_use.hpp"

namespace SQLite {
class Database;
}

namespace floeplan::sql::sqlite {

class IdleStatements;

/// A connection to a database of SQLite: foreign keys on, full synchronisation and a busy timeout, so that a committed
/// transaction survives a kill and a power cut.
/// Errors   Failure when the file cannot be opened, is damaged, or is a database of another program; such a
///          file is not changed
class SqliteDriver : public Driver {
 public:
  /// Opens `<store>/floeplan.sqlite`, with a write-ahead log and page checksums; creates it, and its folder,
  /// if missing. Nobody can replace the file while the connection exists.
  [[nodiscard]] static std::unique_ptr<Driver> open(const std::filesystem::path& store);
  /// Opens `<folder>/floeplan.sqlite` for temporary data. It does not wait for the disk, so the data may be
  /// lost, and nobody else may have it open for writing.
  [[nodiscard]] static std::unique_ptr<Driver> open_scratch(const std::filesystem::path& folder);
  /// A private database in memory.
  [[nodiscard]] static std::unique_ptr<Driver> in_memory();

  SqliteDriver(const SqliteDriver&) = delete;
  SqliteDriver& operator=(const SqliteDriver&) = delete;
  ~SqliteDriver() override;

  [[nodiscard]] Engine engine() const override { return Engine::embedded; }
  [[nodiscard]] std::unique_ptr<PreparedStatement> prepare(const std::string& sql) override;
  void run_script(const std::string& script) override;
  [[nodiscard]] bool is_in_transaction() override;
  void begin_writing(WriteTurn turn) override;
  void commit() override;
  void roll_back() override;
  void begin_reading() override;
  [[nodiscard]] Version version() override;
  [[nodiscard]] double time_s() override;
  void in_each_session(const std::string& statement) override { run_script(statement); }
  /// One process at a time serves a store in a folder, and nobody else announces anything.
  [[nodiscard]] Announced announced(std::chrono::milliseconds at_most) override;
  void back_up(const std::filesystem::path& file) override;
  [[nodiscard]] bool has_page_checksums() override;
  [[nodiscard]] std::vector<std::uint32_t> damaged_pages() override;

 private:
  /// Whether others may have the database open as well, which needs a write-ahead log.
  enum class Sharing { shared, alone };
  SqliteDriver(std::unique_ptr<SQLite::Database> database, Sharing sharing);

  std::optional<StoreUse> use_;  // destroyed after the database is closed
  std::unique_ptr<SQLite::Database> database_;
  std::unique_ptr<IdleStatements> idle_;  // cached statements of database_
  Sharing sharing_;
};

}  // namespace floeplan::sql::sqlite
