#pragma once

#include <optional>

namespace floeplan::simulation {

/// What a ray of sound meets.
enum class Scatterer { ice, sea_bed, open_surface };

struct RayHit {
  double range_m{};
  double cosine{};  // of the angle between the ray, backwards, and the outward normal, 0 to 1
  Scatterer scatterer{Scatterer::ice};

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

}  // namespace floeplan::simulation
