#include "storage/repository/encoding/box_index.hpp"

#include <array>

#include "storage/sql/box_search.hpp"

namespace floeplan::repository {
namespace {

constexpr double slack_deg = 1e-4;  // some rounding steps of 32-bit numbers near 540
constexpr std::array turns_deg{-360.0, 0.0, 360.0};

}  // namespace

std::string box_condition(const sql::Connection& db, const std::string& box_table, int first_parameter) {
  const auto parameter = [&](int offset) { return "?" + std::to_string(first_parameter + offset); };
  std::string probes;
  for (int turn = 0; turn < std::ssize(turns_deg); ++turn) {
    if (turn > 0) probes += " UNION ALL ";
    probes += sql::rows_of_boxes_meeting(db, box_table,
                                         {.west = parameter(2 + 2 * turn),
                                          .east = parameter(3 + 2 * turn),
                                          .south = parameter(0),
                                          .north = parameter(1)});
  }
  return "row IN (" + probes + ")";
}

void bind_box(sql::Statement& statement, int first_parameter, const geo::BoundingBox& area) {
  statement.bind(first_parameter, area.south_deg - slack_deg);
  statement.bind(first_parameter + 1, area.north_deg + slack_deg);
  const UnrolledBox box = unrolled(area);
  int parameter = first_parameter + 2;
  for (const double turn : turns_deg) {
    statement.bind(parameter++, box.west_deg + turn - slack_deg);
    statement.bind(parameter++, box.east_deg + turn + slack_deg);
  }
}

UnrolledBox unrolled(const geo::BoundingBox& box) {
  const double west = geo::wrap_longitude(box.west_deg);
  return {west, west + geo::width_deg(box)};
}

void BoxInsert::run(std::int64_t row, const geo::BoundingBox& box) {
  const UnrolledBox width = unrolled(box);
  insert_.bind_all(row, width.west_deg, width.east_deg, box.south_deg, box.north_deg);
  insert_.run();
}

}  // namespace floeplan::repository
