#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::planning::planner {

/// Travel time from one place of a tour to another for a departure at `depart`; empty: no route then. Numbers
/// of places: 0 the start, 1 to n the places to visit, n + 1 the goal.
/// Law (FIFO)  leaving later never arrives earlier
using TourLegTime =
    std::function<std::optional<core::Seconds>(std::size_t from, std::size_t to, core::Seconds depart)>;

/// Estimates of a leg's time that hold for any departure. An empty function means unknown.
struct LegEstimates {
  using Estimate = std::function<core::Seconds(std::size_t from, std::size_t to)>;
  Estimate least{};  // a lower bound
  Estimate usual{};  // typical time
};

/// An order of visits, and when its tour ends.
struct VisitingOrder {
  std::vector<std::size_t> places;  // 1 .. n in the order of the visits
  core::Seconds arrival{};          // at the goal
  bool exact{false};                // true: no other order ends earlier
};

/// Up to this number of places the order is exact; above it is found by a heuristic.
inline constexpr std::size_t most_places_ordered_exactly = 12;

/// The order of visits that reaches the goal earliest. Up to 12 places it is exact, by dynamic programming
/// over the sets of places visited so far: under FIFO only the earliest arrival at the last place of a set
/// matters. With more places a heuristic: the cheapest insertion of one place after another; then reversals
/// of a stretch and moves of up to three consecutive places, while they make the tour end earlier. Every tour
/// is timed from its departure.
/// `estimates`  the lower bound saves legs that cannot be the best to a place. With more than 12 places,
/// orders that are a twentieth longer than others by the usual times are not timed
/// Returns  empty if no order leads to the goal, or if `stop` was requested before one was found
/// Source   Held and Karp 1962, A dynamic programming approach to sequencing problems, J. SIAM 10, with
///          arrivals for distances; insertion and 2-opt: Rosenkrantz, Stearns and Lewis 1977,
///          doi:10.1137/0206041, Croes 1958, doi:10.1287/opre.6.6.791; moves of consecutive places: Or 1976
[[nodiscard]] std::optional<VisitingOrder> best_visiting_order(std::size_t places, core::Seconds depart,
                                                               const TourLegTime& leg_time,
                                                               const std::stop_token& stop,
                                                               const LegEstimates& estimates = {});

/// Up to this number of places all orders are tried if FIFO does not hold. A judgement: each of the 120
/// orders of five places needs legs at its own departures, and a search for a leg takes some milliseconds.
inline constexpr std::size_t most_places_tried_in_all_orders = 5;

/// The best orders for travel times that break FIFO (a later departure may arrive earlier). Up to 5 places:
/// tries all orders and returns the requested number, the earliest first. More places: as if FIFO held, and
/// at most one order. It can be travelled, but another order may end earlier, and none may be found although
/// one exists.
/// `most`   largest number of orders, at least one
[[nodiscard]] std::vector<VisitingOrder> best_visiting_orders_without_fifo(
    std::size_t places, core::Seconds depart, const TourLegTime& leg_time, std::size_t most,
    const std::stop_token& stop, const LegEstimates& estimates = {});

/// The arrival at the goal of the tour in this order; empty if some leg has no route.
[[nodiscard]] std::optional<core::Seconds> end_of_tour(const std::vector<std::size_t>& places,
                                                       core::Seconds depart, const TourLegTime& leg_time);

}  // namespace floeplan::planning::planner
