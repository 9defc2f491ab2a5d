#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "engine/avoidance/object_map.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/motion/disc_encounter.hpp"

namespace floeplan::avoidance {

/// A patch of a detected surface that must not be touched, as a disc. It moves, and grows with the
/// uncertainty of its drift. Frame: water.
struct Obstacle {
  geo::PlanePoint centre{};
  geo::PlaneVelocity drift{};
  double radius_m{};    // radius of the patch plus two standard deviations of its place
  double growth_m_s{};  // one standard deviation of its drift
  bool is_guess{};      // a guess behind the seen surface; used by path planning only

  friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

/// The obstacle's disc from `now_s` to `until_s`, enlarged by `clearance_m`.
[[nodiscard]] motion::MovingDisc disc_of(const Obstacle& obstacle, double now_s, double until_s,
                                         double clearance_m);

/// The obstacles near the vehicle.
/// Memory   fixed; no member allocates. If there are more, the farthest are left out
class Obstacles {
 public:
  static constexpr std::size_t most = 768;

  /// Collects the surfaces within `reach_m` of the vehicle.
  void collect(const ObjectMap& objects, geo::PlanePoint own_in_water, double reach_m);

  [[nodiscard]] std::span<const Obstacle> all() const { return {list_.data(), size_}; }
  /// Distance from a place to the nearest surface; empty if there is none.
  [[nodiscard]] std::optional<double> nearest_m(geo::PlanePoint place) const;

 private:
  static constexpr std::size_t most_patches = ObjectMap::most_objects * (TrackedObject::most_cells + 1);

  [[nodiscard]] double farthest_taken_m(const ObjectMap& objects, geo::PlanePoint own_in_water,
                                        double reach_m);

  std::array<Obstacle, most> list_{};
  std::array<double, most_patches> distances_m_{};
  std::size_t size_{};
};

}  // namespace floeplan::avoidance
