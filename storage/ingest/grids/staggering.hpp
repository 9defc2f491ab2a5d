#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"

namespace floeplan::ingest {

/// How the points of two components lie around the centres at which both are wanted. The centre [row][column]
/// is half-way between the first component's points [row + first_row][column] and [row + first_row][column +
/// 1], and half-way between the second's [row][column + second_column] and [row + 1][column + second_column].
/// In the model's own numbering this centre is [row + first_row][column + second_column].
/// Source   Arakawa and Lamb 1977, Methods in Computational Physics 17, grids A, B and C
struct Staggering {
  bool collocated{false};  // both components lie at the same points, which are then the centres
  // 1 if the first component's point with a centre's number lies after the centre
  std::size_t first_row{};
  std::size_t second_column{};  // 1 likewise for the second component
  std::size_t rows{};           // number of rows of centres with all their points
  std::size_t columns{};
  // number of rows of the model's centres with at least one point of a component beside them
  std::size_t all_rows{};
  std::size_t all_columns{};
};

/// The model's centres on either side of a component's point, as indices [row][column] of all centres; empty
/// if there is none.
struct CentresBeside {
  std::optional<std::size_t> before;
  std::optional<std::size_t> after;
};
/// The two centres along the component's own axis. Precondition: not collocated.
[[nodiscard]] CentresBeside beside_first(const Staggering& staggering, std::size_t row, std::size_t column);
[[nodiscard]] CentresBeside beside_second(const Staggering& staggering, std::size_t row, std::size_t column);

/// The values at the centres that have all their points, selected from the values at all centres of the
/// model. Empty if there are no values.
template <class Value>
[[nodiscard]] std::vector<Value> of_whole_centres(const Staggering& staggering,
                                                  const std::vector<Value>& all) {
  if (staggering.collocated || all.empty()) return all;
  std::vector<Value> whole;
  whole.reserve(staggering.rows * staggering.columns);
  for (std::size_t row = 0; row < staggering.rows; ++row)
    for (std::size_t column = 0; column < staggering.columns; ++column)
      whole.push_back(
          all[(row + staggering.first_row) * staggering.all_columns + column + staggering.second_column]);
  return whole;
}

/// Finds the arrangement from the positions alone, not from a model's name: the one in which the half-way
/// points of both components coincide.
/// Errors   points that fit no arrangement
[[nodiscard]] Checked<Staggering> staggering_of(const Positions& first, const Positions& second);

/// The arrangement of NEMO and ROMS, in which a point lies after the centre with its number, for grids whose
/// points have no positions of their own. The arguments are the numbers of points and of the model's centres.
/// Errors   shapes that do not fit each other
[[nodiscard]] Checked<Staggering> points_after_centres(std::size_t first_rows, std::size_t first_columns,
                                                       std::size_t second_rows, std::size_t second_columns,
                                                       std::size_t centre_rows, std::size_t centre_columns);

/// The positions of the centres, [row][column].
[[nodiscard]] std::vector<geo::LonLat> centres_of(const Staggering& staggering, const Positions& first);

}  // namespace floeplan::ingest
