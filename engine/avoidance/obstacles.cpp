#include "engine/avoidance/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr double patch_m = 0.75 * SurfaceCell::size_m;  // so that neighbouring patches overlap
constexpr double most_uncertainty_m =
    30.0;  // position error in metres beyond which a detected surface is ignored
constexpr double most_growth_m_s = 0.05;  // what is seen again and again is corrected sooner
constexpr double growth_lasts_s = 300.0;

double apart_m(const Obstacle& obstacle, geo::PlanePoint place) {
  return distance_m(obstacle.centre, place) - obstacle.radius_m;
}

/// Calls `take` for the surfaces within reach, object by object, and for guessed surfaces behind them.
template <class Take>
void for_each_patch(const ObjectMap& objects, geo::PlanePoint own_in_water, double reach_m,
                    const Take& take) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const TrackedObject& object = objects[i];
    if (distance_m(object.centre(), own_in_water) - object.half_extent_m() > reach_m) continue;
    const double radius_m = patch_m + std::min(2.0 * object.place_sigma_m(), most_uncertainty_m);
    const double growth_m_s = std::min(object.drift_sigma_m_s(), most_growth_m_s);
    for (std::size_t k = 0; k < object.size(); ++k) {
      const SurfaceCell& cell = object.cell(k);
      if (!cell.beside_other) take({object.place(cell), object.drift(), radius_m, growth_m_s, false});
    }
    // A berg is about as deep as it is wide, so its body is guessed as a disc over its visible face.
    const Obstacle body{object.centre(), object.drift(), object.half_extent_m(), growth_m_s, true};
    if (apart_m(body, own_in_water) > 0.0) take(body);
  }
}

}  // namespace

motion::MovingDisc disc_of(const Obstacle& obstacle, double now_s, double until_s, double clearance_m) {
  // The uncertainty of the drift grows for a limited time only, because objects ahead are seen again by then.
  const double span_s = std::max(until_s - now_s, 1.0);
  const double growth = obstacle.growth_m_s * std::min(1.0, growth_lasts_s / span_s);
  return {now_s, until_s, obstacle.centre, obstacle.drift, obstacle.radius_m + clearance_m, growth};
}

void Obstacles::collect(const ObjectMap& objects, geo::PlanePoint own_in_water, double reach_m) {
  size_ = 0;
  const double within_m = farthest_taken_m(objects, own_in_water, reach_m);
  for_each_patch(objects, own_in_water, reach_m, [&](const Obstacle& obstacle) {
    if (size_ < most && apart_m(obstacle, own_in_water) <= within_m) list_[size_++] = obstacle;
  });
}

double Obstacles::farthest_taken_m(const ObjectMap& objects, geo::PlanePoint own_in_water, double reach_m) {
  std::size_t count = 0;
  for_each_patch(objects, own_in_water, reach_m,
                 [&](const Obstacle& obstacle) { distances_m_[count++] = apart_m(obstacle, own_in_water); });
  if (count <= most) return std::numeric_limits<double>::infinity();
  const auto last = distances_m_.begin() + (most - 1);
  std::nth_element(distances_m_.begin(), last, distances_m_.begin() + static_cast<std::ptrdiff_t>(count));
  return *last;
}

std::optional<double> Obstacles::nearest_m(geo::PlanePoint place) const {
  std::optional<double> nearest;
  for (const Obstacle& obstacle : all()) {
    if (obstacle.is_guess) continue;
    const double gap_m = apart_m(obstacle, place);
    if (!nearest || gap_m < *nearest) nearest = gap_m;
  }
  return nearest;
}

}  // namespace floeplan::avoidance
