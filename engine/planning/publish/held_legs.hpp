#pragma once

#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::publish {

/// Times the legs of a route with holds, and of similar routes, for refinement. A leg that begins near the place of a hold
/// begins when the hold ends; no other leg waits. So each leg can be timed on its own, although a hold may be needed for
/// something that reopens several legs further on.
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
    core::Metres about;       // places so near count as this one
    core::Seconds no_sooner;  // the earliest departure from the place
  };
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> after_hold(geo::PlanePoint a,
                                                                           geo::PlanePoint b,
                                                                           core::Seconds depart,
                                                                           core::Seconds no_sooner) const;
  /// Whether the vehicle reaches the end at the time of the schedule.
  [[nodiscard]] bool keeps(const cost::Route& route, const cost::Schedule& schedule) const;

  const cost::Sea& sea_;
  std::vector<Hold> holds_;
};

}  // namespace floeplan::planning::publish
