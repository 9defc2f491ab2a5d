#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"

namespace floeplan::ingest {

/// How the points of two components lie round the centres at which both are wanted. The centre [row][column] lies
/// half-way between the first component's points [row + first_row][column] and [column + 1], and half-way between the
/// second's [row][column + second_column] and [row + 1]. As the model numbers its centres that one is
/// [row + first_row][column + second_column].
/// Source   Arakawa and Lamb 1977, Methods in Computational Physics 17, grids A, B and C
struct Staggering {
  bool collocated{false};       // both components lie at the same points: those are the centres
  std::size_t first_row{};      // 1 where the first component's point with the centre's number lies after it
  std::size_t second_column{};  // likewise
  std::size_t rows{};           // of centres whose points are all present
  std::size_t columns{};
  std::size_t all_rows{};  // of the model's centres that have a point of either component beside them
  std::size_t all_columns{};
};

/// The model's centres on either side of a point of a component, [row][column] of all of them; empty where there is none.
struct CentresBeside {
  std::optional<std::size_t> before;
  std::optional<std::size_t> after;
};
/// Along the component's own axis. Precondition: not collocated.
[[nodiscard]] CentresBeside beside_first(const Staggering& staggering, std::size_t row, std::size_t column);
[[nodiscard]] CentresBeside beside_second(const Staggering& staggering, std::size_t row, std::size_t column);

/// The values at the centres that have all their points, taken from the values at all centres of the model. Empty if
/// there are no values.
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

/// Finds the arrangement by the positions alone, not by a model's name: the one in which the half-way points of both
/// components meet.
/// Errors   points that fit no arrangement
[[nodiscard]] Checked<Staggering> staggering_of(const Positions& first, const Positions& second);

/// The arrangement of NEMO and ROMS, in which the points with a centre's number lie after it, for grids whose points
/// have no positions of their own; of so many centres at most.
/// Errors   shapes that do not fit each other
[[nodiscard]] Checked<Staggering> points_after_centres(std::size_t first_rows, std::size_t first_columns,
                                                       std::size_t second_rows, std::size_t second_columns,
                                                       std::size_t centre_rows, std::size_t centre_columns);

/// The centres' places, [row][column].
[[nodiscard]] std::vector<geo::LonLat> centres_of(const Staggering& staggering, const Positions& first);

}  // namespace floeplan::ingest
