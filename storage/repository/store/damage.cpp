#include "storage/repository/store/damage.hpp"

#include "storage/repository/encoding/blob_codec.hpp"
#include "storage/repository/store/dataset_tables.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/upkeep.hpp"

namespace floeplan::repository {
namespace {

constexpr const char* samples_table = "field_chunk";

/// Reads all rows that belong to a StoredThing, and verifies the checksums of samples. Returns whether all are
/// undamaged.
bool is_whole_below(sql::Connection& db, const ThingTable& table, std::int64_t row, BlobCodec& codec) {
  for (const std::string& below : tables_below(db, "main", table)) {
    const bool whole = sql::past_damaged_indices([&](const char* index) {
      const std::string columns = below == samples_table ? "samples" : "*";
      sql::Statement rows{db, "SELECT " + columns + " FROM main." + below + index + "WHERE " +
                                  std::string{table.key} + " = ?1"};
      rows.bind(1, row);
      while (rows.step())
        if (below == samples_table) codec.check(rows.blob(0));
    });
    if (!whole) return false;
    const std::string boxes = boxes_of(below);
    const bool boxes_whole = !sql::has_table(db, boxes) || sql::meets_no_damage([&] {
      sql::Statement rows{db, "SELECT * FROM main." + boxes + " WHERE row IN (SELECT row FROM main." + below +
                                  " WHERE " + std::string{table.key} + " = ?1)"};
      rows.bind(1, row);
      while (rows.step()) continue;
    });
    if (!boxes_whole) return false;
  }
  return true;
}

}  // namespace

Damage find_damage(sql::Connection& db, const core::ProgressCallback& progress) {
  Damage damage;
  if (progress) progress("reading every page", 0.0);
  damage.pages = sql::damaged_pages(db);
  BlobCodec codec;
  for (const ThingTable& table : thing_tables) {
    ThingList list = things_in(db, "main", table);
    damage.things.insert(damage.things.end(), list.damaged.begin(), list.damaged.end());
    for (std::size_t i = 0; i < list.readable.size(); ++i) {
      if (progress)
        progress("reading every " + std::string{table.kind},
                 static_cast<double>(i) / static_cast<double>(list.readable.size()));
      if (!is_whole_below(db, table, list.readable[i].row, codec)) damage.things.push_back(list.readable[i]);
    }
  }
  for (const std::string& table : tables_beside(db, "main")) {
    const bool whole = sql::meets_no_damage([&] {
      sql::Statement rows{db, "SELECT * FROM main." + table};
      while (rows.step()) continue;
    });
    if (!whole) damage.tables.push_back(table);
  }
  if (damage.pages.empty()) damage.structure = sql::damage_of_structure(db);
  return damage;
}

}  // namespace floeplan::repository
