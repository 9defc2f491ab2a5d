#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "engine/avoidance/sensed.hpp"
#include "engine/simulation/sensors/sonar_echo.hpp"
#include "engine/simulation/sensors/sonar_settings.hpp"
#include "engine/simulation/vehicle/true_state.hpp"

namespace floeplan::simulation {

/// Casts a ray of sound from a place along a unit vector: its first hit within a distance.
template <class F>
concept CastRay = requires(const F& cast, Vector origin, Vector direction, double max_range_m) {
  { cast(origin, direction, max_range_m) } -> std::same_as<std::optional<RayHit>>;
};

/// Simulates a forward-looking sonar by the active sonar equation.
/// Model    Rays fill the field of view. If one meets ice or sea bed at range r, the face there scatters by
///          Lambert's law. Its echo is SL - 2 TL + 10 lg(strength cos(angle) r^2 solid angle) + the two-way
///          pattern of every beam, with TL = 20 lg r + absorption r. Echoes in one beam and one range cell
///          add up in power. The background is noise, volume reverberation, the echo of the open surface in
///          the same cell, and all echoes there through side lobes. The receiver knows this background; its
///          threshold lies above it by the margin that gives the stated number of false alarms. Echo and
///          background fluctuate as sums of many scatterers (Rayleigh), so an echo with the mean
///          signal-to-background ratio s is detected with probability Pfa^(1 / (1 + s)). Direction an echo
///          belongs to the beams that hear it best: a beam that hears it 6 dB weaker than a neighbour gives
///          no return, as receivers look for peaks across their beams
/// Returns  ranges are the middles of range cells; adjacent cells above the threshold give one return, at the
///          nearest Left out refraction, multipath, motion during a ping
/// Memory   none allocated after construction
/// Threads  one at a time: it has a buffer for one ping
/// Source   Urick 1983, Principles of underwater sound, 3rd ed., chapters 2 and 8; Lambert's law for the sea
///          bed: Mackenzie 1961; Pd: Di Franco and Rubin 1968, Radar detection, Swerling case II
class Sonar {
 public:
  /// Errors   std::invalid_argument for settings with violations
  explicit Sonar(const SonarSettings& settings);

  /// The returns of one ping. The span is valid until the next ping.
  template <CastRay Cast>
  [[nodiscard]] std::span<const avoidance::SonarReturn> ping(const TrueState& state, const Cast& cast,
                                                             std::mt19937_64& rng);
  /// The returns of a ping that meets only the open surface. `ping` gives the same result, but more slowly.
  [[nodiscard]] std::span<const avoidance::SonarReturn> ping_in_open_water(std::mt19937_64& rng);

  /// Mean background level (noise and volume) in a range cell, dB re 1 uPa.
  [[nodiscard]] double background_db(double range_m) const;
  /// Level above the mean background at which an echo is detected, dB.
  [[nodiscard]] double threshold_db() const;
  /// Mean echo level, dB, of a perpendicular face that fills the beam on its axis.
  [[nodiscard]] double echo_of_wall_db(double range_m, double strength_db) const;

  [[nodiscard]] const SonarSettings& settings() const { return settings_; }
  [[nodiscard]] std::span<const avoidance::BodyVector> beams() const { return beams_; }
  [[nodiscard]] std::size_t rays() const { return rays_.size(); }
  [[nodiscard]] double cell_m() const { return cell_m_; }

 private:
  struct Ray {
    avoidance::BodyVector direction{};
    double solid_angle_sr{};
  };
  /// Sensitivity of a beam for a ray, minus the sensitivity of the beam's side lobes.
  struct Weight {
    std::uint32_t ray{};
    float two_way{};
  };
  /// Echo of a ray in a beam with full sensitivity.
  struct Heard {
    int cell{-1};  // -1: no echo
    double power{};
    bool open_surface{};
  };
  /// Mean powers in one cell of a beam from its main lobe.
  struct CellPower {
    float echo{};
    float surface{};
  };
  /// Range of cells: first cell, and one past the last.
  struct CellSpan {
    std::size_t begin{};
    std::size_t end{};
  };
  struct Spans {
    CellSpan heard;   // cells with any power
    CellSpan echoes;  // cells with echoes other than the open surface's
  };
  struct Detection {
    std::size_t beam{};
    int cell{};
    double level_db{};
  };

  void lay_beams();
  void lay_rays();
  void weigh_rays();
  void tabulate();
  [[nodiscard]] Heard heard(const Ray& ray, const RayHit& hit) const;
  void find_neighbours();
  void gather(std::size_t beam);
  [[nodiscard]] bool is_a_neighbours(std::size_t beam, std::size_t cell) const;
  void listen(std::size_t beam, std::mt19937_64& rng);
  void forget_powers();
  void add_false_alarms(std::mt19937_64& rng);
  void hand_out();

  SonarSettings settings_;
  double cell_m_{};
  int first_cell_{};  // that is not blind
  int cells_{};
  double absorption_db_m_{};
  double side_lobes_{};                       // two-way power of a side lobe
  double false_alarm_log_{};                  // natural logarithm of the probability in one cell of one beam
  std::vector<avoidance::BodyVector> beams_;  // axes, row by row
  std::vector<Ray> rays_;
  std::vector<std::vector<Weight>> weights_;  // [beam]
  std::vector<double> background_;            // [cell], power of noise and volume
  std::vector<double> echo_;                  // [cell], power from a steradian of a face of unit strength
  std::vector<double> surface_strength_;      // [sine of grazing angle], per square metre across the ray
  std::vector<Heard> heard_;                  // [ray]
  std::vector<double> total_;                 // [cell], power of all rays
  std::vector<CellPower> powers_;             // [beam][cell]; zero outside the spans
  std::vector<Spans> spans_;                  // [beam]
  std::vector<std::vector<std::size_t>> neighbours_;  // [beam]: the beams beside, above and below
  std::vector<Detection> detections_;
  std::vector<avoidance::SonarReturn> returns_;
};

template <CastRay Cast>
std::span<const avoidance::SonarReturn> Sonar::ping(const TrueState& state, const Cast& cast,
                                                    std::mt19937_64& rng) {
  const BodyAxes axes{state.attitude};
  detections_.clear();
  std::ranges::fill(total_, 0.0);
  bool anything = false;
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const avoidance::BodyVector& ray = rays_[i].direction;
    const auto hit =
        cast(state.position, axes.to_frame(ray.forward, ray.starboard, ray.down), settings_.range_m);
    heard_[i] = hit ? heard(rays_[i], *hit) : Heard{};
    if (heard_[i].cell < 0) continue;
    total_[static_cast<std::size_t>(heard_[i].cell)] += heard_[i].power;
    anything = anything || !heard_[i].open_surface;
  }
  if (anything) {
    for (std::size_t beam = 0; beam < beams_.size(); ++beam) gather(beam);
    for (std::size_t beam = 0; beam < beams_.size(); ++beam) listen(beam, rng);
    forget_powers();
  }
  add_false_alarms(rng);
  hand_out();
  return returns_;
}

}  // namespace floeplan::simulation
