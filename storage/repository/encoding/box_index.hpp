#pragma once

#include <string>

#include "engine/geo/bounding_box.hpp"
#include "storage/sql/statement.hpp"

namespace floeplan::repository {

/// Number of parameters in `box_condition`.
inline constexpr int box_parameters = 8;

/// SQL condition on `row`: the rows of a table of boxes whose box comes near the area. It may hold for rows that just miss
/// the area (an index of boxes may keep 32-bit numbers), so the caller checks each exactly.
[[nodiscard]] std::string box_condition(const sql::Connection& db, const std::string& box_table,
                                        int first_parameter);
void bind_box(sql::Statement& statement, int first_parameter, const geo::BoundingBox& area);

/// The box as the table of boxes keeps it: eastwards from [-180, 180).
struct UnrolledBox {
  double west_deg{};
  double east_deg{};  // not less than west, so up to 540 degrees
};

[[nodiscard]] UnrolledBox unrolled(const geo::BoundingBox& box);

/// Writes boxes of rows into a table of boxes. Prepared once, for many rows.
class BoxInsert {
 public:
  BoxInsert(sql::Connection& db, const std::string& box_table)
      : insert_{db, "INSERT INTO " + box_table + " VALUES (?1, ?2, ?3, ?4, ?5)"} {}

  void run(std::int64_t row, const geo::BoundingBox& box);

 private:
  sql::Statement insert_;
};

}  // namespace floeplan::repository
