#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/graph/search_tree.hpp"
#include "engine/planning/currents/nearby_currents.hpp"
#include "engine/planning/search/bounds/favourable_bound.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/grid/vertex_closures.hpp"

namespace floeplan::planning::search {

/// Bounds and estimates for a search over a grid, without exact edge times. All edges out of a vertex are
/// timed at once. There are two searches, each many times faster than the exact one. The forward one uses
/// estimates and finds a nearly best route. The backward one uses proven bounds and gives the latest useful
/// time of each vertex.
/// Threads  one at a time
class Foresight {
 public:
  static constexpr graph::Vertex no_vertex = std::numeric_limits<graph::Vertex>::max();

  /// `sea` and `open` are borrowed and must outlive this object. So must `at_any_time`, bounds of the same grid that
  /// were made before; null: none were.
  Foresight(const cost::Sea& sea, const OpenGrid& open, const FavourableBounds* at_any_time = nullptr);

  /// Whether these bounds are sharper than a straight line with the strongest current from astern.
  [[nodiscard]] bool is_useful() const { return !nearby_ || nearby_->is_useful(); }

  /// How a route treats places that are closed for a while.
  enum class TimedClosures {
    ignored,
    avoided,    // no drive at constant speed along an edge may meet one
    waited_for  // nobody arrives at a closed vertex before it reopens
  };
  /// What an estimated route avoids, besides places that are always closed.
  struct Minding {
    TimedClosures timed{TimedClosures::ignored};
    /// A few legs that must not be used. Nor must their ends, but for start and goal.
    std::vector<graph::Edge> closed{};
  };
  /// A route from start to goal, edge by edge, that is probably close to the best. It may turn out to be
  /// closed. Empty if none is found, or once `stop` is requested.
  [[nodiscard]] std::vector<graph::Edge> likely_way(core::Seconds depart, const std::stop_token& stop,
                                                    const Minding& minding);

  /// A route that a search found, and its travel time then.
  struct KnownWay {
    std::vector<graph::Edge> edges;
    core::Seconds time{};
  };
  /// The last route that a search with these closures found; empty: none. It is likely for another departure,
  /// too.
  [[nodiscard]] KnownWay& last_way(TimedClosures timed) {
    return last_ways_[static_cast<std::size_t>(timed)];
  }

  /// The latest useful times at vertices for a vehicle that leaves the start at `depart` and must reach the
  /// goal by `arrive`. The tree is the result of a time-reversed search: its arrival at a vertex is minus the
  /// latest useful time. A vertex that the tree does not reach is of no use.
  /// Law      no route of open legs that reaches the goal by `arrive` is at a vertex later. Only currents
  ///          count here: a leg that is closed for a while counts as open
  /// Returns  borrowed; valid until the next call
  [[nodiscard]] const graph::SearchTree& until_when_of_use(core::Seconds depart, core::Seconds arrive,
                                                           const std::stop_token& stop);

  /// The earliest arrivals at vertices after leaving the start at `depart`. A vertex that is not reached is
  /// of no use for an arrival at the goal by `arrive`. A closed vertex is reached when it reopens.
  [[nodiscard]] graph::SearchTree sweep_forth(core::Seconds depart, core::Seconds arrive,
                                              const std::stop_token& stop);
  /// The latest useful times for exactly these two times; not cached. Unlike in `until_when_of_use`, closed
  /// vertices cannot be entered. If a vehicle cannot wait until a vertex reopens and still arrive, it must be
  /// there before the vertex closes.
  /// `earliest`: result of `sweep_forth` for the same departure and the same or a later arrival
  [[nodiscard]] graph::SearchTree sweep_back(core::Seconds depart, core::Seconds arrive,
                                             const std::stop_token& stop, const graph::SearchTree& earliest);

  /// Bounds that hold at any time, made at the first call. Once `stop` is requested they must not be used.
  [[nodiscard]] const FavourableBounds& at_any_time(const std::stop_token& stop) {
    if (at_any_time_ == nullptr) at_any_time_ = &own_at_any_time_.emplace(sea_, open_, stop);
    return *at_any_time_;
  }
  /// The closed times of the grid's vertices.
  [[nodiscard]] VertexClosures& closures() { return closures_; }
  /// When somebody who reaches the vertex at `time`, or waits for it to reopen, can be there: at `time`, or at
  /// the end of the closure, less a few seconds for the error of integrated times.
  [[nodiscard]] core::Seconds open_from(graph::Vertex v, core::Seconds time);

  /// Estimated times of the edges out of a vertex, by step of the grid, for a departure at `depart` with this
  /// propulsion. Closed edges get long times.
  /// Returns  borrowed, until the next call of any member; null where the current is unknown
  [[nodiscard]] const motion::FanTimes* estimates(graph::Vertex v, core::Seconds depart,
                                                  vehicle::Drive drive);

  /// Lower bound of the time of an edge for a departure from its tail at `depart`. Fast when the edges of one
  /// vertex are asked for in a row.
  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds depart);

 private:
  enum class Fidelity { estimate, bound };
  /// Times all edges out of a vertex; false if the current there is unknown.
  [[nodiscard]] bool look(graph::Vertex v, core::Seconds time, currents::NearbyCurrents::Film film,
                          Fidelity fidelity);
  /// The current around a vertex; empty if it is unknown.
  [[nodiscard]] std::optional<motion::NearbyCurrent> water_at(graph::Vertex v, core::Seconds time,
                                                              currents::NearbyCurrents::Film film);
  [[nodiscard]] core::Seconds proven(const graph::Edge& edge, bool is_known) const;
  [[nodiscard]] graph::SearchTree sweep_back(core::Seconds depart, core::Seconds arrive,
                                             const std::stop_token& stop);
  template <class Bound>
  [[nodiscard]] graph::SearchTree sweep_back(core::Seconds depart, core::Seconds arrive,
                                             const std::stop_token& stop, bool closures_count,
                                             const Bound& bound);
  struct Found {
    core::Seconds depart;
    core::Seconds arrive;
    graph::SearchTree until_when;
  };
  const cost::Sea& sea_;
  const OpenGrid& open_;
  StraightBound straight_;
  motion::EdgeFan fan_;
  core::Metres longest_edge_{};
  core::Seconds longest_drive_{};
  core::MetresPerSecond through_water_;             // with the fastest propulsion
  std::optional<currents::NearbyCurrents> nearby_;  // empty: still water
  std::optional<Found> found_;
  VertexClosures closures_;
  std::array<KnownWay, 3> last_ways_;
  std::optional<FavourableBounds> own_at_any_time_;
  const FavourableBounds* at_any_time_;  // null: not made yet
  motion::FanTimes times_{};
  graph::Vertex tail_{no_vertex};  // tail of the edges that `least_time` timed last
  bool tail_is_known_{false};
};

/// Bounds of edges and of the remaining time, for a search that visits useful vertices only.
struct ForesightBound {
  Foresight& foresight;
  const FavourableBound& to_goal;
  const graph::SearchTree& until_when;  // result of `until_when_of_use`
  bool towards_goal{true};              // false: Dijkstra's order

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds depart) const {
    return foresight.least_time(edge, depart);
  }
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const {
    return towards_goal ? to_goal.remaining(v) : core::Seconds{0.0};
  }
  [[nodiscard]] core::Seconds latest_use(graph::Vertex v) const {
    return core::Seconds{rounding_of_times_s - until_when.arrival_s(v)};
  }
};

}  // namespace floeplan::planning::search
