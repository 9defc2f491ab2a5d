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

/// The header of the write-ahead log's index, which every commit changes. It takes no lock, for it looks at memory that all
/// share. Nothing where the index is not there yet. A header that is being written as it is read is like none that is whole:
/// the number of the change in it has no second.
/// Edges    changes of tables themselves, and what is undone again, may count or not
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

/// Whether a page stays unlike its checksum: who writes it at this moment has done so a little later.
bool stays_damaged(sqlite3* database, std::uint64_t offset, std::size_t page_bytes) {
  constexpr int looks = 5;
  constexpr std::chrono::milliseconds between{20};
  for (int look = 0; look < looks; ++look) {
    if (look > 0) std::this_thread::sleep_for(between);
    const auto page = bytes_in_file(database, offset, page_bytes);
    if (page.size() < page_bytes || is_whole_page(page)) return false;  // cut off meanwhile, or whole
  }
  return true;
}

/// Numbers of the pages, from 1, whose bytes in the file are not those that were written. Others may read and write the
/// database meanwhile. Of a file whose header reserves no bytes for checksums the first: nothing is known of the rest.
/// Errors   Failure when the file cannot be read
std::vector<std::uint32_t> damaged_pages_of(sqlite3* database) {
  const auto header = bytes_in_file(database, 0, header_bytes);
  if (header.empty()) return {};  // a database that nothing was moved to yet
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
// A connection serves one thread at a time, so it need not lock itself.
constexpr int open_flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;

/// Ours already, or so new that nobody has put anything into it. The contents are looked at first: another program
/// may be creating the store at this moment, and puts its mark and its tables there at once.
void refuse_foreign_file(SQLite::Database& database) {
  const bool is_empty = database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0;
  const int mark = database.execAndGet("PRAGMA application_id").getInt();
  if (mark == application_id || (mark == 0 && is_empty)) return;
  throw Failure{messages::store_text<"database-of-another-program">(database.getFilename())};
}

/// In a database that does not exist yet; one that does keeps its form.
void reserve_checksums(SQLite::Database& database) {
  int bytes = checksum_bytes;
  if (sqlite3_file_control(database.getHandle(), "main", SQLITE_FCNTL_RESERVE_BYTES, &bytes) != SQLITE_OK)
    throw Failure{messages::store_text<"no-checksums">(database.getFilename())};
}

/// The busy timeout does not hold while the journal mode changes: two programs that create the store at once would
/// otherwise see an error here.
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

/// The numbers of a version that are put together from two counters.
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
  database_->exec("PRAGMA journal_size_limit = 67108864");  // bytes: an ingestion's log shrinks again
}

SqliteDriver::~SqliteDriver() = default;

std::unique_ptr<Driver> SqliteDriver::open(const std::filesystem::path& store) {
  std::error_code error;
  const bool is_new_folder = std::filesystem::create_directories(store, error);
  if (error) throw Failure{messages::store_text<"store-folder-not-made">(store.string(), error.message())};

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
    scratch->database_->exec("PRAGMA trusted_schema = ON");  // it is ours, and its triggers fill R*Trees
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

void SqliteDriver::begin_reading() { run_script("BEGIN DEFERRED"); }

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
