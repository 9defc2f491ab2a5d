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

/// Velocity of the water at a place, m/s; empty: no water.
template <class F>
concept WaterAt = requires(const F& water, Vector place) {
  { water(place) } -> std::convertible_to<std::optional<Vector>>;
};

/// Conditions of one profile.
struct AdcpMoment {
  TrueState state{};  // mean over the pings
  Attitude sensed{};  // mean sensed attitude, including its constant errors
  double column_m{};  // water depth below the vehicle
  ReferenceError reference{};
};

/// Errors of a processed current profile without simulating pings. Mean, covariance between bins and
/// dependence on attitude equal those of `simulate_adcp_beams`, at the cost of about one ping.
/// Model    One ping stands for the mean of all. The water of each bin is sampled once, vertically below the
///          vehicle. Cells, bin mapping and the vehicle's motion smooth the profile: by its second derivative
///          times half their variance in depth. The noise is that of the mean over the pings, one deviate per
///          cell. The sensed attitude (constant errors and mean noise) is used for bin mapping and rotation
///          as in the processing. Its error then rotates the velocity relative to the vehicle, and takes the
///          shear at a wrong depth. The error of the reference is the same in all bins.
/// Left out sway to second order, differences between the beams' places, cells without echo
/// Cost     bins + 2 samples of the water and 4 (cells + 1) + 3 deviates; the beams need 20 times cells times
///          pings samples and (4 (cells + 1) + 6) times pings deviates
/// Memory   none allocated after construction
/// Threads  one at a time: it has a buffer for one profile
class AdcpErrorModel {
 public:
  /// Errors   std::invalid_argument for settings with violations
  explicit AdcpErrorModel(const AdcpSettings& settings);

  /// The processed profile over ground, from the vehicle downwards: only bins that three beams reach. Valid
  /// until the next call.
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
  std::vector<std::optional<Vector>> truth_;  // water in the bins from -1 to `cells`
  std::array<CellNoise, janus_beams> noise_{};
  std::vector<avoidance::CurrentBin> bins_;
};

}  // namespace floeplan::simulation
