#include "storage/ingest/grids/grid_directions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geo/tangent_plane.hpp"
#include "engine/messages/ingest_format_messages.hpp"

namespace floeplan::ingest {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double agreement = 3.0 * pi / 180.0;  // of a stated angle with the positions, at most places
constexpr double quarter_turn_tolerance = 30.0 * pi / 180.0;  // grids of models are nearly orthogonal
constexpr double most_exceptions = 0.02;  // folds, seams and places that were never filled in

double wrapped(double angle) { return std::remainder(angle, 2.0 * pi); }

/// The way along the first axis past a centre.
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
  if (known == 0) return refuse(messages::ingest_format_message<"grid-without-direction">());
  if (is_exceptional(mirrored, known)) return refuse(messages::ingest_format_message<"grid-mirrored">());
  if (is_exceptional(contradicted, known))
    return refuse(messages::ingest_format_message<"grid-angle-contradicts">());
  return directions;
}

}  // namespace floeplan::ingest
