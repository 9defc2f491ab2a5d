#pragma once

#include <optional>

#include "engine/geo/local_projection.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/ice/ice_covers.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::simulation {

/// Sea ice above a flight, as the depth of its underside: none, a level sheet, or the deepest keels of an ice
/// field. These are the keels that a plan with the same rules keeps below; where that plan may surface the
/// water is open.
/// Threads  const members may be called from several threads at once
class IceLayer {
 public:
  IceLayer() = default;  // open water
  explicit IceLayer(core::Metres draft) : even_m_{draft.value} {}
  /// `environment` must have ice.
  IceLayer(const ocean::Environment& environment, const planning::UnderIceRules& rules,
           const geo::LocalProjection& projection, const planning::plane::PlaneBox& area,
           core::UtcTime epoch);

  /// Whether there is ice anywhere at any time.
  [[nodiscard]] bool has_ice() const { return cover_.has_value() || even_m_ > 0.0; }
  /// Depth of the underside; zero in open water, where ice was never known, and outside the area.
  [[nodiscard]] double draft_m(double east_m, double north_m, core::UtcTime time) const {
    if (!cover_) return even_m_;
    if (!area_.contains({east_m, north_m})) return 0.0;
    return cover_->above({east_m, north_m}, time - epoch_).draft_m;
  }

 private:
  double even_m_{};
  core::UtcTime epoch_{};
  std::optional<planning::ice::IceCovers> cover_{};
  planning::plane::PlaneBox area_{};
};

}  // namespace floeplan::simulation
