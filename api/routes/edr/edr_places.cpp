#include "api/routes/edr/edr_places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/geo/united_boxes.hpp"

namespace floeplan::routes {
namespace {

constexpr double metres_per_degree = 111'195.0;  // of latitude, mean of the WGS84 sphere of equal volume

/// Tolerance for nodes at the edge of a shape: files store coordinates as 4-byte floats, which round a
/// longitude by 8e-6 degrees, and clients print few digits. Smaller if the nodes are close together.
double edge_tolerance_deg(const ocean::Axis& axis) {
  constexpr double rounding_deg = 1e-5;
  constexpr double share_of_step = 1e-3;
  return axis.size() > 1 ? std::min(rounding_deg, share_of_step * axis.mean_step()) : rounding_deg;
}

/// The part of an axis that the box covers, with degrees increasing from its lower edge.
struct Span {
  double from_deg{};
  double width_deg{};
  [[nodiscard]] double middle_deg() const { return from_deg + width_deg / 2.0; }
};

/// Longitudes of the nodes in the box, ascending and continuous. A meridian that is stored twice appears
/// once.
std::vector<double> columns_in(const ocean::Axis& x, const Span& span, double tolerance_deg) {
  std::vector<double> inside;
  for (const double node_deg : x.nodes()) {
    const double turns = std::floor((node_deg - span.from_deg + tolerance_deg) / 360.0);
    const double lon_deg = node_deg - 360.0 * turns;
    if (lon_deg <= span.from_deg + span.width_deg + tolerance_deg) inside.push_back(lon_deg);
  }
  std::ranges::sort(inside);
  const auto again = std::ranges::unique(inside, [&](double a, double b) { return b - a <= tolerance_deg; });
  inside.erase(again.begin(), again.end());
  return inside;
}

std::vector<double> rows_in(const ocean::Axis& y, const Span& span, double tolerance_deg) {
  std::vector<double> inside;
  for (const double node_deg : y.nodes()) {
    if (node_deg >= span.from_deg - tolerance_deg &&
        node_deg <= span.from_deg + span.width_deg + tolerance_deg)
      inside.push_back(node_deg);
  }
  return inside;
}

std::vector<double> spread(const Span& span, std::size_t count, bool on_edges) {
  std::vector<double> places;
  const auto n = static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto index = static_cast<double>(i);
    const double share = on_edges && count > 1 ? index / (n - 1.0) : (index + 0.5) / n;
    places.push_back(span.from_deg + share * span.width_deg);
  }
  return places;
}

/// How to choose places along an axis: nodes, or a number of places spread over a span.
struct Side {
  std::vector<double> nodes;  // empty: spread
  Span span;
  std::size_t count{};  // number of places if none is omitted
  bool is_asked{false};
  bool on_edges{false};

  [[nodiscard]] std::size_t count_of_every(std::size_t step) const {
    return is_asked ? count : (count + step - 1) / step;
  }
  /// Every `step`-th node, including the one nearest to `middle_deg`.
  [[nodiscard]] std::vector<double> every(std::size_t step, double middle_deg) const {
    if (nodes.empty()) return spread(span, count_of_every(step), on_edges);
    const auto nearest =
        std::ranges::min_element(nodes, {}, [&](double node_deg) { return std::abs(node_deg - middle_deg); });
    std::vector<double> kept;
    for (auto i = static_cast<std::size_t>(nearest - nodes.begin()) % step; i < nodes.size(); i += step)
      kept.push_back(nodes[i]);
    return kept;
  }
};

Side asked_side(const Span& span, std::size_t count, bool on_edges) {
  return {.nodes = {}, .span = span, .count = count, .is_asked = true, .on_edges = on_edges};
}

Side side_of_nodes(std::vector<double> nodes) {
  const std::size_t count = nodes.size();
  return {.nodes = std::move(nodes), .span = {}, .count = count};
}

/// A side with as many places as the spacing of the data gives.
Side spaced_side(const Span& span, double length_m, core::Metres spacing) {
  const double count = spacing.value > 0.0 ? std::max(1.0, std::round(length_m / spacing.value)) : 1.0;
  return {.nodes = {}, .span = span, .count = static_cast<std::size_t>(count)};
}

struct Sides {
  Side x;
  Side y;
  bool at_nodes{false};  // true along axes without a requested number of places
};

std::optional<Sides> sides_of(const EdrArea& area, const EdrNodes& nodes, const EdrResolution& resolution) {
  const geo::BoundingBox& box = area.box;
  const Span across{box.west_deg, geo::width_deg(box)};
  const Span along{box.south_deg, box.north_deg - box.south_deg};
  Sides sides;
  sides.at_nodes = std::holds_alternative<geo::GeographicFrame>(nodes.grid.frame());
  if (sides.at_nodes) {
    const ocean::Axis& x = nodes.grid.x();
    const ocean::Axis& y = nodes.grid.y();
    sides.x = side_of_nodes(columns_in(x, across, edge_tolerance_deg(x)));
    sides.y = side_of_nodes(rows_in(y, along, edge_tolerance_deg(y)));
  } else {
    const auto part = geo::shared(box, nodes.grid.bounds());
    if (!part) return std::nullopt;
    const double middle_deg = (part->south_deg + part->north_deg) / 2.0;
    const Span part_across{part->west_deg, geo::width_deg(*part)};
    const Span part_along{part->south_deg, part->north_deg - part->south_deg};
    const double width_m =
        part_across.width_deg * metres_per_degree * std::cos(core::degrees_to_radians(middle_deg));
    sides.x = spaced_side(part_across, width_m, nodes.grid.spacing());
    sides.y = spaced_side(part_along, part_along.width_deg * metres_per_degree, nodes.grid.spacing());
  }
  if (resolution.columns) sides.x = asked_side(across, *resolution.columns, area.places_on_edges);
  if (resolution.rows) sides.y = asked_side(along, *resolution.rows, area.places_on_edges);
  if (sides.x.count == 0 || sides.y.count == 0) return std::nullopt;
  return sides;
}

/// The smallest step for which the number of places is allowed.
std::size_t step_for(const Sides& sides, double most_places) {
  const std::size_t longest = std::max(sides.x.count, sides.y.count);
  std::size_t step = 1;
  while (step<longest&& static_cast<double>(sides.x.count_of_every(step)) *
              static_cast<double>(sides.y.count_of_every(step))>
             most_places)
    ++step;
  return step;
}

std::string in_words(const Sides& sides, const EdrNodes& nodes, std::size_t step) {
  const std::size_t apart = step * nodes.apart;
  const std::string thinned = apart > 1 ? "one node of the data in " + std::to_string(apart) +
                                              " along each axis; a smaller shape, fewer depths or less time "
                                              "give more of them"
                                        : "every node of the data in the shape";
  if (sides.x.is_asked && sides.y.is_asked) {
    const std::string how = "interpolated on the grid that was asked for";
    return nodes.apart > 1 ? how + ", from one node of the data in " + std::to_string(nodes.apart) : how;
  }
  if (!sides.at_nodes) {
    return "interpolated on a grid " +
           std::string{step > 1 ? std::to_string(step) + " times coarser than " : "about as fine as "} +
           "that of the data, which is not one of longitudes and latitudes";
  }
  if (sides.x.is_asked || sides.y.is_asked)
    return "interpolated as was asked for along one axis; along the other: " + thinned;
  return thinned;
}

}  // namespace

std::optional<EdrPlaces> places_in(const EdrArea& area, const EdrNodes& nodes,
                                   const EdrResolution& resolution) {
  const auto sides = sides_of(area, nodes, resolution);
  if (!sides) return std::nullopt;
  const std::size_t step = step_for(*sides, resolution.most_places);
  const geo::LonLat middle =
      area.middles.empty() ? area_of_box(area.box).middles.front() : area.middles.front();
  // Longitudes increase from the western edge of the box, as those of the nodes do.
  const double middle_x_deg =
      area.box.west_deg + std::fmod(middle.lon_deg - area.box.west_deg + 720.0, 360.0);
  EdrPlaces places;
  places.x_deg = sides->x.every(step, middle_x_deg);
  places.y_deg = sides->y.every(step, middle.lat_deg);
  const double tolerance_deg =
      sides->at_nodes ? std::min(edge_tolerance_deg(nodes.grid.x()), edge_tolerance_deg(nodes.grid.y()))
                      : 0.0;
  bool any = false;
  for (const double lat_deg : places.y_deg) {
    for (const double lon_deg : places.x_deg) {
      const geo::LonLat place{geo::wrap_longitude(lon_deg), std::clamp(lat_deg, -90.0, 90.0)};
      places.is_inside.push_back(area.covers(place, tolerance_deg));
      any = any || places.is_inside.back();
    }
  }
  if (!any) return std::nullopt;
  places.is_every_node =
      sides->at_nodes && !sides->x.is_asked && !sides->y.is_asked && step * nodes.apart == 1;
  places.sampling = in_words(*sides, nodes, step);
  return places;
}

EdrPlaces only_place(geo::LonLat place, std::string sampling) {
  return {.x_deg = {place.lon_deg},
          .y_deg = {place.lat_deg},
          .is_inside = {true},
          .is_every_node = false,
          .sampling = std::move(sampling)};
}

}  // namespace floeplan::routes
