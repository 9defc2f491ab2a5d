#include "engine/avoidance/echo.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floeplan::avoidance {
namespace {

constexpr double straight_down = std::numbers::pi / 2.0;

}  // namespace

LevelVector levelled(const BodyVector& body, const Attitude& attitude) {
  const double sin_h = std::sin(attitude.heading.value);
  const double cos_h = std::cos(attitude.heading.value);
  const double sin_p = std::sin(attitude.pitch.value);
  const double cos_p = std::cos(attitude.pitch.value);
  const double sin_r = std::sin(attitude.roll.value);
  const double cos_r = std::cos(attitude.roll.value);
  // First roll and pitch: the result is ahead, to starboard of the heading, and down.
  const double aside = cos_r * body.starboard - sin_r * body.down;
  const double below = sin_r * body.starboard + cos_r * body.down;
  const double ahead = cos_p * body.forward + sin_p * below;
  const double down = cos_p * below - sin_p * body.forward;
  return {sin_h * ahead + cos_h * aside, cos_h * ahead - sin_h * aside, down};
}

Echo placed(const SonarReturn& sonar, const OwnState& own, geo::PlanePoint own_in_water,
            const SonarView& view) {
  const LevelVector beam = levelled(sonar.beam, own.attitude);
  const double range_m = sonar.range.value;
  const double below_level = std::asin(std::clamp(beam.down, -1.0, 1.0));
  const double in_view = std::asin(std::clamp(-sonar.beam.down, -1.0, 1.0)) - view.tilt.value;
  const double inner = view.beam_half_height.value;
  const double outer = std::max(inner, view.edge_half_height.value);
  const auto depth_at = [&](double angle) {
    return own.depth.value + range_m * std::sin(std::clamp(angle, -straight_down, straight_down));
  };
  return {{own_in_water.x_m + range_m * beam.east, own_in_water.y_m + range_m * beam.north},
          own.depth.value + range_m * beam.down,
          range_m,
          depth_at(below_level - (in_view >= view.edge.value ? outer : inner)),
          depth_at(below_level + (in_view <= -view.edge.value ? outer : inner))};
}

bool is_usable(const SonarReturn& sonar, core::Metres reach) {
  return std::isfinite(sonar.range.value) && sonar.range.value > 0.0 && sonar.range <= reach &&
         std::isfinite(sonar.beam.forward) && std::isfinite(sonar.beam.starboard) &&
         std::isfinite(sonar.beam.down);
}

}  // namespace floeplan::avoidance
