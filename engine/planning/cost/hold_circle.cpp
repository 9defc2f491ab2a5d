#include "engine/planning/cost/hold_circle.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace floeplan::planning::cost {
namespace {

bool may_be_below_ice(const Sea& sea, geo::PlanePoint place) {
  return sea.domain().ice() && sea.domain().ice()->may_be_dense_along(place, place);
}

geo::PlanePoint beside(geo::PlanePoint centre, double x_m, double y_m) {
  return {centre.x_m + x_m, centre.y_m + y_m};
}

/// Whether no permanent closure cuts a straight line from the centre to one of the checked points of the rim.
bool is_open_to_rim(const Sea& sea, geo::PlanePoint centre, core::Metres radius) {
  if (sea.domain().closures().open_about(centre, radius)) return true;
  const double r_m = radius.value;
  const double d_m = r_m * std::sqrt(0.5);
  const std::array<geo::PlanePoint, 8> rim{beside(centre, r_m, 0.0),  beside(centre, d_m, d_m),
                                           beside(centre, 0.0, r_m),  beside(centre, -d_m, d_m),
                                           beside(centre, -r_m, 0.0), beside(centre, -d_m, -d_m),
                                           beside(centre, 0.0, -r_m), beside(centre, d_m, -d_m)};
  return std::ranges::none_of(
      rim, [&](geo::PlanePoint p) { return sea.domain().closures().closed_between(centre, p).has_value(); });
}

}  // namespace

HoldCircle::HoldCircle(const Sea& sea, geo::PlanePoint centre)
    : sea_{sea},
      centre_{centre},
      is_below_ice_{may_be_below_ice(sea, centre)},
      radius_{is_below_ice_ ? sea.holding().radius_below_ice.value_or(core::Metres{0.0})
                            : sea.holding().radius},
      looks_{centre, beside(centre, radius_.value, 0.0), beside(centre, -radius_.value, 0.0),
             beside(centre, 0.0, radius_.value), beside(centre, 0.0, -radius_.value)},
      is_open_{(!is_below_ice_ || sea.holding().radius_below_ice) && is_open_to_rim(sea, centre, radius_)} {}

bool HoldCircle::is_kept(core::Seconds time) const {
  if (is_below_ice_ && !sea_.domain().ice()->may_transit(centre_, time)) return false;
  if (sea_.domain().currents() == nullptr) return true;
  const double most_m_s = hold_share * sea_.through_water().value;
  return std::ranges::all_of(looks_, [&](geo::PlanePoint look) {
    const auto current = (*sea_.domain().currents())(look, time);
    return current && std::hypot(current->x_m_s, current->y_m_s) <= most_m_s;
  });
}

bool HoldCircle::is_always_kept() const {
  if (is_below_ice_) return false;
  if (sea_.domain().currents() == nullptr) return true;
  const auto calm = sea_.holding().calm;
  if (!calm) return false;
  const currents::CurrentEnvelope::Box box = calm->about(centre_);
  const double x_m_s = std::max(-box.low_x_m_s, box.high_x_m_s);
  const double y_m_s = std::max(-box.low_y_m_s, box.high_y_m_s);
  return std::hypot(x_m_s, y_m_s) <= hold_share * sea_.through_water().value;
}

std::vector<TimeSpan> HoldCircle::closed_times() const {
  std::vector<TimeSpan> closed = sea_.domain().closures().closed_times_by_icebergs(centre_, radius_);
  for (const geo::PlanePoint look : looks_)
    std::ranges::copy(sea_.domain().closures().closed_times_by_zones(look), std::back_inserter(closed));
  return joined(std::move(closed));
}

}  // namespace floeplan::planning::cost
