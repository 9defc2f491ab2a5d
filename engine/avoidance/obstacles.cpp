#include "engine/avoidance/obstacles.hpp"

#include <algorithm>
#include <cmath>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr double patch_m = 0.75 * SurfaceCell::size_m;  // neighbouring patches overlap
constexpr double most_uncertainty_m =
    30.0;                                 // a surface less sure than that is not believed to be anywhere near
constexpr double most_growth_m_s = 0.05;  // what is seen again and again is corrected sooner
constexpr double growth_lasts_s = 300.0;

}  // namespace

motion::MovingDisc disc_of(const Obstacle& obstacle, double now_s, double until_s, double clearance_m) {
  // Doubt about the drift counts for a while only, spread over the span: what lies ahead is seen again by then.
  const double span_s = std::max(until_s - now_s, 1.0);
  const double growth = obstacle.growth_m_s * std::min(1.0, growth_lasts_s / span_s);
  return {now_s, until_s, obstacle.centre, obstacle.drift, obstacle.radius_m + clearance_m, growth};
}

void Obstacles::collect(const ObjectMap& objects, geo::PlanePoint own_in_water, double reach_m) {
  size_ = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const TrackedObject& object = objects[i];
    if (distance_m(object.centre(), own_in_water) - object.half_extent_m() > reach_m) continue;
    const double radius_m = patch_m + std::min(2.0 * object.place_sigma_m(), most_uncertainty_m);
    const double growth_m_s = std::min(object.drift_sigma_m_s(), most_growth_m_s);
    for (std::size_t k = 0; k < object.size(); ++k) {
      const SurfaceCell& cell = object.cell(k);
      if (cell.beside_other) continue;
      add({object.place(cell), object.drift(), radius_m, growth_m_s, false}, own_in_water);
    }
    // A berg is about as deep as it is wide: the disc over its visible face.
    const Obstacle body{object.centre(), object.drift(), object.half_extent_m(), growth_m_s, true};
    if (distance_m(body.centre, own_in_water) > body.radius_m) add(body, own_in_water);
  }
}

void Obstacles::add(const Obstacle& obstacle, geo::PlanePoint vehicle) {
  if (size_ < most) {
    list_[size_++] = obstacle;
    return;
  }
  const auto farthest = std::ranges::max_element(
      list_, {}, [&](const Obstacle& known) { return distance_m(known.centre, vehicle) - known.radius_m; });
  if (distance_m(farthest->centre, vehicle) > distance_m(obstacle.centre, vehicle)) *farthest = obstacle;
}

std::optional<double> Obstacles::nearest_m(geo::PlanePoint place) const {
  std::optional<double> nearest;
  for (const Obstacle& obstacle : all()) {
    if (obstacle.is_guess) continue;
    const double apart_m = distance_m(obstacle.centre, place) - obstacle.radius_m;
    if (!nearest || apart_m < *nearest) nearest = apart_m;
  }
  return nearest;
}

}  // namespace floeplan::avoidance
