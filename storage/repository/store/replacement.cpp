#include "storage/repository/store/replacement.hpp"

#include <stdexcept>

#include "engine/messages/store_messages.hpp"
#include "storage/repository/store/rebuilding.hpp"
#include "storage/repository/store/schema.hpp"
#include "storage/repository/store/store_mark.hpp"
#include "storage/sql/store_file.hpp"

namespace floeplan::repository {
namespace {

namespace fs = std::filesystem;

enum class Losses { refused, accepted };
enum class OldDatabase {
  settled,    // a single file, which stays until the new one replaces it
  unreadable  // missing, or with a log that cannot be merged into it
};

std::string in_words(const StoredThing& thing) {
  return "the " + thing.kind + (thing.id.empty() ? " in row " + std::to_string(thing.row) : " " + thing.id);
}

/// Refuses a damaged header. It says whether pages have checksums, so its damage is not found by a checksum.
void refuse_changed_header(const fs::path& database) {
  const auto header = sql::header_of(database);
  if (header.schema < first_schema_with_checksums || header.has_checksums) return;
  throw sql::Failure{messages::store_text<"header-damaged">(database.string()), sql::Trouble::damaged};
}

/// Builds the new database beside the old one (`from` may be the old file) and replaces the old one in the
/// last step. If the process is killed before, the store is unchanged; a store that could not be read has no
/// database until it is restored.
Replacement replace(const fs::path& store, const fs::path& from, const std::string& why, Losses losses,
                    OldDatabase was, const core::ProgressCallback& progress) {
  const fs::path beside = store / "rebuilding";
  Replacement replacement;
  replacement.lost = rebuild(from, beside, progress);
  if (losses == Losses::refused && !replacement.lost.empty()) {
    fs::remove_all(beside);
    throw sql::Failure{messages::store_text<"entry-lost">(in_words(replacement.lost.front()), from.string()),
                       sql::Trouble::damaged};
  }
  {
    auto db = sql::Connection::open(beside);
    bring_to_newest_schema(db);
  }
  sql::settle(sql::database_in(beside));
  const fs::path place = sql::database_in(store);
  mark_as_store(store);
  if (was == OldDatabase::unreadable) replacement.kept = sql::set_aside(place, why);
  const fs::path kept = sql::put_in_place(sql::database_in(beside), place, why);
  if (!kept.empty()) replacement.kept = kept;
  fs::remove_all(beside);
  return replacement;
}

}  // namespace

Replacement bring_up_to_date(const fs::path& store, const core::ProgressCallback& progress) {
  const auto alone = sql::StoreUse::alone(store);
  const fs::path database = sql::database_in(store);
  refuse_changed_header(database);
  sql::settle(database);
  const auto header = sql::header_of(database);
  refuse_newer_schema(header.schema);
  // another process has migrated it meanwhile
  if (header.schema == newest_schema() && header.has_checksums) return {};
  return replace(store, database, "schema-" + std::to_string(newest_schema()), Losses::refused,
                 OldDatabase::settled, progress);
}

Replacement repair_store(const fs::path& store, const core::ProgressCallback& progress) {
  const auto alone = sql::StoreUse::alone(store);
  const fs::path database = sql::database_in(store);
  refuse_changed_header(database);
  sql::settle(database);
  refuse_newer_schema(sql::header_of(database).schema);
  return replace(store, database, "repair", Losses::accepted, OldDatabase::settled, progress);
}

Replacement restore_store(const fs::path& store, const fs::path& backup,
                          const core::ProgressCallback& progress) {
  const auto header = sql::header_of(backup);
  const auto refuse = [&](const std::string& why) {
    return std::runtime_error{messages::store_text<"backup-refused">(backup.string(), why)};
  };
  if (!header.is_store) throw refuse("it is no store of Floeplan");
  refuse_newer_schema(header.schema);
  if (const std::string damage = sql::damage_of(backup); !damage.empty()) throw refuse(damage);
  fs::create_directories(store);
  const auto alone = sql::StoreUse::alone(store);
  const fs::path database = sql::database_in(store);
  const auto settle = [&] {
    refuse_changed_header(database);
    sql::settle(database);
  };
  const bool is_settled = fs::exists(database) && sql::meets_no_damage(settle);
  return replace(store, backup, "restore", Losses::refused,
                 is_settled ? OldDatabase::settled : OldDatabase::unreadable, progress);
}

}  // namespace floeplan::repository
