#include "engine/planning/refinement/shortening.hpp"

#include <cmath>

#include "engine/planning/plane/plane_lines.hpp"

namespace floeplan::planning::refinement {
namespace {

double cross(geo::PlanePoint a, geo::PlanePoint b, geo::PlanePoint c, geo::PlanePoint d) {
  return (b.x_m - a.x_m) * (d.y_m - c.y_m) - (b.y_m - a.y_m) * (d.x_m - c.x_m);
}

/// The point where the extended lines a-p and b-q meet. Empty if they do not meet, or only far away.
std::optional<geo::PlanePoint> meeting(geo::PlanePoint a, geo::PlanePoint p, geo::PlanePoint q,
                                       geo::PlanePoint b) {
  constexpr double far = 10.0;  // multiple of the leg's length
  const double turn = cross(a, p, b, q);
  if (turn == 0.0) return std::nullopt;
  const double from_a = cross(a, b, b, q) / turn;
  const double from_b = cross(a, b, a, p) / turn;
  if (!(from_a >= 1.0 && from_b >= 1.0 && from_a <= far && from_b <= far)) return std::nullopt;
  return plane::place_between(a, p, from_a);
}

}  // namespace

std::vector<geo::PlanePoint> places_for_both(geo::PlanePoint a, geo::PlanePoint p, geo::PlanePoint q,
                                             geo::PlanePoint b) {
  // Multiples of the distance from the chord to the middle of the two points: judgements.
  constexpr double outwards[] = {1.0, 1.25, 1.5, 2.0, 3.0, 5.0};
  std::vector<geo::PlanePoint> places;
  if (const auto both_lead_there = meeting(a, p, q, b)) places.push_back(*both_lead_there);
  const geo::PlanePoint middle = plane::place_between(p, q, 0.5);
  const double chord2 = (b.x_m - a.x_m) * (b.x_m - a.x_m) + (b.y_m - a.y_m) * (b.y_m - a.y_m);
  if (chord2 == 0.0) return places;
  const double share =
      ((middle.x_m - a.x_m) * (b.x_m - a.x_m) + (middle.y_m - a.y_m) * (b.y_m - a.y_m)) / chord2;
  const geo::PlanePoint foot = plane::place_between(a, b, share);
  for (const double further : outwards) places.push_back(plane::place_between(foot, middle, further));
  return places;
}

}  // namespace floeplan::planning::refinement
