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

/// Travel times between the stops of a layout, for comparing orders of visits. Times are computed for
/// departures two hours apart; between them they are linear, which keeps FIFO. Each pair of stops is searched
/// when it is first asked for, on its own coarse grid. With many places each pair is searched only every
/// twelve hours, on a still coarser grid. For departures between, the vehicle takes the route found before or
/// after, unless both are closed then. A vehicle that arrives at a closed place, for instance below an
/// iceberg, waits until it reopens.
/// Accuracy  some percent: a plan is searched on its own grid once the order is known
/// Threads   one thread at a time; results are cached
class TourLegs {
 public:
  /// `sea`, `layout` and `request` are borrowed and must outlive this object.
  TourLegs(const cost::Sea& sea, const cost::Layout& layout, const PlanRequest& request,
           const std::stop_token& stop);

  /// Travel time from one stop to another; stops are numbered as in the layout. Includes the wait until the
  /// end opens. Empty if there is no route at that time, and once `stop` is requested.
  [[nodiscard]] std::optional<core::Seconds> time(std::size_t from, std::size_t to, core::Seconds depart);
  /// Approximate time for any departure: the time for a departure at the beginning of the tour or, if there is no
  /// route then, the time in still water.
  [[nodiscard]] core::Seconds usual_time(std::size_t from, std::size_t to);
  /// Lower bound of the time for all departures.
  [[nodiscard]] core::Seconds least_time(std::size_t from, std::size_t to);
  /// The time with all closures on the way, such as a place that the vehicle must leave before it closes.
  /// Empty also if a vehicle that may not hold arrives before the place opens.
  [[nodiscard]] std::optional<core::Seconds> time_past_closures(std::size_t from, std::size_t to,
                                                                core::Seconds depart);

 private:
  using Pair = std::pair<std::size_t, std::size_t>;
  struct Way {
    core::Seconds time;
    std::vector<geo::PlanePoint> path;
    bool is_past_closures{true};  // false: searched without closures that end
  };
  struct Leg {
    search::OpenGrid open;
    std::optional<search::FavourableBound> bound{};  // lower bounds on `open`, made at the first search
    std::map<long, std::optional<Way>> ways{};       // by number of the departure (`between_departures`)
  };
  /// The time without the wait at the end.
  [[nodiscard]] std::optional<core::Seconds> time_under_way(std::size_t from, std::size_t to,
                                                            core::Seconds depart);
  [[nodiscard]] Leg& leg(Pair pair);
  [[nodiscard]] const search::FavourableBound& bound_of(Leg& leg) const;
  /// The route at a departure, from the cache if it is known.
  [[nodiscard]] std::optional<Way> way_at(Pair pair, long departure);
  /// The route at a departure, searched on the grid.
  [[nodiscard]] std::optional<Way> searched(Leg& leg, core::Seconds depart) const;
  /// Times the route of another departure for this one; empty if it is closed.
  [[nodiscard]] std::optional<Way> followed(const Way& way, std::size_t to, core::Seconds depart) const;
  /// The route that keeps the limit on the time without surfacing, with a surfacing at its start.
  [[nodiscard]] std::optional<Way> bounded(const search::OpenGrid& open, core::Seconds depart) const;
  [[nodiscard]] std::optional<Way> unbounded(Leg& leg, core::Seconds depart) const;
  template <class TravelTime>
  [[nodiscard]] graph::SearchTree earliest_arrivals(Leg& leg, core::Seconds depart,
                                                    const TravelTime& travel_time) const;
  /// Arrival at the end of a leg with all closures. The end opens at `opens`; without closures the vehicle
  /// would arrive at `at_once`.
  [[nodiscard]] std::optional<core::Seconds> arrival_past_closures(Pair pair, core::Seconds depart,
                                                                   core::Seconds at_once,
                                                                   core::Seconds opens);

  const cost::Sea& sea_;
  const cost::Layout& layout_;
  PlanRequest request_;
  bool has_many_places_;
  std::stop_token stop_;
  std::vector<std::vector<TimeSpan>> closed_;  // closed times of each point of the layout
  std::map<Pair, Leg> legs_;
};

}  // namespace floeplan::planning::planner
