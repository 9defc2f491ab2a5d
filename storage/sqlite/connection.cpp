#include "storage/sqlite/connection.hpp"

#include <SQLiteCpp/Database.h>
#include <sqlite3.h>

#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "storage/sqlite/database_files.hpp"
#include "storage/sqlite/failure.hpp"
#include "storage/sqlite/page_checksums.hpp"
#include "storage/sqlite/prepared_statements.hpp"

namespace floeplan::sqlite {
namespace {

constexpr int busy_timeout_ms = 10'000;
// A connection serves one thread at a time, so it need not lock itself.
constexpr int open_flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;

/// Ours already, or so new that nobody has put anything into it. The contents are looked at first: another program
/// may be creating the store at this moment, and puts its mark and its tables there at once.
void refuse_foreign_file(SQLite::Database& database) {
  const bool is_empty = database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0;
  const int mark = database.execAndGet("PRAGMA application_id").getInt();
  if (mark == application_id || (mark == 0 && is_empty)) return;
  throw Failure{database.getFilename() +
                " belongs to another program, not to Floeplan; choose another folder"};
}

/// In a database that does not exist yet; one that does keeps its form.
void reserve_checksums(SQLite::Database& database) {
  int bytes = checksum_bytes;
  if (sqlite3_file_control(database.getHandle(), "main", SQLITE_FCNTL_RESERVE_BYTES, &bytes) != SQLITE_OK)
    throw Failure{database.getFilename() + " cannot be given checksums"};
}

/// The busy timeout does not hold while the journal mode changes: two programs that create the store at once would
/// otherwise see an error here.
void use_write_ahead_log(SQLite::Database& database) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds{busy_timeout_ms};
  while (true) {
    try {
      if (database.execAndGet("PRAGMA journal_mode = WAL").getString() == "wal") return;
      throw Failure{database.getFilename() +
                    " lies on a file system that cannot share memory between programs; "
                    "choose a folder on a local disk"};
    } catch (const SQLite::Exception& error) {
      if (error.getErrorCode() != SQLITE_BUSY || std::chrono::steady_clock::now() > deadline) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
  }
}

}  // namespace

Connection::Connection(std::unique_ptr<SQLite::Database> database, bool has_write_ahead_log)
    : database_{std::move(database)},
      statements_{std::make_unique<PreparedStatements>()},
      has_write_ahead_log_{has_write_ahead_log} {
  database_->exec("PRAGMA foreign_keys = ON");
  database_->exec("PRAGMA synchronous = FULL");
  database_->exec("PRAGMA journal_size_limit = 67108864");  // bytes: an ingestion's log shrinks again
}

Connection::Connection(Connection&&) noexcept = default;
Connection& Connection::operator=(Connection&& other) noexcept {
  std::swap(statements_, other.statements_);  // what this one had ends with `other`, in the right order
  std::swap(database_, other.database_);
  std::swap(has_write_ahead_log_, other.has_write_ahead_log_);
  std::swap(use_, other.use_);
  return *this;
}
Connection::~Connection() = default;

Connection Connection::open(const std::filesystem::path& store) {
  std::error_code error;
  const bool is_new_folder = std::filesystem::create_directories(store, error);
  if (error) throw Failure{"the folder " + store.string() + " cannot be created: " + error.message()};

  using std::filesystem::perms;
  if (is_new_folder) std::filesystem::permissions(store, perms::owner_all, error);  // it holds tokens
  auto use = StoreUse::shared(store);
  const std::string file = database_in(store).string();
  const bool is_new = !std::filesystem::exists(file);
  try {
    auto database = std::make_unique<SQLite::Database>(file, open_flags, busy_timeout_ms, checked_files());
    if (is_new) std::filesystem::permissions(file, perms::owner_read | perms::owner_write, error);
    reserve_checksums(*database);
    refuse_foreign_file(*database);
    use_write_ahead_log(*database);
    Connection connection{std::move(database), true};
    connection.use_ = std::move(use);
    return connection;
  } catch (const SQLite::Exception& cause) {
    throw failure_of(cause, file);
  }
}

Connection Connection::open_scratch(const std::filesystem::path& folder) {
  const std::string file = database_in(folder).string();
  try {
    Connection scratch{std::make_unique<SQLite::Database>(file, open_flags, busy_timeout_ms), false};
    scratch.handle().exec("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF");
    scratch.handle().exec("PRAGMA trusted_schema = ON");  // it is ours, and its triggers fill R*Trees
    return scratch;
  } catch (const SQLite::Exception& cause) {
    throw failure_of(cause, file);
  }
}

Connection Connection::in_memory() {
  return Connection{std::make_unique<SQLite::Database>(":memory:", open_flags, busy_timeout_ms), false};
}

}  // namespace floeplan::sqlite
