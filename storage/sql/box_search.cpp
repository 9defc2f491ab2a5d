#include "storage/sql/box_search.hpp"

namespace floeplan::sql {

std::string rows_of_boxes_meeting(const Connection& db, const std::string& table, const BoxTexts& box) {
  const std::string rows = "SELECT row FROM " + table + " WHERE ";
  if (db.engine() == Engine::server)
    return rows + "box(point(west_deg, south_deg), point(east_deg, north_deg)) && box(point(" + box.west +
           ", " + box.south + "), point(" + box.east + ", " + box.north + "))";
  return rows + "north_deg >= " + box.south + " AND south_deg <= " + box.north +
         " AND east_deg >= " + box.west + " AND west_deg <= " + box.east;
}

}  // namespace floeplan::sql
