#include "engine/simulation/flight/equipped_vehicle.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/core/random.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::simulation {
namespace {

constexpr core::Seconds log_every{60.0};
constexpr core::Seconds log_profile_every{600.0};
constexpr double no_bed_m = 1e5;  // depth used where no sea bed is known: deeper than any sea

/// A reading is taken at the step nearest to its time, because steps of a second may miss the exact time.
constexpr core::Seconds step_slack{0.5};

Attitude attitude_of(const avoidance::Attitude& attitude) {
  return {attitude.heading.value, attitude.pitch.value, attitude.roll.value};
}

}  // namespace

bool EquippedVehicle::Clock::is_due(core::UtcTime time) {
  if (next_ && time + step_slack < *next_) return false;
  next_ = (next_ && time - *next_ < interval_ ? *next_ : time) + interval_;
  return true;
}

EquippedVehicle::EquippedVehicle(const Equipment& equipment, const World& world, std::uint64_t seed,
                                 const std::optional<SystemOnBoard>& system, std::stop_token stop)
    : sonar_{equipment.sonar},
      altimeter_{equipment.altimeter},
      adcp_{equipment.adcp},
      rays_{world, {std::max(sonar_.settings().range_m, altimeter_.settings().range_m)}},
      stop_{std::move(stop)},
      sonar_rng_{core::random_stream(seed, "sonar")},
      altimeter_rng_{core::random_stream(seed, "altimeter")},
      adcp_rng_{core::random_stream(seed, "adcp")},
      ping_due_{core::Seconds{sonar_.settings().interval_s}},
      altitude_due_{core::Seconds{altimeter_.settings().interval_s}},
      profile_due_{core::Seconds{adcp_.settings().interval_s}},
      log_ping_{log_every},
      log_altitude_{log_every},
      log_profile_{log_profile_every} {
  if (system) system_.emplace(system->waypoints, system->forecast, system->settings);
}

OnBoardAnswer EquippedVehicle::step(const FlightView& view) {
  avoidance::Sensed sensed{.own = view.own};
  if (view.own.at_surface) {
    altitude_.reset();
  } else {
    const core::UtcTime time = view.truth.time;
    const bool pings = system_ && ping_due_.is_due(time);
    const bool sounds = altitude_due_.is_due(time);
    if (pings || sounds) rays_.look_from(view.truth.position, time);
    if (sounds) sound(view);
    if (pings) hear(view, sensed);
    if (system_ && profile_due_.is_due(time)) profile_current(view, sensed);
  }
  sensed.own.altitude = altitude_;
  OnBoardAnswer answer{.guidance = {}, .altitude = altitude_};
  if (system_) answer.guidance = system_->step(sensed, stop_);
  return answer;
}

void EquippedVehicle::sound(const FlightView& view) {
  altitude_.reset();
  const auto echo = altimeter_.ping(view.truth, rays_, altimeter_rng_);
  if (!echo) return;
  altitude_ = core::Metres{echo->altitude_m};
  if (log_altitude_.is_due(view.truth.time)) log_.altimeter.push_back({view.truth.time, echo->altitude_m});
}

void EquippedVehicle::hear(const FlightView& view, avoidance::Sensed& sensed) {
  const auto returns = rays_.is_open_water() ? sonar_.ping_in_open_water(sonar_rng_)
                                             : sonar_.ping(view.truth, rays_, sonar_rng_);
  sensed.sonar = avoidance::SonarPing{view.truth.time, returns};
  if (returns.empty() || !log_ping_.is_due(view.truth.time)) return;
  const auto nearest = std::ranges::min_element(returns, {}, &avoidance::SonarReturn::range);
  log_.sonar.push_back({view.truth.time, static_cast<int>(returns.size()), nearest->range.value});
}

void EquippedVehicle::profile_current(const FlightView& view, avoidance::Sensed& sensed) {
  const TrueState& truth = view.truth;
  const double elapsed_s =
      last_profile_ ? (truth.time - *last_profile_).count() : std::numeric_limits<double>::infinity();
  reference_ = next_reference_error(adcp_.settings(), reference_, elapsed_s, adcp_rng_);
  last_profile_ = truth.time;
  const auto bed_m = view.world.bed_depth_m(truth.position.east, truth.position.north);
  const AdcpMoment moment{.state = truth,
                          .sensed = attitude_of(view.own.attitude),
                          .column_m = bed_m ? *bed_m - truth.position.down : no_bed_m,
                          .reference = reference_};
  const auto bins =
      adcp_.profile(moment, [&](Vector place) { return view.world.current(place, truth.time); }, adcp_rng_);
  if (bins.empty()) return;
  sensed.current = avoidance::CurrentProfile{truth.time, bins};
  if (!log_profile_.is_due(truth.time)) return;
  for (const avoidance::CurrentBin& bin : bins)
    log_.currents.push_back({truth.time, bin.depth.value, bin.velocity, bin.one_sigma});
}

}  // namespace floeplan::simulation
