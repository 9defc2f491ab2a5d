#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"

namespace floeplan::mission {

/// What a goto list says of which of its rows are flown.
/// Source   num_legs_to_run and initial_wpt of the vendor's data dictionary of firmware 10.5, and their defaults there
struct ListOrders {
  int legs{-1};     // to fly; -1 round and round for ever, -2 once, to the last row
  int initial{-2};  // row to begin with, from 0; -1 the one after the last achieved, -2 the closest
};

/// The most legs of one list: weeks of waypoints an hour apart, and a bound on time and memory.
inline constexpr int most_legs = 1000;

/// The orders of a list of `rows` rows, one at least. `legs`, `initial`: the values of the two arguments; empty where
/// they stand for a parameter that another program on board sets.
/// Errors   the argument, as the field, for which no vehicle says what it would fly, or that is not known here
[[nodiscard]] tl::expected<ListOrders, core::Violation> list_orders(std::optional<double> legs,
                                                                    std::optional<double> initial,
                                                                    std::size_t rows);

/// The rows of a list that the vehicle flies.
struct FlownRows {
  std::vector<std::size_t>
      rows;                // from 0, in the order in which they are flown; of a list without end, one round
  bool goes_round{false};  // after the last of them the first again, for ever
};

/// The one rule of which rows of a list are flown, for the simulator as for whoever times, plans or checks a list.
/// A fresh mission has achieved no waypoint: for it -1 is the first row. N legs of a list that has fewer rows go on
/// with its first row after its last.
/// `closest`      the row to begin with where the list asks for the closest
/// Precondition   `rows` > 0, `closest` < `rows`, `orders` as `list_orders` returns them for as many rows
[[nodiscard]] FlownRows flown_rows(ListOrders orders, std::size_t rows, std::size_t closest);

/// What the pilot has to know of a route that holds these rows of the list: which are left out, which are flown again,
/// that a list without end is flown once, and where the first row rests on where the vehicle is. Empty where every row
/// is flown once from the first to the last.
/// `knows_start`  whether `closest` was found from where the vehicle is
[[nodiscard]] std::string note_of_rows(ListOrders orders, const FlownRows& flown, std::size_t rows,
                                       bool knows_start);

}  // namespace floeplan::mission
