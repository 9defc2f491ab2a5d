#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::planning::planner {

/// Time to travel from one place of a tour to another for a departure at a time; empty: no way then. Places are numbered:
/// 0 the start, 1 .. n those to visit, n + 1 the goal.
/// Law (FIFO)  leaving later never arrives earlier
using TourLegTime =
    std::function<std::optional<core::Seconds>(std::size_t from, std::size_t to, core::Seconds depart)>;

/// What is known of the time of a leg whatever the departure; what is empty is not known.
struct LegEstimates {
  using Estimate = std::function<core::Seconds(std::size_t from, std::size_t to)>;
  Estimate least{};  // a lower bound
  Estimate usual{};  // about as long as at most departures
};

/// An order of visits, and the end of its tour.
struct VisitingOrder {
  std::vector<std::size_t> places;  // 1 .. n in the order of the visits
  core::Seconds arrival{};          // at the goal
  bool exact{false};                // no other order ends earlier
};

/// Up to so many places are ordered exactly, more by the heuristic.
inline constexpr std::size_t most_places_ordered_exactly = 12;

/// The order of visits that reaches the goal earliest. Up to 12 places exactly, by dynamic programming over the sets
/// of places visited so far: under FIFO the earliest arrival at the last place of a set is all that counts of it.
/// More by the cheapest insertion of one place after the other into the tour, followed by reversals of a stretch and
/// moves of up to three neighbours as long as one ends the tour earlier; every tour is timed from its departure.
/// `estimates`  the lower bound saves legs that cannot be the best to a place. Of more than 12 places, orders that are a
///          twentieth longer than others by the usual times are not timed
/// Returns  empty when no order leads to the goal, or when `stop` was requested before one was found
/// Source   Held and Karp 1962, A dynamic programming approach to sequencing problems, J. SIAM 10, with arrivals for
///          distances; insertion and 2-opt: Rosenkrantz, Stearns and Lewis 1977, doi:10.1137/0206041, Croes 1958,
///          doi:10.1287/opre.6.6.791; moves of neighbours: Or 1976
[[nodiscard]] std::optional<VisitingOrder> best_visiting_order(std::size_t places, core::Seconds depart,
                                                               const TourLegTime& leg_time,
                                                               const std::stop_token& stop,
                                                               const LegEstimates& estimates = {});

/// Up to so many places are ordered exactly where a later departure may get further. A judgement: each of their 120 orders needs
/// legs at its own departures, and a search for one takes some milliseconds.
inline constexpr std::size_t most_places_tried_in_all_orders = 5;

/// The same for times that break FIFO. Up to 5 places: tries all orders and returns the requested number, the earliest first.
/// More places: as if FIFO held. Then one order at most is returned; it can be travelled, but another one may end earlier, or
/// be the only one.
/// `most`   orders, at least one
[[nodiscard]] std::vector<VisitingOrder> best_visiting_orders_without_fifo(
    std::size_t places, core::Seconds depart, const TourLegTime& leg_time, std::size_t most,
    const std::stop_token& stop, const LegEstimates& estimates = {});

/// The arrival at the goal of the tour in this order; empty where a leg has no way.
[[nodiscard]] std::optional<core::Seconds> end_of_tour(const std::vector<std::size_t>& places,
                                                       core::Seconds depart, const TourLegTime& leg_time);

}  // namespace floeplan::planning::planner
