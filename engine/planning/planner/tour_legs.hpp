#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "engine/graph/search_tree.hpp"
#include "engine/planning/cost/layout.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/search/bounds/favourable_bound.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::planner {

/// Travel times between the stops of a layout, for comparing orders of visits: each pair is searched on a coarse grid
/// of its own, at departures a fixed time apart, when first asked for; between two departures arrivals are linear,
/// which keeps FIFO. Who comes to a place that is closed then, by an iceberg for instance, has to wait until it opens.
/// Accuracy  some percent: a plan is searched on its own grid once the order is known
/// Threads   one thread at a time; answers are remembered
class TourLegs {
 public:
  /// `sea`, `layout` and `request` are borrowed and outlive the legs.
  TourLegs(const cost::Sea& sea, const cost::Layout& layout, const PlanRequest& request,
           const std::stop_token& stop);

  /// Empty when there is no way then, or once it is to stop.
  [[nodiscard]] std::optional<core::Seconds> time(std::size_t from, std::size_t to, core::Seconds depart);
  /// Never more than the same at any departure.
  [[nodiscard]] core::Seconds least_time(std::size_t from, std::size_t to);
  /// The time with what closes and opens on the way, the time that is left to leave a place before it closes for
  /// instance, and empty also where a vehicle that never holds comes before the place opens.
  [[nodiscard]] std::optional<core::Seconds> time_past_closures(std::size_t from, std::size_t to,
                                                                core::Seconds depart);

 private:
  using Pair = std::pair<std::size_t, std::size_t>;
  struct Way {
    core::Seconds time;
    std::vector<geo::PlanePoint> path;
  };
  struct Leg {
    search::OpenGrid open;
    std::optional<search::FavourableBound> bound{};  // of `open`, once it was searched
    std::map<long, std::optional<Way>> ways{};       // by number of the departure
  };
  /// Without a wait at its end.
  [[nodiscard]] std::optional<core::Seconds> time_under_way(std::size_t from, std::size_t to,
                                                            core::Seconds depart);
  [[nodiscard]] Leg& leg(Pair pair);
  [[nodiscard]] const search::FavourableBound& bound_of(Leg& leg) const;
  [[nodiscard]] std::optional<Way> searched(Leg& leg, long departure);
  /// Keeps the bound on the time without surfacing, from a surfacing at its start.
  [[nodiscard]] std::optional<Way> bounded(const search::OpenGrid& open, core::Seconds depart) const;
  [[nodiscard]] std::optional<Way> unbounded(Leg& leg, core::Seconds depart) const;
  template <class TravelTime>
  [[nodiscard]] graph::SearchTree earliest_arrivals(Leg& leg, core::Seconds depart,
                                                    const TravelTime& travel_time) const;
  /// When the vehicle can be at the end of a leg that it could be at `at_once` if nothing closed and opened in time,
  /// and that is not closed at `opens`.
  [[nodiscard]] std::optional<core::Seconds> arrival_past_closures(Pair pair, core::Seconds depart,
                                                                   core::Seconds at_once,
                                                                   core::Seconds opens);

  const cost::Sea& sea_;
  const cost::Layout& layout_;
  PlanRequest request_;
  std::stop_token stop_;
  std::vector<std::vector<TimeSpan>> closed_;  // times at which each point of the layout is
  std::map<Pair, Leg> legs_;
};

}  // namespace floeplan::planning::planner
