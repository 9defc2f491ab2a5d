#include "api/fields/request_fields.hpp"

/// Rows of the route: where and when it leads, by what, and which other routes are looked for.
namespace floeplan::fields {
namespace {

using planning::PlanRequest;

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
       .help = "File with the places to visit, instead of a goal and via points; without a start, its first "
               "place is "
               "the start"},
      route_name(),
  };
  return list;
}

const Table<PlanRequest>& order_fields() {
  static const Table<PlanRequest> table = in_group<PlanRequest>(
      group::places,
      {
          worded<PlanRequest>({.name = "via_order",
                               .flag = "best-order",
                               .flag_sets = "best",
                               .help = "Visit the via points in the given order (given), or in the order "
                                       "that reaches the goal earliest (best)"},
                              std::vector<Choice<bool>>{{{"given"}, false}, {{"best"}, true}},
                              [](auto& request) -> auto& { return request.via_in_best_order; }),
      });
  return table;
}

const Table<PlanRequest>& alternative_fields() {
  static const Table<PlanRequest> table{
      bound<PlanRequest>(
          {.name = "alternatives",
           .least = 0.0,
           .most = 3.0,
           .flag = "alternatives",
           .help = "Number of other routes to look for: round the other side of an island, a "
                   "bank, a group of icebergs or a closed area",
           .details = "Each is stored as a plan of its own. Obstacles count that are at least a "
                      "twentieth of the distance across, and routes that take at most twice the "
                      "time",
           .form = {"Alternatives", {}, "0"}},
          [](auto& request) -> auto& { return request.alternatives; }),
  };
  return table;
}

const std::vector<Field>& given_route_fields() {
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
       .help = "Start of a route from a file, longitude and latitude in degrees"},
  };
  return list;
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
