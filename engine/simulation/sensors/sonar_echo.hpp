#pragma once

#include <optional>

namespace floeplan::simulation {

/// The kinds of surface that a ray of sound can meet.
enum class Scatterer { ice, sea_bed, open_surface };

struct RayHit {
  double range_m{};
  double cosine{};  // of the angle between the reversed ray and the outward normal, 0 to 1
  Scatterer scatterer{Scatterer::ice};

  friend bool operator==(const RayHit&, const RayHit&) = default;
};

}  // namespace floeplan::simulation
