#include "storage/ingest/grids/grid_directions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geo/tangent_plane.hpp"
#include "engine/messages/ingest_grid_messages.hpp"
#include "storage/ingest/common/missing_value.hpp"

namespace floeplan::ingest {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double agreement = 3.0 * pi / 180.0;  // between a stated angle and the positions, for most points
constexpr double quarter_turn_tolerance = 30.0 * pi / 180.0;  // grids of models are nearly orthogonal
// share of points that may disagree: folds, seams and points without a position
constexpr double most_exceptions = 0.02;

double wrapped(double angle) { return std::remainder(angle, 2.0 * pi); }

/// Direction of the first axis at a centre.
std::optional<double> first_axis(const Staggering& way, const Positions& first, geo::LonLat centre,
                                 std::size_t row, std::size_t column) {
  if (!way.collocated)
    return geo::direction_at(centre, first.at(row + way.first_row, column),
                             first.at(row + way.first_row, column + 1));
  const std::size_t before = column == 0 ? 0 : column - 1;
  const std::size_t after = std::min(column + 1, first.columns - 1);
  return geo::direction_at(centre, first.at(row, before), first.at(row, after));
}

std::optional<double> second_axis(const Staggering& way, const Positions& second, geo::LonLat centre,
                                  std::size_t row, std::size_t column) {
  if (!way.collocated)
    return geo::direction_at(centre, second.at(row, column + way.second_column),
                             second.at(row + 1, column + way.second_column));
  const std::size_t before = row == 0 ? 0 : row - 1;
  const std::size_t after = std::min(row + 1, second.rows - 1);
  return geo::direction_at(centre, second.at(before, column), second.at(after, column));
}

/// The mean of the model's angles at the centres on either side of a point; empty if it states none.
std::optional<double> stated_beside(const std::vector<double>& stated, const CentresBeside& centres) {
  const auto at = [&](std::optional<std::size_t> centre) {
    return stated.empty() || !centre || !std::isfinite(stated[*centre]) ? std::nullopt
                                                                        : std::optional{stated[*centre]};
  };
  const auto before = at(centres.before);
  const auto after = at(centres.after);
  if (before && after) return *before + 0.5 * wrapped(*after - *before);
  return before ? before : after;
}

/// Direction of a line of points at its first point `end`, radians: the tangent of the parabola through three
/// points. A sharp bend, which no grid has, gives the direction to the second point.
std::optional<double> way_from(geo::LonLat end, geo::LonLat next, geo::LonLat one_more) {
  const geo::UnitVector p = geo::unit_vector(end);
  const geo::UnitVector q = geo::unit_vector(next);
  const geo::UnitVector r = geo::unit_vector(one_more);
  const geo::LonLat ahead =
      geo::lon_lat({4.0 * q.x - r.x - 2.0 * p.x, 4.0 * q.y - r.y - 2.0 * p.y, 4.0 * q.z - r.z - 2.0 * p.z});
  const auto straight = geo::direction_at(end, end, next);
  const auto bent = geo::direction_at(end, end, ahead);
  return straight && bent && std::abs(wrapped(*bent - *straight)) < quarter_turn_tolerance ? bent : straight;
}

/// Direction of a row or a column of points at one of them, radians.
std::optional<double> way_past(const Positions& points, std::size_t row, std::size_t column, bool along_row) {
  const std::size_t count = along_row ? points.columns : points.rows;
  const std::size_t number = along_row ? column : row;
  const auto place = [&](std::size_t at) { return along_row ? points.at(row, at) : points.at(at, column); };
  std::optional<double> angle;
  if (number > 0 && number + 1 < count) {
    angle = geo::direction_at(place(number), place(number - 1), place(number + 1));
  } else if (count > 2) {
    const bool first = number == 0;
    angle = first ? way_from(place(0), place(1), place(2))
                  : way_from(place(number), place(number - 1), place(number - 2));
    if (angle && !first) *angle += pi;
  } else if (count == 2) {
    angle = geo::direction_at(place(number), place(0), place(1));
  }
  return angle && std::isfinite(*angle) ? angle : std::nullopt;
}

bool is_exceptional(std::size_t exceptions, std::size_t total) {
  return static_cast<double>(exceptions) > most_exceptions * static_cast<double>(total);
}

}  // namespace

Checked<GridDirections> directions_of(const Staggering& staggering, const Positions& first,
                                      const Positions& second, FallingAxes falling,
                                      const std::vector<double>& stated) {
  const std::vector<geo::LonLat> centres = centres_of(staggering, first);
  GridDirections directions = GridDirections::along_east(centres.size());
  std::size_t known = 0;
  std::size_t mirrored = 0;
  std::size_t contradicted = 0;
  for (std::size_t row = 0; row < staggering.rows; ++row) {
    for (std::size_t column = 0; column < staggering.columns; ++column) {
      const std::size_t point = row * staggering.columns + column;
      const auto along = first_axis(staggering, first, centres[point], row, column);
      const auto across = second_axis(staggering, second, centres[point], row, column);
      if (!along || !across || !std::isfinite(*along) || !std::isfinite(*across)) continue;
      ++known;
      double angle = wrapped(*along + (falling.first ? pi : 0.0));
      const double left = wrapped(*across + (falling.second ? pi : 0.0) - angle);
      if (std::abs(left - pi / 2.0) > quarter_turn_tolerance) ++mirrored;
      if (!stated.empty() && std::isfinite(stated[point])) {
        if (std::abs(wrapped(stated[point] - angle)) > agreement) ++contradicted;
        angle = stated[point];
      }
      directions.set(point, angle);
    }
  }
  if (known == 0) return refuse(messages::ingest_grid_message<"grid-without-direction">());
  if (is_exceptional(mirrored, known)) return refuse(messages::ingest_grid_message<"grid-mirrored">());
  if (is_exceptional(contradicted, known))
    return refuse(messages::ingest_grid_message<"grid-angle-contradicts">());
  return directions;
}

ocean::ComponentAxes axes_of_components(const Staggering& staggering, const Positions& first,
                                        const Positions& second, FallingAxes falling,
                                        const std::vector<double>& stated) {
  ocean::ComponentAxes axes = axes_east_and_north(first, second);
  for (std::size_t i = 0; i < first.places.size(); ++i) {
    const std::size_t row = i / first.columns;
    const std::size_t column = i % first.columns;
    if (const auto angle = stated_beside(stated, beside_first(staggering, row, column)))
      axes.first_rad[i] = static_cast<float>(wrapped(*angle));
    else if (const auto along = way_past(first, row, column, true))
      axes.first_rad[i] = static_cast<float>(wrapped(*along + (falling.first ? pi : 0.0)));
  }
  for (std::size_t i = 0; i < second.places.size(); ++i) {
    const std::size_t row = i / second.columns;
    const std::size_t column = i % second.columns;
    float& axis = axes.second_rad[first.places.size() + i];
    if (const auto angle = stated_beside(stated, beside_second(staggering, row, column)))
      axis = static_cast<float>(wrapped(*angle + pi / 2.0));
    else if (const auto along = way_past(second, row, column, false))
      axis = static_cast<float>(wrapped(*along + (falling.second ? pi : 0.0)));
  }
  return axes;
}

ocean::ComponentAxes axes_east_and_north(const Positions& first, const Positions& second) {
  ocean::ComponentAxes axes{std::vector<float>(first.places.size(), 0.0F),
                            std::vector<float>(first.places.size(), missing)};
  axes.first_rad.resize(first.places.size() + second.places.size(), missing);
  axes.second_rad.resize(axes.first_rad.size(), static_cast<float>(pi / 2.0));
  return axes;
}

}  // namespace floeplan::ingest
