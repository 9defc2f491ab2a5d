#include "engine/mission/document/flown_rows.hpp"

#include <algorithm>
#include <cmath>

#include "engine/messages/mission_fault_messages.hpp"

namespace floeplan::mission {
namespace {

constexpr std::size_t most_named = 12;  // largest number of rows in a note

bool is_whole_within(double value, double low, double high) {
  return value == std::floor(value) && value >= low && value <= high;
}

core::Violation of_another_program(const char* argument) {
  return messages::mission_fault<"legs-of-another-program">(argument);
}

/// Text such as "row 2" or "rows 0, 1 and 2".
std::string named(const std::vector<std::size_t>& rows) {
  const std::size_t shown = std::min(rows.size(), most_named);
  std::string text = rows.size() == 1 ? "row " : "rows ";
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) text += i + 1 == rows.size() ? " and " : ", ";
    text += std::to_string(rows[i]);
  }
  if (rows.size() > shown) text += " and " + std::to_string(rows.size() - shown) + " more";
  return text;
}

std::string one_round(const FlownRows& flown) {
  return "the list goes round for ever; one round is flown here (" + named(flown.rows) +
         "), and then the vehicle turns back to row " + std::to_string(flown.rows.front());
}

}  // namespace

tl::expected<ListOrders, core::Violation> list_orders(std::optional<double> legs,
                                                      std::optional<double> initial, std::size_t rows) {
  if (!legs) return tl::unexpected(of_another_program("num_legs_to_run"));
  if (!initial) return tl::unexpected(of_another_program("initial_wpt"));
  if (!is_whole_within(*legs, -2.0, most_legs) || *legs == 0.0) {
    return tl::unexpected(messages::mission_fault<"wrong-legs-to-run">("num_legs_to_run", most_legs));
  }
  if (!is_whole_within(*initial, -2.0, static_cast<double>(rows) - 1.0)) {
    return tl::unexpected(messages::mission_fault<"wrong-initial-waypoint">("initial_wpt", rows));
  }
  return ListOrders{static_cast<int>(*legs), static_cast<int>(*initial)};
}

FlownRows flown_rows(ListOrders orders, std::size_t rows, std::size_t closest) {
  const std::size_t first = orders.initial == -2   ? closest
                            : orders.initial == -1 ? 0
                                                   : static_cast<std::size_t>(orders.initial);
  const bool once = orders.legs == -2;
  const bool for_ever = orders.legs == -1;
  const std::size_t count = once ? rows - first : for_ever ? rows : static_cast<std::size_t>(orders.legs);
  FlownRows flown{.rows = {}, .goes_round = for_ever};
  flown.rows.reserve(count);
  for (std::size_t leg = 0; leg < count; ++leg) flown.rows.push_back((first + leg) % rows);
  return flown;
}

std::string note_of_rows(ListOrders orders, const FlownRows& flown, std::size_t rows, bool knows_start) {
  std::vector<std::size_t> left_out;
  for (std::size_t row = 0; row < rows; ++row)
    if (std::ranges::find(flown.rows, row) == flown.rows.end()) left_out.push_back(row);

  std::string text;
  const auto add = [&](const std::string& clause) { text += (text.empty() ? "" : "; ") + clause; };
  if (flown.goes_round && rows > 1) {
    add(one_round(flown));
  } else if (flown.rows.size() > rows) {
    add("num_legs_to_run is " + std::to_string(orders.legs) + ", more than the " + std::to_string(rows) +
        (rows == 1 ? " row" : " rows") + ": flown are " + named(flown.rows));
  } else if (!left_out.empty()) {
    add("the vehicle flies " + named(flown.rows) + " and leaves out " + named(left_out));
  } else if (flown.rows.front() != 0) {
    add("the vehicle flies " + named(flown.rows));
  }
  if (orders.initial == -2 && rows > 1 && !knows_start)
    add("initial_wpt is -2, so that a vehicle begins with the row closest to it; without a start, row 0 is "
        "taken");
  if (orders.initial == -1 && rows > 1)
    add("initial_wpt is -1, so that a vehicle goes on after the last row that it achieved; a fresh mission, "
        "as "
        "here, begins with row 0");
  if (!text.empty()) text += " (rows count from 0)";
  return text;
}

}  // namespace floeplan::mission
