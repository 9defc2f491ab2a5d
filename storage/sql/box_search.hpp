#pragma once

#include <string>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// A box as texts of a statement: parameters or numbers.
struct BoxTexts {
  std::string west;
  std::string east;
  std::string south;
  std::string north;
};

/// A query for the column `row` of all boxes that intersect another box. It uses the index of the engine for
/// boxes. The table has the columns row, west_deg, east_deg, south_deg, north_deg.
[[nodiscard]] std::string rows_of_boxes_meeting(const Connection& db, const std::string& table,
                                                const BoxTexts& box);

}  // namespace floeplan::sql
