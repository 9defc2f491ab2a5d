#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "storage/sql/salvage.hpp"

namespace floeplan::repository {

/// An object that users know by an id or a name, with all rows that belong to it: a dataset with its grid and
/// samples, a simulation with its flights.
struct StoredThing {
  std::string kind;    // "dataset", "plan", ...
  std::string id;      // empty: the id itself is damaged
  std::int64_t row{};  // row in its table; if unknown, the first row that it can have
};

/// The table and columns in which objects of one kind are stored.
struct ThingTable {
  std::string_view table;
  std::string_view name;  // column with the id or name that users know; it has its own index
  std::string_view key;   // column of other tables that refers to it; empty: none
  std::string_view kind;
};

inline constexpr ThingTable dataset_table{"dataset", "id", "dataset_row", "dataset"};
inline constexpr ThingTable plan_table{"plan", "id", "", "plan"};
inline constexpr ThingTable simulation_table{"simulation", "id", "simulation_row", "simulation"};
inline constexpr ThingTable job_table{"job", "id", "", "job"};
inline constexpr ThingTable token_table{"token", "name", "token_row", "token"};
inline constexpr ThingTable thing_tables[]{dataset_table, plan_table, simulation_table, job_table,
                                           token_table};

/// The objects of one table, in the order of their rows.
struct ThingList {
  // readable in the table itself; their rows in other tables were not checked
  std::vector<StoredThing> readable;
  std::vector<StoredThing> damaged;  // damaged in the table itself
};

/// Lists the objects of a table, also after damaged pages, as far as the pages show them.
/// Parameters  schema   "main", or the name of an attached store reading  `number`: long texts are not read,
///             so an object listed as readable may be damaged
/// Errors      sql::Failure when the store fails for another reason than damage, or the schema is unreadable
[[nodiscard]] ThingList things_in(sql::Connection& db, const std::string& schema, const ThingTable& table,
                                  sql::RowReading reading = sql::RowReading::whole);

/// Tables whose rows refer to objects of this table, sorted by name. They are found by their column.
[[nodiscard]] std::vector<std::string> tables_below(sql::Connection& db, const std::string& schema,
                                                    const ThingTable& table);

/// Tables whose rows belong to no object: the audit log, kept answers.
[[nodiscard]] std::vector<std::string> tables_beside(sql::Connection& db, const std::string& schema);

}  // namespace floeplan::repository
