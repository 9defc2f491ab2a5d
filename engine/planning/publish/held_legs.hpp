#pragma once

#include <tl/expected.hpp>
#include <vector>

#include "engine/motion/edge_closed.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::publish {

/// Times the legs of a route with holds, and of routes like it, in the shape that refinement wants: whoever leaves from
/// about a place of a hold leaves about when the hold ends, and nobody waits anywhere else. So each leg stands for
/// itself, although a hold may serve what opens several legs further on.
class HeldLegs {
 public:
  /// `schedule`: the earliest one of the route. Both of these are not needed afterwards, the sea is borrowed.
  HeldLegs(const cost::Sea& sea, const cost::Route& route, const cost::Schedule& schedule);

  /// From the departure to the end, with the hold.
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> operator()(geo::PlanePoint a,
                                                                           geo::PlanePoint b,
                                                                           core::Seconds depart) const;

 private:
  struct Hold {
    geo::PlanePoint place;
    core::Metres about;       // the places that count as this one
    core::Seconds no_sooner;  // left
  };
  [[nodiscard]] tl::expected<core::Seconds, motion::EdgeClosed> after_hold(geo::PlanePoint a,
                                                                           geo::PlanePoint b,
                                                                           core::Seconds depart,
                                                                           core::Seconds no_sooner) const;
  /// Whether the vehicle is at the end when the schedule says.
  [[nodiscard]] bool keeps(const cost::Route& route, const cost::Schedule& schedule) const;

  const cost::Sea& sea_;
  std::vector<Hold> holds_;
};

}  // namespace floeplan::planning::publish
