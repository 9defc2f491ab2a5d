#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "storage/sql/salvage.hpp"

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

/// Reads past damaged pages as far as any page tells of a thing.
/// Parameters  schema   "main", or the name of an attached store
///             reading  `number`: long texts are not looked at, and a thing may be damaged that is said to be readable
/// Errors      sql::Failure when the store fails otherwise than by damage, or damage hides its schema
[[nodiscard]] ThingList things_in(sql::Connection& db, const std::string& schema, const ThingTable& table,
                                  sql::RowReading reading = sql::RowReading::whole);

/// Tables with rows that belong to things of a table, by name. They are found by their column.
[[nodiscard]] std::vector<std::string> tables_below(sql::Connection& db, const std::string& schema,
                                                    const ThingTable& table);

/// Tables whose rows belong to no thing: the audit log, answers that are kept.
[[nodiscard]] std::vector<std::string> tables_beside(sql::Connection& db, const std::string& schema);

}  // namespace floeplan::repository
