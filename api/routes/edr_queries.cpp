#include <algorithm>

#include "api/codec/wkt.hpp"
#include "api/routes/edr_answer.hpp"
#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "engine/geo/geodesic.hpp"
#include "storage/sqlite/snapshot.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// One of `places`, all of which make up the answer.
tl::expected<json, Response> coverage_at(const EdrCollection& collection, const Context& context,
                                         const Request& request, const EdrRequest& query,
                                         const Wanted& wanted, const codec::WktPlace& at,
                                         std::size_t places) {
  const geo::BoundingBox box{at.place.lon_deg, at.place.lat_deg, at.place.lon_deg, at.place.lat_deg};
  const sqlite::Snapshot one_moment{context.db};
  const auto shape = find_edr_data(context.db, collection, box, wanted.span);
  if (!shape) return tl::unexpected(no_data(request));
  codec::CoverageGrid coverage = empty_coverage(collection, wanted);
  coverage.t = times_of(*shape, wanted.span);
  if (coverage.t.empty() != shape->times.empty()) return tl::unexpected(no_data(request));
  coverage.z_m = query.depths(*shape);
  if (at.z_m && !shape->depths_m.empty()) coverage.z_m = {*at.z_m};
  if (auto refusal = refuse_if_too_large(request, layers_of(coverage) * static_cast<double>(places)))
    return tl::unexpected(std::move(*refusal));
  coverage.x_deg = {at.place.lon_deg};
  coverage.y_deg = {at.place.lat_deg};
  const auto from = coverage.t.empty() ? core::UtcTime{} : coverage.t.front();
  const auto to = coverage.t.empty() ? core::UtcTime{} : coverage.t.back();
  const auto field = load_edr_field_at(context.db, *shape, at.place, from, to, coverage.z_m,
                                       context.service.current_blocks.get());
  fill(coverage, field.get(), collection, wanted, [](geo::LonLat) { return true; });
  return codec::coverage_json(coverage);
}

Response query_position(const EdrCollection& collection, const Context& context, const Request& request) {
  constexpr std::size_t most_positions = 100;
  EdrRequest query{collection, request};
  const auto coords = query.coords({codec::WktKind::point, codec::WktKind::multi_point},
                                   "POINT(lon lat) or MULTIPOINT, at most 100 places");
  const Wanted wanted = query.wanted();
  if (coords && coords->places.size() > most_positions) query.refuse("coords", "has more than 100 places");
  if (!query.violations().empty()) return invalid(request, query.violations());
  std::vector<json> coverages;
  for (const auto& place : coords->places) {
    auto coverage = coverage_at(collection, context, request, query, wanted, place, coords->places.size());
    if (!coverage) return coverage.error();
    coverages.push_back(std::move(*coverage));
  }
  if (coords->kind == codec::WktKind::point) return coverage_reply(request, coverages.front());
  return coverage_reply(request, codec::coverage_collection(std::move(coverages)));
}

/// Metres in the unit that was named; empty: it is not known.
std::optional<double> metres_in(const std::string& unit) {
  if (unit == "m" || unit == "metres" || unit == "meters") return 1.0;
  if (unit == "km" || unit == "kilometres" || unit == "kilometers") return 1000.0;
  if (unit == "nmi" || unit == "nautical_miles") return 1852.0;
  if (unit == "mi" || unit == "miles") return 1609.344;
  return std::nullopt;
}

Response query_radius(const EdrCollection& collection, const Context& context, const Request& request) {
  EdrRequest query{collection, request};
  const auto coords = query.coords({codec::WktKind::point}, "POINT(lon lat)");
  const Wanted wanted = query.wanted();
  query.reader().require("within", "the radius");
  const auto within = query.reader().number("within", 0.0, 2e7);
  const auto unit = metres_in(request.parameter("within-units").value_or("km"));
  if (!unit) query.refuse("within-units", "must be m, km, nmi or mi");
  if (!query.violations().empty()) return invalid(request, query.violations());
  const geo::LonLat centre = coords->places.front().place;
  const core::Metres radius{*within * *unit};
  const geo::BoundingBox box =
      geo::grown({centre.lon_deg, centre.lat_deg, centre.lon_deg, centre.lat_deg}, radius);
  return grid_reply(collection, context, request, query, wanted, box,
                    [=](geo::LonLat place) { return geo::geodesic_between(centre, place).length <= radius; });
}

Response query_area(const EdrCollection& collection, const Context& context, const Request& request) {
  EdrRequest query{collection, request};
  const auto coords = query.coords({codec::WktKind::polygon}, "POLYGON((lon lat, ...)) or MULTIPOLYGON");
  const Wanted wanted = query.wanted();
  if (!query.violations().empty()) return invalid(request, query.violations());
  std::vector<geo::LonLat> corners;
  for (const auto& area : coords->areas) corners.insert(corners.end(), area.outer.begin(), area.outer.end());
  return grid_reply(
      collection, context, request, query, wanted, geo::bounding_box(corners), [&](geo::LonLat place) {
        return std::ranges::any_of(coords->areas,
                                   [&](const geo::Polygon& area) { return geo::contains(area, place); });
      });
}

Response query_cube(const EdrCollection& collection, const Context& context, const Request& request) {
  EdrRequest query{collection, request};
  query.reader().require("bbox", "west,south,east,north in degrees");
  const auto box = query.reader().bbox();
  const Wanted wanted = query.wanted();
  if (!query.violations().empty()) return invalid(request, query.violations());
  return grid_reply(collection, context, request, query, wanted, *box, [](geo::LonLat) { return true; });
}

Response query_trajectory(const EdrCollection& collection, const Context& context, const Request& request) {
  EdrRequest query{collection, request};
  const auto coords = query.coords({codec::WktKind::line}, "LINESTRING(lon lat, ...), also with Z, M or ZM");
  Wanted wanted = query.wanted();
  if (!query.violations().empty()) return invalid(request, query.violations());
  std::vector<geo::LonLat> way;
  for (const auto& place : coords->places) {
    way.push_back(place.place);
    if (!place.time) continue;
    wanted.span.from = std::min(wanted.span.from.value_or(*place.time), *place.time);
    wanted.span.to = std::max(wanted.span.to.value_or(*place.time), *place.time);
  }
  const geo::BoundingBox box = geo::bounding_box(way);
  const sqlite::Snapshot one_moment{context.db};
  const auto shape = find_edr_data(context.db, collection, box, wanted.span);
  if (!shape) return no_data(request);
  const auto times = times_of(*shape, wanted.span);
  const auto depths = query.depths(*shape);
  const bool timed = !shape->times.empty();
  const bool layered = !shape->depths_m.empty();
  if (timed && times.empty() && !coords->places.front().time) return no_data(request);

  codec::CoverageTrajectory coverage;
  for (const std::size_t i : wanted.parameters) coverage.parameters.push_back(collection.parameters[i]);
  coverage.values.resize(wanted.parameters.size());
  for (const auto& at : coords->places) {
    codec::CoverageTrajectory::Place place{.place = at.place, .z_m = {}, .time = {}};
    if (timed) place.time = at.time ? *at.time : times.front();
    if (layered) place.z_m = at.z_m ? *at.z_m : depths.empty() ? shape->depths_m.front() : depths.front();
    coverage.places.push_back(place);
  }
  const auto from = timed ? *coverage.places.front().time : core::UtcTime{};
  std::vector<double> flown_m;
  for (const auto& place : coverage.places)
    if (place.z_m) flown_m.push_back(*place.z_m);
  const auto field = load_edr_field(context.db, *shape, box, wanted.span.from.value_or(from),
                                    wanted.span.to.value_or(from), flown_m);
  std::vector<std::optional<double>> sample(collection.parameters.size());
  for (const auto& place : coverage.places) {
    std::ranges::fill(sample, std::nullopt);
    if (field)
      field->sample(place.place, core::Metres{place.z_m.value_or(0.0)}, place.time.value_or(core::UtcTime{}),
                    sample);
    for (std::size_t i = 0; i < wanted.parameters.size(); ++i)
      coverage.values[i].push_back(sample[wanted.parameters[i]]);
  }
  return coverage_reply(request, codec::coverage_json(coverage));
}

}  // namespace

std::vector<Route> edr_query_routes() {
  using Query = Response (*)(const EdrCollection&, const Context&, const Request&);
  struct Known {
    const char* name;
    Query answer;
    std::vector<std::string> parameters;
  };
  const std::vector<Known> queries{
      {"position", query_position, {"coords"}},
      {"radius", query_radius, {"coords", "within", "within-units", "resolution-x", "resolution-y"}},
      {"area", query_area, {"coords", "resolution-x", "resolution-y"}},
      {"cube", query_cube, {"bbox", "resolution-x", "resolution-y"}},
      {"trajectory", query_trajectory, {"coords"}}};
  std::vector<Route> routes;
  for (const EdrCollection& collection : edr_collections()) {
    for (const Known& query : queries) {
      auto parameters = query.parameters;
      for (const char* name : {"z", "datetime", "parameter-name", "parameter_names", "crs"})
        parameters.emplace_back(name);
      routes.push_back({"GET", "/edr/collections/" + collection.id + "/" + query.name, std::move(parameters),
                        [&collection, answer = query.answer](const Context& context, const Request& request,
                                                             const PathParameters&) {
                          return answer(collection, context, request);
                        }});
    }
  }
  return routes;
}

}  // namespace floeplan::routes
