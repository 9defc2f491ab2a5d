#include "storage/sql/sqlite/sqlite_driver.hpp"

#include <SQLiteCpp/Database.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/driver/driver.hpp"
#include "storage/sql/sqlite/backup.hpp"
#include "storage/sql/sqlite/database_files.hpp"
#include "storage/sql/sqlite/idle_statements.hpp"
#include "storage/sql/sqlite/library_failure.hpp"
#include "storage/sql/sqlite/page_checksums.hpp"
#include "storage/sql/sqlite/sqlite_statement.hpp"

namespace floeplan::sql::sqlite {
namespace {

/// The header of the write-ahead log's index, which every commit changes. Reads shared memory without a lock.
/// nullopt if there is no index yet. If the header is being written, the value read differs from every
/// complete header, because it has a change counter that occurs only once.
/// Edges    changes of the tables' definitions, and changes that are rolled back, may or may not change it
/// Source   sqlite.org/walformat.html, 2.1
std::optional<Version> log_version(sqlite3* database) {
  sqlite3_file* file = nullptr;
  sqlite3_file_control(database, "main", SQLITE_FCNTL_FILE_POINTER, static_cast<void*>(&file));
  constexpr int index_page_bytes = 32'768;  // sqlite.org/walformat.html, 2.2
  volatile void* index = nullptr;
  const int status = file->pMethods->xShmMap(file, 0, index_page_bytes, 0, &index);
  if (status != SQLITE_OK || index == nullptr) return std::nullopt;
  Version version;
  std::copy_n(static_cast<const volatile std::uint32_t*>(index), version.numbers.size(),
              version.numbers.begin());
  return version;
}

/// Whether a page differs from its checksum in several checks; another process may be writing it during the
/// first.
bool stays_damaged(sqlite3* database, std::uint64_t offset, std::size_t page_bytes) {
  constexpr int looks = 5;
  constexpr std::chrono::milliseconds between{20};
  for (int look = 0; look < looks; ++look) {
    if (look > 0) std::this_thread::sleep_for(between);
    const auto page = bytes_in_file(database, offset, page_bytes);
    if (page.size() < page_bytes || is_whole_page(page)) return false;  // truncated meanwhile, or undamaged
  }
  return true;
}

/// Numbers of the pages, from 1, whose bytes in the file have changed. Others may read and write the database
/// meanwhile. Only page 1 if the header says that there are no checksums, because nothing is then known about
/// the others.
/// Errors   Failure when the file cannot be read
std::vector<std::uint32_t> damaged_pages_of(sqlite3* database) {
  const auto header = bytes_in_file(database, 0, header_bytes);
  if (header.empty()) return {};  // a new database, whose content is still in the log
  const PageLayout layout = layout_of_pages(header);
  if (layout.page_bytes == 0 || !layout.has_checksums) return {1};
  constexpr std::size_t pages_at_once = 256;
  const std::size_t size = layout.page_bytes;
  std::vector<std::uint32_t> damaged;
  for (std::uint64_t first = 0;; first += pages_at_once) {
    const auto block = bytes_in_file(database, first * size, pages_at_once * size);
    const std::span pages{block};
    for (std::size_t i = 0; (i + 1) * size <= pages.size(); ++i)
      if (!is_whole_page(pages.subspan(i * size, size)) && stays_damaged(database, (first + i) * size, size))
        damaged.push_back(static_cast<std::uint32_t>(first + i + 1));
    if (block.size() < pages_at_once * size) return damaged;
  }
}

constexpr int busy_timeout_ms = 10'000;
// A connection is used by one thread at a time, so it needs no mutex.
constexpr int open_flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;

/// Accepts only a database of Floeplan, or an empty new one. The content is read before the mark, because
/// another program may be creating the store now and writes mark and tables in one transaction.
void refuse_foreign_file(SQLite::Database& database) {
  const bool is_empty = database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0;
  const int mark = database.execAndGet("PRAGMA application_id").getInt();
  if (mark == application_id || (mark == 0 && is_empty)) return;
  throw Failure{messages::store_text<"database-of-another-program">(database.getFilename())};
}

/// Reserves space for checksums in a new database; an existing one keeps its page layout.
void reserve_checksums(SQLite::Database& database) {
  int bytes = checksum_bytes;
  if (sqlite3_file_control(database.getHandle(), "main", SQLITE_FCNTL_RESERVE_BYTES, &bytes) != SQLITE_OK)
    throw Failure{messages::store_text<"no-checksums">(database.getFilename())};
}

/// The busy timeout does not apply to a change of the journal mode. Without the loop, two programs that
/// create the store at the same time would see an error here.
void use_write_ahead_log(SQLite::Database& database) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds{busy_timeout_ms};
  while (true) {
    try {
      if (database.execAndGet("PRAGMA journal_mode = WAL").getString() == "wal") return;
      throw Failure{messages::store_text<"folder-without-shared-memory">(database.getFilename())};
    } catch (const SQLite::Exception& error) {
      if (error.getErrorCode() != SQLITE_BUSY || std::chrono::steady_clock::now() > deadline) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
  }
}

/// A version combined from two counters.
Version version_from(std::int64_t of_others, std::int64_t own_rows) {
  Version version;
  auto number = version.numbers.begin();
  for (const std::int64_t counter : {of_others, own_rows}) {
    *number++ = static_cast<std::uint32_t>(counter);
    *number++ = static_cast<std::uint32_t>(counter >> 32);
  }
  return version;
}

}  // namespace

SqliteDriver::SqliteDriver(std::unique_ptr<SQLite::Database> database, Sharing sharing)
    : database_{std::move(database)}, idle_{std::make_unique<IdleStatements>()}, sharing_{sharing} {
  database_->exec("PRAGMA foreign_keys = ON");
  database_->exec("PRAGMA synchronous = FULL");
  database_->exec("PRAGMA journal_size_limit = 67108864");  // bytes; shrinks the log after a large ingestion
}

SqliteDriver::~SqliteDriver() = default;

std::unique_ptr<Driver> SqliteDriver::open(const std::filesystem::path& store) {
  std::error_code error;
  const bool is_new_folder = std::filesystem::create_directories(store, error);
  if (error) throw Failure{messages::store_text<"store-folder-not-made">(store.string(), error.message())};

  using std::filesystem::perms;
  // only for the owner, because it contains tokens
  if (is_new_folder) std::filesystem::permissions(store, perms::owner_all, error);
  auto use = StoreUse::shared(store);
  const std::string file = database_in(store).string();
  const bool is_new = !std::filesystem::exists(file);
  try {
    auto database = std::make_unique<SQLite::Database>(file, open_flags, busy_timeout_ms, checked_files());
    if (is_new) std::filesystem::permissions(file, perms::owner_read | perms::owner_write, error);
    reserve_checksums(*database);
    refuse_foreign_file(*database);
    use_write_ahead_log(*database);
    std::unique_ptr<SqliteDriver> driver{new SqliteDriver{std::move(database), Sharing::shared}};
    driver->use_ = std::move(use);
    return driver;
  } catch (const SQLite::Exception& cause) {
    throw failure_of(cause, file);
  }
}

std::unique_ptr<Driver> SqliteDriver::open_scratch(const std::filesystem::path& folder) {
  const std::string file = database_in(folder).string();
  try {
    std::unique_ptr<SqliteDriver> scratch{new SqliteDriver{
        std::make_unique<SQLite::Database>(file, open_flags, busy_timeout_ms), Sharing::alone}};
    scratch->database_->exec("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF");
    // the schema is this program's own; its triggers fill R*Trees
    scratch->database_->exec("PRAGMA trusted_schema = ON");
    return scratch;
  } catch (const SQLite::Exception& cause) {
    throw failure_of(cause, file);
  }
}

std::unique_ptr<Driver> SqliteDriver::in_memory() {
  return std::unique_ptr<Driver>{new SqliteDriver{
      std::make_unique<SQLite::Database>(":memory:", open_flags, busy_timeout_ms), Sharing::alone}};
}

std::unique_ptr<PreparedStatement> SqliteDriver::prepare(const std::string& sql) {
  return std::make_unique<SqliteStatement>(*database_, *idle_, sql);
}

void SqliteDriver::run_script(const std::string& script) {
  translated(*database_, [&] { database_->exec(script); });
}

bool SqliteDriver::is_in_transaction() { return sqlite3_get_autocommit(database_->getHandle()) == 0; }

void SqliteDriver::begin_writing(WriteTurn) { run_script("BEGIN IMMEDIATE"); }

void SqliteDriver::commit() { run_script("COMMIT"); }

void SqliteDriver::roll_back() { run_script("ROLLBACK"); }

void SqliteDriver::begin_reading() { run_script("BEGIN DEFERRED"); }

double SqliteDriver::time_s() {
  return std::chrono::duration<double>{std::chrono::system_clock::now().time_since_epoch()}.count();
}

Announced SqliteDriver::announced(std::chrono::milliseconds at_most) {
  std::this_thread::sleep_for(at_most);
  return {};
}

Version SqliteDriver::version() {
  sqlite3* const database = database_->getHandle();
  if (sharing_ == Sharing::shared)
    if (const auto of_log = log_version(database)) return *of_log;
  const auto query = prepare("PRAGMA data_version");
  if (!query->step()) throw Failure{messages::store_text<"no-database-version">()};
  return version_from(query->integer(0), sqlite3_total_changes64(database));
}

void SqliteDriver::back_up(const std::filesystem::path& file) { sqlite::back_up(*database_, file); }

bool SqliteDriver::has_page_checksums() {
  return layout_of_pages(bytes_in_file(database_->getHandle(), 0, header_bytes)).has_checksums;
}

std::vector<std::uint32_t> SqliteDriver::damaged_pages() { return damaged_pages_of(database_->getHandle()); }

}  // namespace floeplan::sql::sqlite
