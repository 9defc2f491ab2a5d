#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"

namespace floeplan::mission {

/// The two arguments of a goto list that decide which of its rows are flown.
/// Source   num_legs_to_run and initial_wpt of the vendor's data dictionary of firmware 10.5, and their
///          defaults there
struct ListOrders {
  int legs{-1};     // number of legs; -1: repeat without end; -2: once, to the last row
  int initial{-2};  // first row, from 0; -1: the one after the last achieved; -2: the closest
};

/// Largest number of legs of one list: weeks of waypoints an hour apart. It limits time and memory.
inline constexpr int most_legs = 1000;

/// The orders of a list with `rows` rows, at least one. `legs`, `initial`: values of the two arguments; empty
/// if they stand for a parameter that another program on board sets.
/// Errors   a violation that names the argument whose effect is undocumented or unknown
[[nodiscard]] tl::expected<ListOrders, core::Violation> list_orders(std::optional<double> legs,
                                                                    std::optional<double> initial,
                                                                    std::size_t rows);

/// The rows of a list that the vehicle flies.
struct FlownRows {
  std::vector<std::size_t>
      rows;  // from 0, in the order in which they are flown; of a list without end, one round only
  bool goes_round{false};  // after the last row the first follows again, without end
};

/// The only rule for which rows of a list are flown; simulator, planner and checks all use it. In a new
/// mission no waypoint is achieved yet, so -1 means the first row. If N legs exceed the rows, the first row
/// follows after the last.
/// `closest`      the row to begin with if the list asks for the closest
/// Precondition   `rows` > 0, `closest` < `rows`, `orders` as `list_orders` returns them for as many rows
[[nodiscard]] FlownRows flown_rows(ListOrders orders, std::size_t rows, std::size_t closest);

/// Text for the pilot about a route with these rows of the list: which rows are left out, which are flown
/// again, that a list without end is flown once, and that the first row depends on the vehicle's place. Empty
/// if every row is flown once from first to last.
/// `knows_start`  whether `closest` was found from the vehicle's place
[[nodiscard]] std::string note_of_rows(ListOrders orders, const FlownRows& flown, std::size_t rows,
                                       bool knows_start);

}  // namespace floeplan::mission
