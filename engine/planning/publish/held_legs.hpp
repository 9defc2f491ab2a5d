#pragma once

#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::publish {

/// Times the legs of a route with holds, and of similar routes, for refinement. A leg that begins near the
/// place of a hold begins when that hold ends; no other leg has a hold. So each leg can be timed on its own,
/// although a hold may be needed for a closure several legs further on.
class HeldLegs {
 public:
  /// `schedule`: the earliest one of `route`. Both are used only during construction; `sea` is borrowed.
  HeldLegs(const cost::Sea& sea, const cost::Route& route, const cost::Schedule& schedule);

  /// The time from `depart`, at a, to the arrival at b, with the hold at a.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> operator()(geo::PlanePoint a,
                                                                           geo::PlanePoint b,
                                                                           core::Seconds depart) const;

 private:
  struct Hold {
    geo::PlanePoint place;
    core::Metres about;       // places within this distance count as this place
    core::Seconds no_sooner;  // the earliest departure from the place
  };
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> after_hold(geo::PlanePoint a,
                                                                           geo::PlanePoint b,
                                                                           core::Seconds depart,
                                                                           core::Seconds no_sooner) const;
  /// Whether the vehicle reaches the route's end at the time in the schedule.
  [[nodiscard]] bool keeps(const cost::Route& route, const cost::Schedule& schedule) const;

  const cost::Sea& sea_;
  std::vector<Hold> holds_;
};

}  // namespace floeplan::planning::publish
