#pragma once

#include <vector>

#include "engine/graph/interval_search.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// Edge times between the vertices of a graph for a vehicle that may hold: the model of
/// `graph::find_earliest_among_intervals`.
/// `Places`  point(vertex): the vertex's place in the plane
/// `Bound`   least_time(edge, depart) and remaining(vertex), as graph::TravelTimeBound. of_use(vertex): the
/// span outside which no vehicle can be at the vertex and still reach the goal in time
template <class Places, class Bound>
class SeaIntervals {
 public:
  /// `depart`: departure from the start. Everything else is borrowed.
  SeaIntervals(const Sea& sea, const Places& places, const Bound& bound, core::Seconds depart)
      : sea_{sea}, places_{places}, bound_{bound}, depart_{depart} {}

  [[nodiscard]] std::vector<graph::SafeInterval> safe_intervals(graph::Vertex v) const {
    const TimeSpan of_use = bound_.of_use(v);
    if (of_use.from > of_use.until) return {};
    return cost::safe_intervals(sea_, places_.point(v), of_use);
  }
  [[nodiscard]] graph::DepartureLook first_open(const graph::Edge& edge, double from_s, double until_s,
                                                double arrive_from_s) const {
    const OpenLegLook look =
        next_open_leg(sea_, places_.point(edge.tail), places_.point(edge.head),
                      {core::Seconds{from_s}, core::Seconds{until_s}}, core::Seconds{arrive_from_s});
    if (!look.leg) return {std::nullopt, look.looked_until.count()};
    return {departure_of(*look.leg), look.looked_until.count()};
  }
  [[nodiscard]] graph::OpenDeparture open_until(const graph::Edge& edge, const graph::OpenDeparture& open,
                                                double until_s, double arrive_until_s) const {
    const OpenLeg leg{core::Seconds{open.depart_s}, core::Seconds{open.arrive_s - open.depart_s}};
    return departure_of(open_leg_until(sea_, places_.point(edge.tail), places_.point(edge.head), leg,
                                       core::Seconds{until_s}, core::Seconds{arrive_until_s}));
  }
  [[nodiscard]] double least_time_s(const graph::Edge& edge) const {
    return core::Seconds{bound_.least_time(edge, depart_)}.count();
  }
  [[nodiscard]] double remaining_s(graph::Vertex v) const {
    return core::Seconds{bound_.remaining(v)}.count();
  }

 private:
  static graph::OpenDeparture departure_of(const OpenLeg& leg) {
    return {leg.depart.count(), leg.arrival().count()};
  }

  const Sea& sea_;
  const Places& places_;
  const Bound& bound_;
  core::Seconds depart_;
};

}  // namespace floeplan::planning::cost
