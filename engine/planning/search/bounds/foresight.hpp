#pragma once

#include <limits>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/graph/search_tree.hpp"
#include "engine/planning/currents/nearby_currents.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/grid/vertex_closures.hpp"

namespace floeplan::planning::search {

/// What a search over a grid can know before an edge is timed exactly, from times of all edges out of a vertex at
/// once. Two sweeps, each at many times the speed of the exact search: one forwards on estimates, whose way is all
/// but the best; one backwards on proven bounds, which tells of each vertex until when it is of use.
/// Threads  one at a time
class Foresight {
 public:
  static constexpr graph::Vertex no_vertex = std::numeric_limits<graph::Vertex>::max();

  /// `sea` and `open` are borrowed and outlive this. `ahead`: what is found for an arrival is made to serve for those
  /// up to so much later, too: less sharp, but found once.
  Foresight(const cost::Sea& sea, const OpenGrid& open, core::Seconds ahead = core::Seconds{0.0});

  /// Whether the bounds say more than a straight line with the strongest current astern.
  [[nodiscard]] bool is_useful() const { return !nearby_ || nearby_->is_useful(); }

  /// What an estimated way minds besides what is closed at all times.
  struct Minding {
    bool timed_closures{false};         // as far as an even drive along each edge meets them
    std::vector<graph::Edge> barred{};  // edges not to be taken, a few
  };
  /// A way from start to goal that is likely to be about the best, edge by edge; empty where none is seen or once
  /// `stop` is requested. Not proven open.
  [[nodiscard]] std::vector<graph::Edge> likely_way(core::Seconds depart, const std::stop_token& stop,
                                                    const Minding& minding);

  /// Until when a vertex is of use to who leaves the start at `depart` and is to be at the goal by `arrive`, on the
  /// film run backwards: the tree's arrival at the vertex is the time -t. Not reached: it is of no use.
  /// Law      no way of open legs that is at the goal in time is at a vertex later than that. So far as the legs'
  ///          own currents go: a leg that is closed for a while counts as if it were open
  /// Returns  borrowed, until it is asked for again
  [[nodiscard]] const graph::SearchTree& until_when_of_use(core::Seconds depart, core::Seconds arrive,
                                                           const std::stop_token& stop);

  /// No vehicle that leaves the start at `depart` is at a vertex before the tree's arrival there, and none is of use to
  /// the goal by `arrive` at one that is not reached. Nobody is at a vertex while it is closed; otherwise as above.
  [[nodiscard]] graph::SearchTree sweep_forth(core::Seconds depart, core::Seconds arrive,
                                              const std::stop_token& stop, VertexClosures& closures);
  /// As `until_when_of_use` for these two times exactly, not kept, and nobody is at a vertex while it is closed: who
  /// comes to one too late for the last opening in time has to be there before the closure.
  /// `earliest`: of a sweep forth from the same departure to the same arrival or a later one
  [[nodiscard]] graph::SearchTree sweep_back(core::Seconds depart, core::Seconds arrive,
                                             const std::stop_token& stop, VertexClosures& closures,
                                             const graph::SearchTree& earliest);

  /// About how long each edge out of a vertex takes, by its step, for who leaves then on this drive; on a closed one
  /// long.
  /// Returns  borrowed, until the next question of any kind; null where nothing is known of the water
  [[nodiscard]] const motion::FanTimes* estimates(graph::Vertex v, core::Seconds depart,
                                                  vehicle::Drive drive);

  /// Never more than the time of an edge for who leaves its tail then. Fast for the edges of a vertex in a row.
  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds depart);

 private:
  enum class Fidelity { estimate, bound };
  /// Times all edges out of a vertex; false where nothing is known of the water.
  [[nodiscard]] bool look(graph::Vertex v, core::Seconds time, currents::NearbyCurrents::Film film,
                          Fidelity fidelity);
  /// The water about a vertex; empty where nothing is known of it.
  [[nodiscard]] std::optional<motion::NearbyCurrent> water_at(graph::Vertex v, core::Seconds time,
                                                              currents::NearbyCurrents::Film film);
  [[nodiscard]] core::Seconds proven(const graph::Edge& edge, bool is_known) const;
  [[nodiscard]] graph::SearchTree sweep_back(core::Seconds depart, core::Seconds arrive,
                                             const std::stop_token& stop);
  template <class Bound>
  [[nodiscard]] graph::SearchTree sweep_back(core::Seconds depart, core::Seconds arrive,
                                             const std::stop_token& stop, VertexClosures* closures,
                                             const Bound& bound);
  struct Found {
    core::Seconds depart;
    core::Seconds arrive;
    graph::SearchTree until_when;
  };
  const cost::Sea& sea_;
  const OpenGrid& open_;
  core::Seconds ahead_;
  StraightBound straight_;
  motion::EdgeFan fan_;
  core::Metres longest_edge_{};
  core::Seconds longest_drive_{};
  core::MetresPerSecond through_water_;             // on the fastest drive
  std::optional<currents::NearbyCurrents> nearby_;  // empty: still water
  std::optional<Found> found_;
  motion::FanTimes times_{};
  graph::Vertex tail_{no_vertex};  // of the edges in `least_time`
  bool tail_is_known_{false};
};

/// What a search knows of edges and of the rest of the way when it only looks at vertices that are of use.
struct ForesightBound {
  Foresight& foresight;
  const StraightBound& straight;
  const graph::SearchTree& until_when;  // of the foresight
  bool towards_goal{true};              // false: Dijkstra's order

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds depart) const {
    return foresight.least_time(edge, depart);
  }
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const {
    return towards_goal ? straight.remaining(v) : core::Seconds{0.0};
  }
  [[nodiscard]] core::Seconds latest_use(graph::Vertex v) const {
    return core::Seconds{rounding_of_times_s - until_when.arrival_s(v)};
  }
};

}  // namespace floeplan::planning::search
