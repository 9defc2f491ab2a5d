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

/// Travel times between the stops of a layout, for comparing orders of visits. Times are known at departures two hours apart;
/// between them arrivals are linear, which keeps FIFO. Each pair of stops is searched when it is first asked for, on a coarse
/// grid of its own. Of many places each pair is searched once for twelve hours, on a coarser grid: at the departures between,
/// the vehicle takes one of the ways that were found before and after, unless both are closed then. A vehicle that comes to a
/// closed place, for instance because of an iceberg, waits until it reopens.
/// Accuracy  some percent: a plan is searched on its own grid once the order is known
/// Threads   one thread at a time; answers are remembered
class TourLegs {
 public:
  /// `sea`, `layout` and `request` are borrowed and outlive the legs.
  TourLegs(const cost::Sea& sea, const cost::Layout& layout, const PlanRequest& request,
           const std::stop_token& stop);

  /// Empty where there is no way at that time, and once `stop` is requested.
  [[nodiscard]] std::optional<core::Seconds> time(std::size_t from, std::size_t to, core::Seconds depart);
  /// About the time, whatever the departure: that of the tour's beginning, or in still water where there is no way then.
  [[nodiscard]] core::Seconds usual_time(std::size_t from, std::size_t to);
  /// Lower bound for all departures.
  [[nodiscard]] core::Seconds least_time(std::size_t from, std::size_t to);
  /// The time with everything that closes and reopens on the way, such as a place that the vehicle must leave before it closes.
  /// Also empty where a vehicle that never holds arrives before the place opens.
  [[nodiscard]] std::optional<core::Seconds> time_past_closures(std::size_t from, std::size_t to,
                                                                core::Seconds depart);

 private:
  using Pair = std::pair<std::size_t, std::size_t>;
  struct Way {
    core::Seconds time;
    std::vector<geo::PlanePoint> path;
    bool is_past_closures{true};  // false: what closes and reopens was left out
  };
  struct Leg {
    search::OpenGrid open;
    std::optional<search::FavourableBound> bound{};  // of `open`, once it was searched
    std::map<long, std::optional<Way>> ways{};       // by number of the departure
  };
  /// The time without a wait at the end.
  [[nodiscard]] std::optional<core::Seconds> time_under_way(std::size_t from, std::size_t to,
                                                            core::Seconds depart);
  [[nodiscard]] Leg& leg(Pair pair);
  [[nodiscard]] const search::FavourableBound& bound_of(Leg& leg) const;
  /// A way at one of the departures.
  [[nodiscard]] std::optional<Way> way_at(Pair pair, long departure);
  /// The same, searched on the grid.
  [[nodiscard]] std::optional<Way> searched(Leg& leg, core::Seconds depart) const;
  /// The way of another departure, at this one; empty where it is closed.
  [[nodiscard]] std::optional<Way> followed(const Way& way, std::size_t to, core::Seconds depart) const;
  /// The way that keeps the bound on the time without surfacing, with a surfacing at its start.
  [[nodiscard]] std::optional<Way> bounded(const search::OpenGrid& open, core::Seconds depart) const;
  [[nodiscard]] std::optional<Way> unbounded(Leg& leg, core::Seconds depart) const;
  template <class TravelTime>
  [[nodiscard]] graph::SearchTree earliest_arrivals(Leg& leg, core::Seconds depart,
                                                    const TravelTime& travel_time) const;
  /// The arrival at the end of a leg, which is open from `opens` on. Without closures the vehicle would arrive at `at_once`.
  [[nodiscard]] std::optional<core::Seconds> arrival_past_closures(Pair pair, core::Seconds depart,
                                                                   core::Seconds at_once,
                                                                   core::Seconds opens);

  const cost::Sea& sea_;
  const cost::Layout& layout_;
  PlanRequest request_;
  bool has_many_places_;
  std::stop_token stop_;
  std::vector<std::vector<TimeSpan>> closed_;  // the closed times of each point of the layout
  std::map<Pair, Leg> legs_;
};

}  // namespace floeplan::planning::planner
