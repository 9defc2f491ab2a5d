#pragma once

#include <vector>

#include "engine/graph/interval_search.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// The sea between the vertices of a graph, for a vehicle that may stay for as long as it can keep its place: the model
/// of `graph::find_earliest_among_intervals`.
/// `Places`  point(vertex); `Bound`  least_time(edge, depart) and remaining(vertex), as graph::TravelTimeBound
template <class Places, class Bound>
class SeaIntervals {
 public:
  /// `source`: where the vehicle is at the beginning of `within`, outside which nothing is looked at. Everything else is
  /// borrowed.
  SeaIntervals(const Sea& sea, const Places& places, const Bound& bound, graph::Vertex source,
               TimeSpan within)
      : sea_{sea}, places_{places}, bound_{bound}, source_{places.point(source)}, within_{within} {}

  [[nodiscard]] std::vector<graph::SafeInterval> safe_intervals(graph::Vertex v) const {
    const geo::PlanePoint place = places_.point(v);
    const core::Seconds earliest = within_.from + sea_.least_time(source_, place);
    if (earliest > within_.until) return {};
    return cost::safe_intervals(sea_, place, {earliest, within_.until});
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
    return core::Seconds{bound_.least_time(edge, within_.from)}.count();
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
  geo::PlanePoint source_;
  TimeSpan within_;
};

}  // namespace floeplan::planning::cost
