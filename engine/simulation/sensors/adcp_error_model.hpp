#pragma once

#include <concepts>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "engine/avoidance/sensed.hpp"
#include "engine/simulation/sensors/adcp_noise.hpp"
#include "engine/simulation/sensors/adcp_settings.hpp"
#include "engine/simulation/sensors/janus.hpp"
#include "engine/simulation/vehicle/true_state.hpp"

namespace floeplan::simulation {

/// Velocity of the water at a place, m/s; empty where there is none.
template <class F>
concept WaterAt = requires(const F& water, Vector place) {
  { water(place) } -> std::convertible_to<std::optional<Vector>>;
};

/// One profile as it is asked for.
struct AdcpMoment {
  TrueState state{};  // mean over the pings
  Attitude sensed{};  // mean attitude as the vehicle senses it: its constant errors
  double column_m{};  // water below the vehicle
  ReferenceError reference{};
};

/// Errors of a current profile as measured and detected, without simulating pings: the same mean, covariance between
/// bins and dependence on attitude as `simulate_adcp_beams`, for the cost of about one of its pings.
/// Model    One ping stands for the mean of all. The water of each bin is taken once, on the vehicle's vertical; what
///          cells, bin mapping and the vehicle's way through the profile smooth away is the profile's second derivative
///          times half their variance in depth. The noise is that of the mean over the pings, one deviate for each
///          cell.
///          The attitude as sensed, its constant errors and the mean of its noise, does bin mapping and turning as in
///          the detection; what it does wrong is its error: the velocity relative to the vehicle turned, the shear
///          taken at the wrong depth. The reference's error is the same in all bins.
/// Left out sway to second order, differences between the beams' places, cells that fade
/// Cost     water is taken bins + 2 times, and 4 (cells + 1) + 3 deviates are drawn; the beams take water 20 times
///          cells times pings and draw (4 (cells + 1) + 6) times pings
/// Memory   none taken after construction
/// Threads  one at a time: it keeps room for a profile
class AdcpErrorModel {
 public:
  /// Errors   std::invalid_argument for settings with violations
  explicit AdcpErrorModel(const AdcpSettings& settings);

  /// The detected profile over ground, bins that three beams reach only, from the vehicle down; valid until the next.
  template <WaterAt Water>
  [[nodiscard]] std::span<const avoidance::CurrentBin> profile(const AdcpMoment& moment, const Water& water,
                                                               std::mt19937_64& rng) {
    truth_.clear();
    const Vector place = moment.state.position;
    for (int bin = -1; bin <= settings_.cells; ++bin) {
      truth_.push_back(water({place.east, place.north, place.down + bin_below_m(settings_, bin)}));
    }
    return detect(moment, rng);
  }

  [[nodiscard]] const AdcpSettings& settings() const { return settings_; }

 private:
  [[nodiscard]] std::span<const avoidance::CurrentBin> detect(const AdcpMoment& moment, std::mt19937_64& rng);
  void add_bin(const AdcpMoment& moment, int bin, const BinMapping& mapping, const JanusBeams& true_beams,
               const JanusBeams& sensed_beams);

  AdcpSettings settings_;
  std::vector<std::optional<Vector>> truth_;  // of bins -1 to cells
  std::array<CellNoise, janus_beams> noise_{};
  std::vector<avoidance::CurrentBin> bins_;
};

}  // namespace floeplan::simulation
