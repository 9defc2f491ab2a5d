#include "storage/sql/sqlite/backup.hpp"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <system_error>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/sqlite/database_files.hpp"
#include "storage/sql/sqlite/library_failure.hpp"
#include "storage/sql/sqlite/page_checksums.hpp"

namespace floeplan::sql::sqlite {
namespace {

namespace fs = std::filesystem;

std::string damage_in(SQLite::Database& database) {
  SQLite::Statement check{database, "PRAGMA quick_check(1)"};
  const std::string found = check.executeStep() ? check.getColumn(0).getString() : "nothing was checked";
  return found == "ok" ? "" : found;
}

/// Copies in one step, so the copy is of one state; with a write-ahead log nobody has to wait.
void copy_into(SQLite::Database& from, const fs::path& file) {
  SQLite::Database to{file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, 0, checked_files()};
  // only for the owner, because it contains tokens
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  {
    SQLite::Backup backup{to, from};
    backup.executeStep(-1);
  }
  to.exec("PRAGMA journal_mode = DELETE");  // a single file, without a log
  const std::string damage = damage_in(to);
  if (!damage.empty()) throw Failure{messages::store_text<"backup-not-sound">(damage)};
}

}  // namespace

void back_up(SQLite::Database& database, const fs::path& file) {
  if (fs::exists(file)) throw Failure{messages::store_text<"backup-exists">(file.string())};
  const fs::path unfinished = file.string() + ".unfinished";
  std::error_code ignored;
  fs::remove(unfinished, ignored);
  try {
    copy_into(database, unfinished);
    flush(unfinished);
    fs::rename(unfinished, file);
    const fs::path folder = file.parent_path();
    flush(folder.empty() ? fs::path{"."} : folder);
  } catch (const SQLite::Exception& cause) {
    fs::remove(unfinished, ignored);
    throw failure_of(cause, unfinished.string());
  } catch (...) {
    fs::remove(unfinished, ignored);
    throw;
  }
}

std::string damage_of(const fs::path& file) {
  try {
    SQLite::Database database{file.string(), SQLite::OPEN_READONLY, 0, checked_files()};
    if (database.execAndGet("PRAGMA application_id").getInt() != application_id)
      return "it is no store of Floeplan";
    return damage_in(database);
  } catch (const SQLite::Exception& cause) {
    throw failure_of(cause, file.string());
  }
}

}  // namespace floeplan::sql::sqlite
