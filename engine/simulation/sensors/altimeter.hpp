#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "engine/core/random.hpp"
#include "engine/core/violation.hpp"
#include "engine/simulation/sensors/sea_sound.hpp"
#include "engine/simulation/sensors/sonar.hpp"
#include "engine/simulation/vehicle/true_state.hpp"

namespace floeplan::simulation {

/// A single beam that looks down and reports its nearest echo.
/// Source of the defaults: the vendor's altimeter of a Slocum works at 170 kHz up to about 100 m and is
/// mounted so that it looks straight down at a dive's pitch of 26 degrees (Teledyne Webb Research, Slocum G2
/// operators manual, section on the altimeter); level and width are those of a common transducer of that
/// frequency. A ping for each cycle of the vehicle's computer, 4 s. Chosen without a source: a pulse about as
/// long as the range error, a blind zone of four pulses, and a threshold that noise practically never exceeds
struct AltimeterSettings {
  double frequency_khz{170.0};
  double source_level_db{190.0};
  double pulse_s{0.0002};
  double interval_s{4.0};
  double range_m{100.0};
  double blind_m{0.6};
  double width_rad{0.2094395};         // full width of its conical beam, 12 degrees
  double forward_cant_rad{0.4537856};  // tilt of the beam from the hull's down axis towards the bow
  double sea_bed_strength_db{-27.0};   // as for the sonar
  double threshold_db{12.0};           // least level of an echo above the noise; hardly any false alarms
  double range_sigma_m{0.1};           // error of a range: the vendor's resolution
  double false_echo_share{0.0};        // share of pings with an echo at a random range, as from fish
  SoundWater water{};

  [[nodiscard]] core::Violations violations() const;

  friend bool operator==(const AltimeterSettings&, const AltimeterSettings&) = default;
};

struct AltimeterEcho {
  double range_m{};     // along the beam
  double altitude_m{};  // range_m * cosine of the beam's angle from the vertical, by the given attitude

  friend bool operator==(const AltimeterEcho&, const AltimeterEcho&) = default;
};

/// Simulates the altimeter by the active sonar equation.
/// Model    seven rays represent the beam; the nearest one that exceeds the noise is the echo
/// Threads  const members may be called from several threads at once
class Altimeter {
 public:
  /// Errors   std::invalid_argument for settings with violations
  explicit Altimeter(const AltimeterSettings& settings);

  /// The echo of one ping; empty: none.
  template <CastRay Cast>
  [[nodiscard]] std::optional<AltimeterEcho> ping(const TrueState& state, const Cast& cast,
                                                  std::mt19937_64& rng) const {
    const BodyAxes axes{state.attitude};
    const Vector beam = axes.to_frame(rays_[0].forward, rays_[0].starboard, rays_[0].down);
    if (core::uniform(rng) < settings_.false_echo_share) {
      const double range_m = settings_.blind_m + core::uniform(rng) * (settings_.range_m - settings_.blind_m);
      return AltimeterEcho{range_m, range_m * std::max(0.0, beam.down)};
    }
    std::optional<double> nearest_m;
    for (const avoidance::BodyVector& ray : rays_) {
      const auto hit =
          cast(state.position, axes.to_frame(ray.forward, ray.starboard, ray.down), settings_.range_m);
      if (hit && is_heard(*hit) && (!nearest_m || hit->range_m < *nearest_m)) nearest_m = hit->range_m;
    }
    if (!nearest_m) return std::nullopt;
    const double range_m = std::max(0.0, *nearest_m + settings_.range_sigma_m * core::normal(rng));
    return AltimeterEcho{range_m, range_m * std::max(0.0, beam.down)};
  }

  [[nodiscard]] bool is_heard(const RayHit& hit) const;
  [[nodiscard]] const AltimeterSettings& settings() const { return settings_; }

 private:
  AltimeterSettings settings_;
  double absorption_db_m_{};
  double noise_db_{};
  double beam_sr_{};
  std::array<avoidance::BodyVector, 7> rays_{};  // the axis first
};

}  // namespace floeplan::simulation
