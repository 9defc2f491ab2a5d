#pragma once

#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::publish {

/// Times the legs of a route with holds, and of similar routes, for refinement. A leg that begins near the place of a hold
/// begins when the hold ends by the schedule; no other leg waits. So each leg can be timed on its own, although a hold may
/// be needed for something that reopens several legs further on. Whoever moves places times the holds again afterwards.
class HeldLegs {
 public:
  /// `schedule`: the earliest one of the route. Route and schedule are not kept; the sea is borrowed.
  HeldLegs(const cost::Sea& sea, const cost::Route& route, const cost::Schedule& schedule);

  /// The time from the departure to the end, with the holds.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> operator()(geo::PlanePoint a,
                                                                           geo::PlanePoint b,
                                                                           core::Seconds depart) const;

 private:
  struct Hold {
    geo::PlanePoint place;
    core::Metres about;  // places so near count as this one
    core::Seconds ends;  // by the schedule
  };

  const cost::Sea& sea_;
  std::vector<Hold> holds_;
};

}  // namespace floeplan::planning::publish
