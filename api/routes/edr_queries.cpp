#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>

#include "api/codec/wkt.hpp"
#include "api/routes/edr_field.hpp"
#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "engine/geo/geodesic.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr double most_values = 4e6;   // of an answer: about 30 MB of JSON
constexpr double usual_values = 5e5;  // that an answer has at most when nobody asks for a resolution
constexpr double metres_per_degree = 111'195.0;  // of latitude, mean of the WGS84 sphere of equal volume
constexpr std::size_t most_levels = 1000;

/// What every query asks besides its place.
struct Wanted {
  TimeSpan span;
  std::vector<double> depths_m;         // empty: all that there are
  std::vector<std::size_t> parameters;  // indices
};

std::optional<double> to_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
  return whole ? std::optional{value} : std::nullopt;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// "R4/0/50": four levels from 0 on, 50 apart; "0/200": the levels of the data in between; "0,50,100"; "0".
struct Levels {
  std::vector<double> values;
  std::optional<std::pair<double, double>> between;
};

std::optional<Levels> parse_z(const std::string& text) {
  const auto parts = split(text, '/');
  std::vector<std::optional<double>> numbers;
  for (const auto& part : parts.size() > 1 ? parts : split(text, ',')) numbers.push_back(to_number(part));
  Levels levels;
  if (parts.size() == 3 && parts[0].starts_with('R')) {
    const auto count = to_number(parts[0].substr(1));
    if (!count || *count < 1.0 || *count > most_levels || !numbers[1] || !numbers[2]) return std::nullopt;
    for (int i = 0; i < static_cast<int>(*count); ++i) levels.values.push_back(*numbers[1] + i * *numbers[2]);
    return levels;
  }
  if (std::any_of(numbers.begin(), numbers.end(), [](const auto& number) { return !number; }))
    return std::nullopt;
  if (parts.size() == 2) {
    levels.between = {std::min(*numbers[0], *numbers[1]), std::max(*numbers[0], *numbers[1])};
  } else if (parts.size() == 1 && numbers.size() <= most_levels) {
    for (const auto& number : numbers) levels.values.push_back(*number);
  } else {
    return std::nullopt;
  }
  return levels;
}

bool is_known_crs(const std::string& crs) {
  constexpr std::array known{"CRS84", "CRS:84", "OGC:CRS84", "EPSG:4326",
                             "http://www.opengis.net/def/crs/OGC/1.3/CRS84"};
  return std::find(known.begin(), known.end(), crs) != known.end();
}

/// A query with what is wrong with it.
class EdrRequest {
 public:
  EdrRequest(const EdrCollection& collection, const Request& request)
      : collection_{collection}, request_{request}, reader_{request} {}

  [[nodiscard]] ParameterReader& reader() { return reader_; }
  void refuse(const std::string& name, const std::string& rule) {
    violations_.push_back({"?" + name, "the query parameter \"" + name + "\" " + rule});
  }
  [[nodiscard]] core::Violations violations() const {
    core::Violations all = reader_.violations();
    all.insert(all.end(), violations_.begin(), violations_.end());
    return all;
  }

  std::optional<codec::WktGeometry> coords(std::initializer_list<codec::WktKind> kinds,
                                           const std::string& rule) {
    const auto text = request_.parameter("coords");
    auto geometry = text ? codec::parse_wkt(*text) : std::nullopt;
    if (geometry && std::find(kinds.begin(), kinds.end(), geometry->kind) != kinds.end()) return geometry;
    refuse("coords", "is required: " + rule + ", longitude first");
    return std::nullopt;
  }

  Wanted wanted() {
    Wanted result;
    result.span = reader_.datetime();
    result.parameters = parameters();
    if (const auto crs = request_.parameter("crs"); crs && !is_known_crs(*crs))
      refuse("crs", "must be CRS84, its URI or EPSG:4326; coordinates are longitude first");
    if (const auto z = request_.parameter("z")) {
      levels_ = parse_z(*z);
      if (!levels_) refuse("z", "must be metres below the surface: one, several, from/to or Rn/first/step");
    }
    return result;
  }
  /// The depths to ask the data at; one without meaning where they have none.
  [[nodiscard]] std::vector<double> depths(const EdrShape& shape) const {
    if (shape.depths_m.empty() || !levels_) return shape.depths_m;
    if (!levels_->between) return levels_->values;
    std::vector<double> inside;
    for (const double depth : shape.depths_m) {
      if (depth >= levels_->between->first && depth <= levels_->between->second) inside.push_back(depth);
    }
    return inside;
  }

 private:
  std::vector<std::size_t> parameters() {
    std::vector<std::size_t> chosen;
    const auto text = request_.parameter("parameter-name") ? request_.parameter("parameter-name")
                                                           : request_.parameter("parameter_names");
    for (std::size_t i = 0; i < collection_.parameters.size(); ++i)
      if (!text) chosen.push_back(i);
    if (!text) return chosen;
    for (const auto& name : split(*text, ',')) {
      const auto found = std::ranges::find(collection_.parameters, name, &codec::CoverageParameter::id);
      if (found == collection_.parameters.end()) {
        refuse("parameter-name", "must name parameters of the collection, not " + name);
      } else {
        chosen.push_back(static_cast<std::size_t>(found - collection_.parameters.begin()));
      }
    }
    return chosen;
  }

  const EdrCollection& collection_;  // borrowed
  const Request& request_;           // borrowed
  ParameterReader reader_;
  core::Violations violations_;
  std::optional<Levels> levels_;
};

/// The moments to ask the data at: the one that was named, or the steps of the data in the period.
std::vector<core::UtcTime> times_of(const EdrShape& shape, const TimeSpan& span) {
  if (shape.times.empty()) return {};
  if (span.from && span.to && *span.from == *span.to) return {*span.from};
  std::vector<core::UtcTime> times;
  for (const auto time : shape.times) {
    if ((!span.from || time >= *span.from) && (!span.to || time <= *span.to)) times.push_back(time);
  }
  return times;
}

Response coverage_reply(const Request& request, const json& coverage) {
  const bool older = request.header("accept").find("application/prs.coverage+json") != std::string::npos;
  return json_reply(coverage, 200, older ? "application/prs.coverage+json" : "application/vnd.cov+json");
}

Response no_data(const Request& request) {
  return not_found(request, "no-data", "No data of this collection cover this place and time.");
}

Response too_large(const Request& request, double values) {
  return problem_reply(request, {413,
                                 "too-many-values",
                                 "Too many values",
                                 "The answer would have " + std::to_string(std::llround(values)) +
                                     " values, more than " + std::to_string(std::llround(most_values)) +
                                     "; ask for less time, fewer depths or a coarser resolution.",
                                 {}});
}

codec::CoverageGrid empty_coverage(const EdrCollection& collection, const Wanted& wanted) {
  codec::CoverageGrid coverage;
  for (const std::size_t i : wanted.parameters) coverage.parameters.push_back(collection.parameters[i]);
  coverage.values.resize(wanted.parameters.size());
  return coverage;
}

/// Asks the field at every node of the coverage that is wanted; the others stay empty.
void fill(codec::CoverageGrid& coverage, const EdrField* field, const EdrCollection& collection,
          const Wanted& wanted, const std::function<bool(geo::LonLat)>& is_inside) {
  const std::vector<core::UtcTime> times = coverage.t.empty() ? std::vector{core::UtcTime{}} : coverage.t;
  const std::vector<double> depths = coverage.z_m.empty() ? std::vector{0.0} : coverage.z_m;
  std::vector<std::optional<double>> sample(collection.parameters.size());
  for (const auto time : times) {
    for (const double depth : depths) {
      for (const double lat : coverage.y_deg) {
        for (const double lon : coverage.x_deg) {
          std::ranges::fill(sample, std::nullopt);
          const geo::LonLat place{geo::wrap_longitude(lon), lat};
          if (field != nullptr && is_inside(place)) field->sample(place, core::Metres{depth}, time, sample);
          for (std::size_t i = 0; i < wanted.parameters.size(); ++i)
            coverage.values[i].push_back(sample[wanted.parameters[i]]);
        }
      }
    }
  }
}

/// Evenly spaced, both ends included.
std::vector<double> spread(double from, double to, std::size_t count) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.5;
    nodes.push_back(from + share * (to - from));
  }
  return nodes;
}

/// How many nodes a side has: as many as were asked for, else as many as the data have, or fewer where the answer
/// would become long.
std::size_t nodes_of_side(std::optional<double> asked, double length_m, core::Metres spacing,
                          double most_usual) {
  if (asked) return static_cast<std::size_t>(*asked);
  return static_cast<std::size_t>(std::clamp(std::floor(length_m / spacing.value) + 1.0, 2.0, most_usual));
}

/// A grid over a box, empty where `is_inside` is false.
Response grid_reply(const EdrCollection& collection, const Context& context, const Request& request,
                    EdrRequest& query, const Wanted& wanted, const geo::BoundingBox& box,
                    const std::function<bool(geo::LonLat)>& is_inside) {
  constexpr double most_nodes = 2000.0;
  const auto columns = query.reader().number("resolution-x", 1.0, most_nodes);
  const auto rows = query.reader().number("resolution-y", 1.0, most_nodes);
  if (!query.violations().empty()) return invalid(request, query.violations());
  const auto shape = find_edr_data(context.db, collection, box, wanted.span);
  if (!shape) return no_data(request);

  codec::CoverageGrid coverage = empty_coverage(collection, wanted);
  coverage.t = times_of(*shape, wanted.span);
  coverage.z_m = query.depths(*shape);
  if (coverage.t.empty() != shape->times.empty()) return no_data(request);
  const double layers =
      static_cast<double>(std::max<std::size_t>(coverage.t.size(), 1) *
                          std::max<std::size_t>(coverage.z_m.size(), 1) * wanted.parameters.size());
  const double usual = std::max(2.0, std::floor(std::sqrt(usual_values / layers)));
  const double middle = (box.south_deg + box.north_deg) / 2.0 * std::numbers::pi / 180.0;
  const double width_m = geo::width_deg(box) * metres_per_degree * std::cos(middle);
  const double height_m = (box.north_deg - box.south_deg) * metres_per_degree;
  const auto nx = nodes_of_side(columns, width_m, shape->spacing, usual);
  const auto ny = nodes_of_side(rows, height_m, shape->spacing, usual);
  const double values = layers * static_cast<double>(nx * ny);
  if (values > most_values) return too_large(request, values);

  coverage.x_deg = spread(box.west_deg, box.west_deg + geo::width_deg(box), nx);
  coverage.y_deg = spread(box.south_deg, box.north_deg, ny);
  const auto from = coverage.t.empty() ? core::UtcTime{} : coverage.t.front();
  const auto to = coverage.t.empty() ? core::UtcTime{} : coverage.t.back();
  const auto field = load_edr_field(context.db, *shape, box, from, to);
  fill(coverage, field.get(), collection, wanted, is_inside);
  return coverage_reply(request, codec::coverage_json(coverage));
}

tl::expected<json, Response> coverage_at(const EdrCollection& collection, const Context& context,
                                         const Request& request, const EdrRequest& query,
                                         const Wanted& wanted, const codec::WktPlace& at) {
  const geo::BoundingBox box{at.place.lon_deg, at.place.lat_deg, at.place.lon_deg, at.place.lat_deg};
  const auto shape = find_edr_data(context.db, collection, box, wanted.span);
  if (!shape) return tl::unexpected(no_data(request));
  codec::CoverageGrid coverage = empty_coverage(collection, wanted);
  coverage.t = times_of(*shape, wanted.span);
  if (coverage.t.empty() != shape->times.empty()) return tl::unexpected(no_data(request));
  coverage.z_m = query.depths(*shape);
  if (at.z_m && !shape->depths_m.empty()) coverage.z_m = {*at.z_m};
  coverage.x_deg = {at.place.lon_deg};
  coverage.y_deg = {at.place.lat_deg};
  const auto from = coverage.t.empty() ? core::UtcTime{} : coverage.t.front();
  const auto to = coverage.t.empty() ? core::UtcTime{} : coverage.t.back();
  const auto field = load_edr_field(context.db, *shape, box, from, to);
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
    auto coverage = coverage_at(collection, context, request, query, wanted, place);
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
  const auto field =
      load_edr_field(context.db, *shape, box, wanted.span.from.value_or(from), wanted.span.to.value_or(from));
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
