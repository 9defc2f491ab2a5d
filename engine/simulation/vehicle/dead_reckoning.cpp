#include "engine/simulation/vehicle/dead_reckoning.hpp"

#include <cmath>

#include "engine/core/random.hpp"
#include "engine/messages/fault.hpp"

namespace floeplan::simulation {
namespace {

/// Before this time a dive has no steady mean speed.
constexpr core::Seconds under_way{60.0};
/// Fixes closer in time show their errors rather than the drift.
constexpr core::Seconds shortest_drift{30.0};
/// A shorter dive gives no useful estimate of the current.
constexpr core::Seconds shortest_dive{120.0};

}  // namespace

core::Violations NavigationErrors::violations() const {
  messages::Faults faults{"/navigation/"};
  faults.within(compass.value, 0.0, 0.5, "compass_deg", "0", "28.6 degrees");
  faults.within(speed_share, 0.0, 0.5, "speed_share", "0", "0.5");
  faults.within(fix.value, 0.0, 1000.0, "fix_m", "0", "1000 m");
  faults.within(current.value, 0.0, 2.0, "current_m_s", "0", "2 m/s");
  return faults.found();
}

DeadReckoning::DeadReckoning(const NavigationErrors& errors, Vector fix, Vector assumed_current,
                             bool corrects, std::uint64_t seed)
    : errors_{errors},
      corrects_{corrects},
      rng_{core::random_stream(seed, "navigation")},
      place_{fix},
      current_{assumed_current} {
  compass_rad_ = errors.compass.value * core::normal(rng_);
  speed_factor_ = 1.0 + errors.speed_share * core::normal(rng_);
}

void DeadReckoning::dive(core::UtcTime time) {
  dived_ = time;
  has_dived_ = true;
  has_first_fix_ = false;
  through_water_m_ = 0.0;
  under_water_ = core::Seconds{0.0};
  reckoned_with_ = assumed_current();
}

void DeadReckoning::advance(double heading_rad, double speed_m_s, core::Seconds step) {
  const double heading = measured_heading_rad(heading_rad);
  const double way_m = speed_m_s * speed_factor_ * step.count();
  through_water_m_ += way_m;
  under_water_ += step;
  place_ = place_ + Vector{way_m * std::sin(heading), way_m * std::cos(heading), 0.0} +
           step.count() * reckoned_with_;
}

void DeadReckoning::surface(core::UtcTime time) {
  surfaced_ = time;
  came_up_at_ = place_;
}

void DeadReckoning::fix(Vector true_place, core::UtcTime time) {
  const Vector fixed{true_place.east + errors_.fix.value * core::normal(rng_),
                     true_place.north + errors_.fix.value * core::normal(rng_), 0.0};
  place_ = fixed;
  if (!has_dived_ || surfaced_ < dived_ || surfaced_ - dived_ < shortest_dive) return;

  Vector drift{};
  if (!has_first_fix_) {
    has_first_fix_ = true;
    first_fix_ = fixed;
    first_fix_time_ = time;
  } else if (time - first_fix_time_ >= shortest_drift) {
    drift = (1.0 / (time - first_fix_time_).count()) * (fixed - first_fix_);
  }
  const Vector came_up = first_fix_ - (first_fix_time_ - surfaced_).count() * drift;
  current_ = reckoned_with_ + (1.0 / (surfaced_ - dived_).count()) * (came_up - came_up_at_);
}

double DeadReckoning::sigma_m(core::UtcTime time) const {
  if (!has_dived_ || has_first_fix_) return errors_.fix.value;
  const double turned = std::hypot(errors_.compass.value, errors_.speed_share);
  const double adrift_s = (time - dived_).count();
  return std::hypot(errors_.fix.value, turned * through_water_m_, errors_.current.value * adrift_s);
}

std::optional<double> DeadReckoning::mean_speed_m_s() const {
  if (under_water_ < under_way) return std::nullopt;
  return through_water_m_ / under_water_.count();
}

}  // namespace floeplan::simulation
