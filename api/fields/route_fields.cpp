#include "api/fields/request_fields.hpp"

/// Rows of where and when a vehicle is to go.
namespace floeplan::fields {
namespace {

using planning::IsochroneRequest;
using planning::PlanRequest;

constexpr double least_step_m = 10.0;
constexpr double most_step_m = 100'000.0;
constexpr std::string_view seen_from_route =
    "Route to use of GeoJSON or a file with several: its name, or its number from 1";

Field route_name() {
  return {.name = "route_name",
          .kind = Kind::text,
          .flag = "route",
          .help = seen_from_route,
          .form = {"Route in the file", {}, "the only one"}};
}

}  // namespace

const std::vector<Field>& way_fields() {
  static const std::vector<Field> list{
      {.name = "from",
       .kind = Kind::place,
       .flag = "from",
       .help = "Start, longitude and latitude in degrees",
       .details = "A third number, the height, is ignored",
       .form = {"Start", {}, "69°10.2′N 51°21.0′W"}},
      {.name = "to",
       .kind = Kind::place,
       .flag = "to",
       .help = "Goal, longitude and latitude in degrees",
       .form = {"Goal"}},
      {.name = "via",
       .kind = Kind::places,
       .flag = "via",
       .group = group::places,
       .help = "Via points, in this order",
       .form = {"Via points"}},
      {.name = "goals_file",
       .flag = "goals",
       .help = "File with the places to visit, instead of via and to; without from, its first place is the "
               "start"},
      route_name(),
  };
  return list;
}

const Table<PlanRequest>& order_fields() {
  static const Table<PlanRequest> table = in_group<PlanRequest>(
      group::places,
      {
          worded<PlanRequest>(
              {.name = "via_order",
               .flag = "best-order",
               .flag_sets = "best",
               .help =
                   "Visit the via points in the given order, or in the order that reaches the goal earliest"},
              std::vector<Choice<bool>>{{{"given"}, false}, {{"best"}, true}},
              [](auto& request) -> auto& { return request.via_in_best_order; }),
      });
  return table;
}

const std::vector<Field>& route_fields() {
  static const std::vector<Field> list{
      {.name = "route",
       .help = "The route: GeoJSON (a line, also one cut at the antimeridian, a Feature, a "
               "FeatureCollection, the "
               "legs of a plan) or an array of positions; or give plan_id"},
      {.name = "plan_id", .kind = Kind::text, .help = "Stored plan with the route"},
      {.name = "route_file", .help = "File with the route, instead of route or plan_id"},
      route_name(),
      {.name = "from",
       .kind = Kind::place,
       .flag = "from",
       .help = "Start of a route from a file, [longitude, latitude] in degrees"},
  };
  return list;
}

const std::vector<Field>& isochrone_fields() {
  static const std::vector<Field> list{
      {.name = "from",
       .kind = Kind::place,
       .flag = "from",
       .help = "Start of the vehicle at depart, [longitude, latitude] in degrees; or give to"},
      {.name = "to",
       .kind = Kind::place,
       .flag = "to",
       .help = "Goal to reach by arrive_by, [longitude, latitude] in degrees"},
      {.name = "arrive_by", .kind = Kind::time, .flag = "arrive-by", .help = "Latest arrival, with to"},
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

const std::vector<Field>& departure_fields() {
  static const std::vector<Field> list{
      {.name = "depart",
       .kind = Kind::time,
       .flag = "depart",
       .help = "Departure, ISO 8601 with its zone, for example 2026-11-20T06:00:00Z",
       .details = "Required unless arrive_by is given",
       .form = {"Departure", "UTC", "2026-11-20 06:00"}},
  };
  return list;
}

const std::vector<Field>& window_fields() {
  static const std::vector<Field> list{
      {.name = "depart_until",
       .kind = Kind::time,
       .flag = "depart-until",
       .group = group::window,
       .help = "Last departure of a window that begins at the given departure; the best departure is planned",
       .form = {"Latest departure", "UTC", "one departure only"}},
      {.name = "depart_step",
       .kind = Kind::duration,
       .flag = "depart-step",
       .group = group::window,
       .help = "Time between departures of the window, ISO 8601; default PT1H",
       .example = "PT1H",
       .form = {"Every", "h"}},
      {.name = "arrive_by",
       .kind = Kind::time,
       .flag = "arrive-by",
       .group = group::window,
       .help = "Latest arrival: the plan leaves as late as possible, but not before the given departure",
       .form = {"Latest arrival", "UTC", "any", "The plan leaves as late as possible and arrives in time."}},
  };
  return list;
}

const std::vector<Field>& area_fields() {
  static const std::vector<Field> list{
      {.name = "areas",
       .flag = "areas",
       .group = group::places,
       .help = "Areas to keep out of or to stay in: GeoJSON polygons with the properties kind (no_go, "
               "stay_in), from, "
               "until, top_m, bottom_m"},
  };
  return list;
}

const std::vector<Field>& name_fields() {
  static const std::vector<Field> list{
      {.name = "name",
       .kind = Kind::text,
       .flag = "name",
       .group = group::search,
       .help = "Name of the result",
       .form = {"Name of the plan", {}, "optional"}},
  };
  return list;
}

const std::vector<Field>& remark_fields() {
  static const std::vector<Field> list{
      {.name = "remarks",
       .help = "Sentences to add to the warnings of the answer, for example of a program that read the "
               "places from a file"},
  };
  return list;
}

}  // namespace floeplan::fields
