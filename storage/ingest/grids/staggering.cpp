#include "storage/ingest/grids/staggering.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geo/tangent_plane.hpp"
#include "engine/messages/ingest_grid_messages.hpp"

namespace floeplan::ingest {
namespace {

// points closer than this share of the spacing coincide: rounding of float32 and of packed tables
constexpr double same_place_share = 0.02;
// greatest median distance of the half-way points, as a share of the spacing: a few per cent in the right
// arrangement
constexpr double meeting_share = 0.15;
constexpr std::size_t sampled = 400;  // number of points compared

double median(std::vector<double> values) {
  if (values.empty()) return INFINITY;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Typical distance between pairs of points, over a sample of pairs in which both have a position.
template <class Distance>
double typical(std::size_t rows, std::size_t columns, const Distance& distance) {
  const std::size_t total = rows * columns;
  const std::size_t step = std::max<std::size_t>(1, total / sampled);
  std::vector<double> found;
  for (std::size_t i = 0; i < total; i += step) {
    const double apart = distance(i / columns, i % columns);
    if (std::isfinite(apart)) found.push_back(apart);
  }
  return median(std::move(found));
}

double spacing_m(const Positions& positions) {
  if (positions.columns < 2) return INFINITY;
  return typical(positions.rows, positions.columns - 1, [&](std::size_t row, std::size_t column) {
    return geo::sphere_distance_m(positions.at(row, column), positions.at(row, column + 1));
  });
}

geo::LonLat centre(const Staggering& way, const Positions& first, std::size_t row, std::size_t column) {
  return geo::midpoint(first.at(row + way.first_row, column), first.at(row + way.first_row, column + 1));
}

std::size_t less(std::size_t a, std::size_t b) { return a > b ? a - b : 0; }

Staggering arranged(std::size_t first_row, std::size_t second_column, std::size_t first_rows,
                    std::size_t first_columns, std::size_t second_rows, std::size_t second_columns) {
  return {.collocated = false,
          .first_row = first_row,
          .second_column = second_column,
          .rows = std::min(less(first_rows, first_row), less(second_rows, 1)),
          .columns = std::min(less(first_columns, 1), less(second_columns, second_column)),
          .all_rows = std::max(first_rows, second_rows + first_row),
          .all_columns = std::max(first_columns + second_column, second_columns)};
}

std::optional<std::size_t> within(std::size_t number, std::size_t shift, std::size_t count) {
  return number >= shift && number - shift < count ? std::optional{number - shift} : std::nullopt;
}

}  // namespace

Checked<Staggering> staggering_of(const Positions& first, const Positions& second) {
  const double spacing = spacing_m(first);
  if (first.rows == second.rows && first.columns == second.columns) {
    const double apart = typical(first.rows, first.columns, [&](std::size_t row, std::size_t column) {
      return geo::sphere_distance_m(first.at(row, column), second.at(row, column));
    });
    if (apart < same_place_share * spacing)
      return Staggering{.collocated = true,
                        .rows = first.rows,
                        .columns = first.columns,
                        .all_rows = first.rows,
                        .all_columns = first.columns};
  }

  std::optional<Staggering> best;
  double least = INFINITY;
  for (const std::size_t first_row : {std::size_t{1}, std::size_t{0}}) {
    for (const std::size_t second_column : {std::size_t{1}, std::size_t{0}}) {
      const Staggering way =
          arranged(first_row, second_column, first.rows, first.columns, second.rows, second.columns);
      if (way.rows == 0 || way.columns == 0) continue;
      const double miss = typical(way.rows, way.columns, [&](std::size_t row, std::size_t column) {
        const geo::LonLat across =
            geo::midpoint(second.at(row, column + second_column), second.at(row + 1, column + second_column));
        return geo::sphere_distance_m(centre(way, first, row, column), across);
      });
      if (miss >= least) continue;
      least = miss;
      best = way;
    }
  }
  if (!best || least > meeting_share * spacing)
    return refuse(messages::ingest_grid_message<"staggering-unknown">());
  return *best;
}

Checked<Staggering> points_after_centres(std::size_t first_rows, std::size_t first_columns,
                                         std::size_t second_rows, std::size_t second_columns,
                                         std::size_t centre_rows, std::size_t centre_columns) {
  const std::size_t apart_rows = std::max(first_rows, second_rows) - std::min(first_rows, second_rows);
  const std::size_t apart_columns =
      std::max(first_columns, second_columns) - std::min(first_columns, second_columns);
  // A point half-way between two centres needs both of them.
  const std::size_t rows = std::min({first_rows, second_rows, less(centre_rows, 1)});
  const std::size_t columns = std::min({first_columns, second_columns, less(centre_columns, 1)});
  const Staggering way = arranged(1, 1, rows, columns, rows, columns);
  if (apart_rows > 1 || apart_columns > 1 || way.rows < 2 || way.columns < 2)
    return refuse(messages::ingest_grid_message<"components-of-other-shapes">());
  return way;
}

CentresBeside beside_first(const Staggering& staggering, std::size_t row, std::size_t column) {
  const auto centre = [&](std::optional<std::size_t> beside) {
    return beside ? std::optional{row * staggering.all_columns + *beside} : std::nullopt;
  };
  const std::size_t after = column + staggering.second_column;
  return {centre(within(after, 1, staggering.all_columns)), centre(within(after, 0, staggering.all_columns))};
}

CentresBeside beside_second(const Staggering& staggering, std::size_t row, std::size_t column) {
  const auto centre = [&](std::optional<std::size_t> beside) {
    return beside ? std::optional{*beside * staggering.all_columns + column} : std::nullopt;
  };
  const std::size_t after = row + staggering.first_row;
  return {centre(within(after, 1, staggering.all_rows)), centre(within(after, 0, staggering.all_rows))};
}

std::vector<geo::LonLat> centres_of(const Staggering& staggering, const Positions& first) {
  if (staggering.collocated) return first.places;
  std::vector<geo::LonLat> centres;
  centres.reserve(staggering.rows * staggering.columns);
  for (std::size_t row = 0; row < staggering.rows; ++row)
    for (std::size_t column = 0; column < staggering.columns; ++column)
      centres.push_back(centre(staggering, first, row, column));
  return centres;
}

}  // namespace floeplan::ingest
