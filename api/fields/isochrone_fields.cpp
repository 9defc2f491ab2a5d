#include "api/fields/request_fields.hpp"

/// Rows of what can be reached from a place, or of where to leave for it.
namespace floeplan::fields {
namespace {

using planning::IsochroneRequest;

constexpr double least_step_m = 10.0;
constexpr double most_step_m = 100'000.0;

}  // namespace

const std::vector<Field>& isochrone_fields() {
  static const std::vector<Field> list{
      {.name = "from",
       .kind = Kind::place,
       .flag = "from",
       .help = "Start of the vehicle, longitude and latitude in degrees; or give a goal"},
      {.name = "to",
       .kind = Kind::place,
       .flag = "to",
       .help = "Goal to reach by the latest arrival, longitude and latitude in degrees"},
      {.name = "arrive_by", .kind = Kind::time, .flag = "arrive-by", .help = "Latest arrival at the goal"},
      {.name = "hours",
       .flag = "hours",
       .help =
           "Hours after the departure, or before the arrival; one number or several, for example 6,12,24"},
  };
  return list;
}

const Table<IsochroneRequest>& isochrone_grid_fields() {
  static const Table<IsochroneRequest> table = in_group<IsochroneRequest>(
      group::search,
      {
          bound<IsochroneRequest>({.name = "spacing_m",
                                   .unit = "m",
                                   .least = least_step_m,
                                   .most = most_step_m,
                                   .flag = "spacing",
                                   .help = "Spacing of the grid (default: a hundredth of the distance flown "
                                           "in still water, 100 m to 5 km)"},
                                  [](auto& request) -> auto& { return request.spacing; }),
          bound<IsochroneRequest>({.name = "sectors",
                                   .least = 1.0,
                                   .most = 5.0,
                                   .flag = "sectors",
                                   .help = "Neighbourhood of the grid, in sectors (default: 3, or 5 where "
                                           "currents are as fast as the vehicle)"},
                                  [](auto& request) -> auto& { return request.sectors; }),
      });
  return table;
}

}  // namespace floeplan::fields
