#include "storage/repository/store/migrations.hpp"

#include <optional>
#include <string>
#include <utility>

#include "engine/messages/store_messages.hpp"
#include "storage/repository/store/replacement.hpp"
#include "storage/repository/store/schema.hpp"
#include "storage/repository/store/store_mark.hpp"
#include "storage/sql/driver/failure.hpp"
#include "storage/sql/schema_number.hpp"
#include "storage/sql/store_file.hpp"
#include "storage/sql/upkeep.hpp"

namespace floeplan::repository {
namespace {

namespace fs = std::filesystem;

void refuse_folder_without_its_database(const fs::path& store) {
  std::error_code none;
  if (fs::exists(sql::database_in(store), none) || !is_marked_as_store(store)) return;
  throw sql::Failure{
      messages::store_text<"database-gone">(store.string(), sql::database_in(store).filename().string())};
}

}  // namespace

sql::Connection open_store(const fs::path& store) {
  refuse_folder_without_its_database(store);
  std::optional<sql::Connection> db = sql::Connection::open(store);
  const std::int64_t schema = sql::schema_number(*db);
  if (schema > 0 && (schema < newest_schema() || !sql::has_page_checksums(*db))) {
    refuse_newer_schema(schema);
    db.reset();  // the database can only be replaced when nobody else has it open
    (void)bring_up_to_date(store);
    db = sql::Connection::open(store);
  }
  bring_to_newest_schema(*db);
  mark_as_store(store);
  return std::move(*db);
}

sql::Connection open_scratch_store(const fs::path& folder) {
  sql::Connection db = sql::Connection::open_scratch(folder);
  bring_to_newest_schema(db);
  return db;
}

sql::Connection open_store_at_server(const std::string& address) {
  sql::Connection db = sql::Connection::open_at_server(address);
  bring_to_newest_schema(db);
  return db;
}

sql::Connection open_store_in_memory() {
  sql::Connection db = sql::Connection::in_memory();
  bring_to_newest_schema(db);
  return db;
}

}  // namespace floeplan::repository
