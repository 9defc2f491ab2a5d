#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "storage/sqlite/connection.hpp"
#include "storage/sqlite/failure.hpp"

namespace floeplan::repository {

/// What a user knows by an id or a name, with all rows that belong to it: a dataset with its grid and samples, a
/// simulation with its flights.
struct StoredThing {
  std::string kind;    // "dataset", "plan", ...
  std::string id;      // empty: what says it is damaged, too
  std::int64_t row{};  // in its table; of an unknown thing the first that it can be
};

/// How things of one kind are stored.
struct ThingTable {
  std::string_view table;
  std::string_view name;  // the column by which users know it, which has an index of its own
  std::string_view key;   // the column of other tables whose rows belong to it; empty: none do
  std::string_view kind;
};

inline constexpr ThingTable dataset_table{"dataset", "id", "dataset_row", "dataset"};
inline constexpr ThingTable plan_table{"plan", "id", "", "plan"};
inline constexpr ThingTable simulation_table{"simulation", "id", "simulation_row", "simulation"};
inline constexpr ThingTable job_table{"job", "id", "", "job"};
inline constexpr ThingTable token_table{"token", "name", "token_row", "token"};
inline constexpr ThingTable thing_tables[]{dataset_table, plan_table, simulation_table, job_table,
                                           token_table};

/// The things of one table in the order of their rows.
struct ThingList {
  std::vector<StoredThing> readable;  // in the table itself; what belongs to them was not looked at
  std::vector<StoredThing> damaged;   // in the table itself
};

/// How much of a row is read to tell whether it can be.
enum class RowReading { whole, number };

/// Reads past damaged pages as far as any page tells of a thing.
/// Parameters  schema   "main", or the name of an attached store
///             reading  `number`: long texts are not looked at, and a thing may be damaged that is said to be readable
/// Errors      sqlite::Failure when the store fails otherwise than by damage, or damage hides its schema
[[nodiscard]] ThingList things_in(sqlite::Connection& db, const std::string& schema, const ThingTable& table,
                                  RowReading reading = RowReading::whole);

/// Tells in a query on sqlite_schema, as t, tables that hold rows of ours: not those of SQLite, nor those in which an R*Tree
/// keeps itself, nor R*Trees.
inline const std::string ordinary_tables =
    "t.type = 'table' AND t.name NOT LIKE 'sqlite_%' AND t.sql NOT LIKE 'CREATE VIRTUAL TABLE%' AND "
    "t.name NOT LIKE '%\\_box\\__%' ESCAPE '\\'";

/// Tables with rows that belong to things of a table, by name. They are found by their column.
[[nodiscard]] std::vector<std::string> tables_below(sqlite::Connection& db, const std::string& schema,
                                                    const ThingTable& table);

/// Tables whose rows belong to no thing: the audit log, answers that are kept.
[[nodiscard]] std::vector<std::string> tables_beside(sqlite::Connection& db, const std::string& schema);

/// The rows of a table, by number, that can be read. Of WITHOUT ROWID tables there is no such list.
struct RowList {
  struct Gap {
    std::int64_t first{};
    std::int64_t last{};
  };
  std::vector<std::int64_t> readable;
  std::vector<Gap> gaps;  // where there are rows that cannot be read, and perhaps numbers that no row has
};
[[nodiscard]] RowList rows_of(sqlite::Connection& db, const std::string& schema, const std::string& table,
                              RowReading reading = RowReading::whole);

/// Whether `work` ends without meeting damage; other failures are thrown.
template <class Work>
[[nodiscard]] bool meets_no_damage(const Work& work) {
  try {
    work();
    return true;
  } catch (const sqlite::Failure& failure) {
    if (failure.trouble() != sqlite::Trouble::damaged) throw;
    return false;
  }
}

/// Does `work(" ")`, and where that meets damage `work(" NOT INDEXED ")`: what an index lists is not lost with it. The
/// text goes behind the name of a table in a query.
/// Returns  whether either went through
template <class Work>
[[nodiscard]] bool past_damaged_indices(const Work& work) {
  return meets_no_damage([&] { work(" "); }) || meets_no_damage([&] { work(" NOT INDEXED "); });
}

}  // namespace floeplan::repository
