#include <algorithm>

#include "api/codec/bytes/wkt.hpp"
#include "api/routes/edr/edr_answer.hpp"
#include "api/routes/edr/edr_grid.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "engine/geo/bounding_box.hpp"
#include "storage/sql/snapshot.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// The coverage at one place. `places` is the number of places, because all their coverages together are
/// limited in size.
tl::expected<json, Response> coverage_at(const EdrCollection& collection, const Context& context,
                                         const Request& request, const EdrRequest& query,
                                         const Wanted& wanted, const codec::WktPlace& at,
                                         std::size_t places) {
  const geo::BoundingBox box{at.place.lon_deg, at.place.lat_deg, at.place.lon_deg, at.place.lat_deg};
  const auto ask = [&](const EdrShape& shape) -> tl::expected<EdrAttempt, Response> {
    auto coverage = planned_coverage(collection, shape, query, wanted, at.z_m);
    if (!coverage) return EdrAttempt{.why = coverage.error()};
    if (auto refusal = refuse_if_too_large(request, layers_of(*coverage) * static_cast<double>(places)))
      return tl::unexpected(std::move(*refusal));
    const auto from = coverage->t.empty() ? core::UtcTime{} : coverage->t.front();
    const auto to = coverage->t.empty() ? core::UtcTime{} : coverage->t.back();
    const auto field = load_edr_field_at(context.db, shape, at.place, from, to, coverage->z_m,
                                         context.service.current_blocks.get());
    if (!field || !field->grid().locate(at.place)) return EdrAttempt{};
    coverage->x_deg = {at.place.lon_deg};
    coverage->y_deg = {at.place.lat_deg};
    fill(*coverage, *field, collection, wanted, {true});
    return EdrAttempt{.coverage = std::move(*coverage), .is_inside = {true}, .is_conclusive = true};
  };
  const sql::Snapshot one_moment{context.db};
  const auto coverage = first_with_values(context.db, request, collection, wanted, box, ask);
  if (!coverage) return tl::unexpected(coverage.error());
  return codec::coverage_json(*coverage);
}

Response query_position(const EdrCollection& collection, const Context& context, const Request& request) {
  constexpr std::size_t most_positions = 100;
  EdrRequest query{collection, request};
  const auto coords = query.coords({codec::WktKind::point, codec::WktKind::multi_point},
                                   "POINT(lon lat) or MULTIPOINT, at most 100 places");
  const Wanted wanted = query.wanted();
  if (coords && coords->places.size() > most_positions)
    query.refuse<"too-many-places-of-query">("coords", most_positions);
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

/// Metres in a unit; empty if the unit is unknown.
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
  if (!unit) query.refuse<"wrong-shape">("within-units", "m, km, nmi or mi");
  if (!query.violations().empty()) return invalid(request, query.violations());
  if (const auto z_m = coords->places.front().z_m) query.take_depth(*z_m);
  return grid_reply(collection, context, request, query, wanted,
                    area_of_disc(coords->places.front().place, core::Metres{*within * *unit}));
}

Response query_area(const EdrCollection& collection, const Context& context, const Request& request) {
  EdrRequest query{collection, request};
  const auto coords = query.coords({codec::WktKind::polygon}, "POLYGON((lon lat, ...)) or MULTIPOLYGON");
  const Wanted wanted = query.wanted();
  const EdrArea area = coords ? area_of_polygons(coords->areas) : EdrArea{};
  if (coords && area.middles.empty()) query.refuse<"encloses-no-area">("coords");
  if (coords && coords->has_z) query.refuse<"area-with-depths">("coords");
  if (!query.violations().empty()) return invalid(request, query.violations());
  return grid_reply(collection, context, request, query, wanted, area);
}

Response query_cube(const EdrCollection& collection, const Context& context, const Request& request) {
  EdrRequest query{collection, request};
  const auto box = query.box();
  const Wanted wanted = query.wanted();
  if (!query.violations().empty()) return invalid(request, query.violations());
  return grid_reply(collection, context, request, query, wanted, area_of_box(*box));
}

/// The trajectory as one dataset can answer it: its places get a time and a depth, if the data have these.
/// nullopt: the dataset has no step in the period.
std::optional<codec::CoverageTrajectory> planned_trajectory(const EdrCollection& collection,
                                                            const EdrShape& shape, const EdrRequest& query,
                                                            const Wanted& wanted,
                                                            const std::vector<codec::WktPlace>& way) {
  const auto times = times_of(shape, wanted.span);
  const auto depths = query.depths(shape);
  const bool timed = !shape.times.empty();
  const bool layered = !shape.depths_m.empty();
  if (timed && times.empty() && !way.front().time) return std::nullopt;
  codec::CoverageTrajectory coverage;
  for (const std::size_t i : wanted.parameters) coverage.parameters.push_back(collection.parameters[i]);
  coverage.values.assign(wanted.parameters.size(),
                         std::vector<std::optional<double>>(way.size(), std::nullopt));
  for (const auto& at : way) {
    codec::CoverageTrajectory::Place place{.place = at.place, .z_m = {}, .time = {}};
    if (timed) place.time = at.time ? *at.time : times.front();
    if (layered) place.z_m = at.z_m ? *at.z_m : depths.front();  // a depth was requested, or the default
    coverage.places.push_back(place);
  }
  return coverage;
}

/// Adds a dataset that answers places of a trajectory.
void add_source(codec::CoverageSource& source, const repository::Dataset& dataset) {
  if (source.dataset_id.empty()) {
    source.dataset_id = dataset.id.value;
    source.dataset_name = dataset.name;
  } else {
    source.further_ids.push_back(dataset.id.value);
  }
}

/// Samples a dataset at the places that have no value yet. Returns true if all have one afterwards.
bool fill_gaps(codec::CoverageTrajectory& coverage, std::vector<bool>& is_known, const Context& context,
               const EdrCollection& collection, const EdrShape& shape, const Wanted& wanted) {
  std::vector<geo::LonLat> places;
  std::vector<double> depths_m;
  std::optional<core::UtcTime> from;
  std::optional<core::UtcTime> to;
  for (std::size_t i = 0; i < coverage.places.size(); ++i) {
    if (is_known[i]) continue;
    const auto& at = coverage.places[i];
    places.push_back(at.place);
    if (at.z_m) depths_m.push_back(*at.z_m);
    const auto time = at.time.value_or(core::UtcTime{});
    from = std::min(from.value_or(time), time);
    to = std::max(to.value_or(time), time);
  }
  if (places.empty()) return true;
  const auto field = load_edr_field(context.db, shape, geo::bounding_box(places), *from, *to, depths_m);
  if (!field) return false;
  std::vector<std::optional<double>> sample(collection.parameters.size());
  bool all = true;
  bool any = false;
  for (std::size_t i = 0; i < coverage.places.size(); ++i) {
    if (is_known[i]) continue;
    const auto& at = coverage.places[i];
    std::ranges::fill(sample, std::nullopt);
    field->sample(at.place, core::Metres{at.z_m.value_or(0.0)}, at.time.value_or(core::UtcTime{}), sample);
    is_known[i] = std::ranges::any_of(sample, [](const auto& value) { return value.has_value(); });
    all = all && is_known[i];
    any = any || is_known[i];
    for (std::size_t k = 0; k < wanted.parameters.size(); ++k)
      coverage.values[k][i] = sample[wanted.parameters[k]];
  }
  if (any) add_source(coverage.source, shape.dataset);
  return all;
}

Response query_trajectory(const EdrCollection& collection, const Context& context, const Request& request) {
  EdrRequest query{collection, request};
  const auto coords = query.coords({codec::WktKind::line}, "LINESTRING(lon lat, ...), also with Z, M or ZM");
  Wanted wanted = query.wanted();
  query.want_one_depth();
  if (!query.violations().empty()) return invalid(request, query.violations());
  std::vector<geo::LonLat> way;
  for (const auto& place : coords->places) {
    way.push_back(place.place);
    if (!place.time) continue;
    wanted.span.from = std::min(wanted.span.from.value_or(*place.time), *place.time);
    wanted.span.to = std::max(wanted.span.to.value_or(*place.time), *place.time);
  }
  const sql::Snapshot one_moment{context.db};
  std::optional<codec::CoverageTrajectory> coverage;
  std::vector<bool> is_known(way.size(), false);
  AskedGrids asked;
  for (const auto& dataset : edr_datasets(context.db, collection, geo::bounding_box(way), wanted.span)) {
    const auto shape = edr_shape(context.db, dataset);
    if (!shape || !asked.take(shape->grid)) continue;
    if (!coverage) coverage = planned_trajectory(collection, *shape, query, wanted, coords->places);
    if (coverage && fill_gaps(*coverage, is_known, context, collection, *shape, wanted)) break;
  }
  if (!coverage) return no_data(request);
  return coverage_reply(request, codec::coverage_json(*coverage));
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
      routes.back().gives_coverages = true;
    }
  }
  return routes;
}

}  // namespace floeplan::routes
