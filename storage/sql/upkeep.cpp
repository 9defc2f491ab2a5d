#include "storage/sql/upkeep.hpp"

#include "storage/sql/statement.hpp"

namespace floeplan::sql {

void back_up(Connection& db, const std::filesystem::path& file) { db.driver().back_up(file); }

void shorten_log(Connection& db) { execute(db, "PRAGMA wal_checkpoint(PASSIVE)"); }

bool has_page_checksums(Connection& db) { return db.driver().has_page_checksums(); }

std::vector<std::uint32_t> damaged_pages(Connection& db) { return db.driver().damaged_pages(); }

std::string damage_of_structure(Connection& db) {
  Statement check{db, "PRAGMA integrity_check(1)"};
  const std::string found = check.step() ? check.text(0) : "nothing was checked";
  return found == "ok" ? "" : found;
}

}  // namespace floeplan::sql
