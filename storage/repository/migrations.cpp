#include "storage/repository/migrations.hpp"

#include <optional>
#include <string>
#include <utility>

#include "storage/repository/replacement.hpp"
#include "storage/repository/schema.hpp"
#include "storage/repository/store_mark.hpp"
#include "storage/sqlite/damaged_pages.hpp"
#include "storage/sqlite/database_files.hpp"
#include "storage/sqlite/failure.hpp"

namespace floeplan::repository {
namespace {

namespace fs = std::filesystem;

void refuse_folder_without_its_database(const fs::path& store) {
  std::error_code none;
  if (fs::exists(sqlite::database_in(store), none) || !is_marked_as_store(store)) return;
  throw sqlite::Failure{
      "the folder " + store.string() +
      " held a store, but its floeplan.sqlite is gone; put it back, for example with floeplan "
      "restore FILE, or choose an empty folder"};
}

}  // namespace

sqlite::Connection open_store(const fs::path& store) {
  refuse_folder_without_its_database(store);
  std::optional<sqlite::Connection> db = sqlite::Connection::open(store);
  const std::int64_t schema = schema_of(*db);
  if (schema > 0 && (schema < newest_schema() || !sqlite::has_page_checksums(*db))) {
    refuse_newer_schema(schema);
    db.reset();  // who puts another database in the place of this one has to be alone
    (void)bring_up_to_date(store);
    db = sqlite::Connection::open(store);
  }
  bring_to_newest_schema(*db);
  mark_as_store(store);
  return std::move(*db);
}

sqlite::Connection open_scratch_store(const fs::path& folder) {
  sqlite::Connection db = sqlite::Connection::open_scratch(folder);
  bring_to_newest_schema(db);
  return db;
}

sqlite::Connection open_store_in_memory() {
  sqlite::Connection db = sqlite::Connection::in_memory();
  bring_to_newest_schema(db);
  return db;
}

}  // namespace floeplan::repository
