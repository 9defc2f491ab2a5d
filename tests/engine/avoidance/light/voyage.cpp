#include "tests/engine/avoidance/light/voyage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "engine/avoidance/echo.hpp"
#include "engine/avoidance/steering.hpp"
#include "engine/core/random.hpp"

namespace floeplan::support {
namespace {

using avoidance::BodyVector;

double rad(double angle_deg) { return core::degrees_to_radians(angle_deg); }

/// The sonar's beams, fixed to the body.
std::vector<BodyVector> beams_of(const LightSonar& sonar) {
  std::vector<BodyVector> beams;
  for (const double elevation_deg : sonar.elevations_deg) {
    for (double bearing_deg = -sonar.half_width_deg; bearing_deg <= sonar.half_width_deg + 1e-9;
         bearing_deg += sonar.bearing_step_deg) {
      beams.push_back({std::cos(rad(elevation_deg)) * std::cos(rad(bearing_deg)),
                       std::cos(rad(elevation_deg)) * std::sin(rad(bearing_deg)),
                       -std::sin(rad(elevation_deg))});
    }
  }
  return beams;
}

class LightFlight {
 public:
  LightFlight(const Flight& flight, const Watcher& watch)
      : flight_{flight},
        watch_{watch},
        system_{flight.waypoints, avoidance::CarriedForecast{flight.sea.forecast}, flight.settings},
        beams_{beams_of(flight.sonar)},
        water_rng_{core::random_stream(flight.seed, "water")},
        sonar_rng_{core::random_stream(flight.seed, "sonar")},
        adcp_rng_{core::random_stream(flight.seed, "adcp")} {
    auto rng = core::random_stream(flight.seed, "navigation");
    compass_bias_rad_ = rad(flight.vehicle.compass_sigma_deg) * core::normal(rng);
    speed_scale_ = 1.0 + flight.vehicle.speed_sigma * core::normal(rng);
    error_ = {{flight.sea.current_error_m_s * core::normal(water_rng_)},
              {flight.sea.current_error_m_s * core::normal(water_rng_)}};
    reckoned_ = flight.sea.forecast;
    place_.depth_m = flight.vehicle.shallowest_m;
    heading_rad_ = avoidance::direction_rad({0.0, 0.0}, flight.waypoints.front());
    seen_.resize(flight.sea.bodies.size());
  }

  FlightResult run() {
    for (time_s_ = 0.0; time_s_ < flight_.most_s; time_s_ += step_s) {
      place_bodies();
      if (collides()) return ended(Ending::collided);
      if (arrived()) return ended(Ending::arrived);
      guide();
      if (guided_.mode == avoidance::Mode::given_up) return ended(Ending::gave_up);
      if (watch_) watch_(time_s_, place_, guided_, system_);
      move();
    }
    return ended(Ending::too_long);
  }

 private:
  static constexpr double step_s = 1.0;
  static constexpr double arrived_m = 60.0;

  FlightResult ended(Ending ending) {
    result_.ending = ending;
    result_.time_s = time_s_;
    result_.last = place_;
    result_.reason = guided_.reason;
    result_.counters = system_.counters();
    return result_;
  }

  void place_bodies() {
    near_.clear();
    for (std::size_t i = 0; i < flight_.sea.bodies.size(); ++i) {
      const Body& body = flight_.sea.bodies[i];
      const PlacedBody placed = placed_at(body, time_s_, carried_);
      const double apart_m =
          std::hypot(placed.centre.east_m - place_.east_m, placed.centre.north_m - place_.north_m);
      if (apart_m < reach_m(body) + flight_.sonar.range_m) near_.push_back({i, placed});
    }
  }

  bool collides() {
    for (const Near& near : near_) {
      if (!is_inside(near.placed, place_, hull_m)) continue;
      result_.collided_with = near.index;
      result_.first_seen = seen_[near.index];
      return true;
    }
    return flight_.sea.bed_m && place_.depth_m > *flight_.sea.bed_m - hull_m;
  }

  /// Whether the vehicle has arrived by its own dead reckoning.
  bool arrived() {
    while (next_ < flight_.waypoints.size() &&
           geo::distance_m(believed_, flight_.waypoints[next_]) < arrived_m) {
      ++next_;
    }
    return next_ == flight_.waypoints.size() ||
           geo::distance_m(believed_, flight_.waypoints.back()) < arrived_m;
  }

  avoidance::OwnState own_state() const {
    avoidance::OwnState own;
    own.time = core::from_unix_seconds(1e9 + time_s_);
    own.place = believed_;
    own.depth = core::Metres{place_.depth_m};
    own.attitude = {core::Radians{heading_rad_ + compass_bias_rad_}, core::Radians{pitch_rad()},
                    core::Radians{0.0}};
    own.through_water = core::MetresPerSecond{flight_.vehicle.through_water_m_s * speed_scale_};
    if (flight_.sea.bed_m && *flight_.sea.bed_m - place_.depth_m < 100.0) {
      own.altitude = core::Metres{altitude_m()};
    }
    return own;
  }

  double pitch_rad() const { return (diving_ ? -1.0 : 1.0) * rad(flight_.vehicle.pitch_deg); }

  double altitude_m() const {
    double bed_m = *flight_.sea.bed_m - place_.depth_m;
    for (const Near& near : near_) {
      if (const auto hit = first_hit(near.placed, place_, {0.0, 0.0, 1.0})) bed_m = std::min(bed_m, *hit);
    }
    return bed_m;
  }

  void guide() {
    if (!flight_.avoids) {
      guided_ = {};
      return;
    }
    avoidance::Sensed sensed;
    sensed.own = own_state();
    if (std::fmod(time_s_, flight_.sonar.every_s) < step_s) {
      ping();
      sensed.sonar = avoidance::SonarPing{sensed.own.time, returns_};
    }
    if (std::fmod(time_s_, 60.0) == 0.0) {
      measure_current();
      sensed.current = avoidance::CurrentProfile{sensed.own.time, bins_};
    }
    guided_ = flight_.plans_paths ? system_.step(sensed) : system_.react(sensed);
    if (guided_.mode == avoidance::Mode::reactive) result_.reactive_s += step_s;
  }

  void ping() {
    returns_.clear();
    const avoidance::Attitude attitude{core::Radians{heading_rad_}, core::Radians{pitch_rad()},
                                       core::Radians{0.0}};
    for (const BodyVector& beam : beams_) {
      if (near_.empty() && !flight_.sea.bed_m) break;
      const avoidance::LevelVector level = avoidance::levelled(beam, attitude);
      const SeaPoint direction{level.east, level.north, level.down};
      double range_m = std::numeric_limits<double>::infinity();
      std::optional<std::size_t> met;
      for (const Near& near : near_) {
        const auto hit = first_hit(near.placed, place_, direction);
        if (!hit || *hit >= range_m) continue;
        range_m = *hit;
        met = near.index;
      }
      if (flight_.sea.bed_m && level.down > 0.0) {
        range_m = std::min(range_m, (*flight_.sea.bed_m - place_.depth_m) / level.down);
      }
      if (range_m > flight_.sonar.range_m) continue;
      const double faint = std::max(0.0, range_m / flight_.sonar.range_m - 0.75) / 0.25;
      if (core::uniform(sonar_rng_) > flight_.sonar.detection * (1.0 - 0.5 * faint)) continue;
      if (met && !seen_[*met]) seen_[*met] = Sighting{time_s_, place_, carried_, heading_rad_};
      hear(beam, range_m + flight_.sonar.range_sigma_m * core::normal(sonar_rng_));
    }
    const int false_alarms = core::poisson(sonar_rng_, flight_.sonar.false_alarms);
    for (int i = 0; i < false_alarms; ++i) {
      const auto which =
          static_cast<std::size_t>(core::uniform(sonar_rng_) * static_cast<double>(beams_.size()));
      hear(beams_[which], flight_.sonar.range_m * core::uniform(sonar_rng_));
    }
  }

  void hear(const BodyVector& beam, double range_m) {
    const double turn = rad(flight_.sonar.bearing_sigma_deg) * core::normal(sonar_rng_);
    const BodyVector heard{beam.forward * std::cos(turn) - beam.starboard * std::sin(turn),
                           beam.forward * std::sin(turn) + beam.starboard * std::cos(turn), beam.down};
    returns_.push_back({core::Metres{std::max(range_m, 0.5)}, heard, 90.0});
  }

  void measure_current() {
    bins_.clear();
    constexpr double sigma = 0.03;
    const geo::VelocityEn now = current();
    for (const double below_m : {5.0, 10.0, 15.0, 20.0}) {
      bins_.push_back({core::Metres{place_.depth_m + below_m},
                       {{now.east.value + sigma * core::normal(adcp_rng_)},
                        {now.north.value + sigma * core::normal(adcp_rng_)}},
                       core::MetresPerSecond{sigma}});
    }
  }

  geo::VelocityEn current() const {
    return {flight_.sea.forecast.east + error_.east, flight_.sea.forecast.north + error_.north};
  }

  double wished_heading() const {
    if (guided_.heading) return guided_.heading->value - compass_bias_rad_;
    const std::size_t target =
        std::min(std::max(next_, flight_.avoids ? guided_.waypoint : next_), flight_.waypoints.size() - 1);
    return avoidance::crab(avoidance::direction_rad(believed_, flight_.waypoints[target]), reckoned_,
                           flight_.vehicle.through_water_m_s)
        .heading_rad;
  }

  void move() {
    const double turn = std::remainder(wished_heading() - heading_rad_, 2.0 * std::numbers::pi);
    const double most = rad(flight_.vehicle.turn_deg_s) * step_s;
    heading_rad_ += std::clamp(turn, -most, most);

    const double v = flight_.vehicle.through_water_m_s;
    const geo::VelocityEn c = current();
    place_.east_m += step_s * (v * std::sin(heading_rad_) + c.east.value);
    place_.north_m += step_s * (v * std::cos(heading_rad_) + c.north.value);
    carried_.x_m += step_s * c.east.value;
    carried_.y_m += step_s * c.north.value;
    result_.way_m += step_s * std::hypot(v * std::sin(heading_rad_) + c.east.value,
                                         v * std::cos(heading_rad_) + c.north.value);

    // Dead reckoning of the vehicle: from its compass, its assumed speed, and the current between its last
    // two fixes.
    const double seen_heading = heading_rad_ + compass_bias_rad_;
    believed_.x_m += step_s * (v * speed_scale_ * std::sin(seen_heading) + reckoned_.east.value);
    believed_.y_m += step_s * (v * speed_scale_ * std::cos(seen_heading) + reckoned_.north.value);
    if (std::fmod(time_s_ + step_s, flight_.vehicle.fix_every_s) < step_s) take_fix();

    const double w = v * std::tan(rad(flight_.vehicle.pitch_deg));
    const double shallowest = guided_.shallowest ? guided_.shallowest->value : flight_.vehicle.shallowest_m;
    const double deepest = guided_.deepest ? guided_.deepest->value : flight_.vehicle.deepest_m;
    if (place_.depth_m <= shallowest) diving_ = true;
    if (place_.depth_m >= deepest) diving_ = false;
    place_.depth_m += step_s * (diving_ ? w : -w);
    result_.deepest_m = std::max(result_.deepest_m, place_.depth_m);

    const double a = std::exp(-step_s / flight_.sea.current_error_scale_s);
    const double kick = flight_.sea.current_error_m_s * std::sqrt(1.0 - a * a);
    if (kick > 0.0) {
      error_ = {{a * error_.east.value + kick * core::normal(water_rng_)},
                {a * error_.north.value + kick * core::normal(water_rng_)}};
    }
  }

  /// At a fix the position is known, and the error since the last fix counts as current, as on a Slocum.
  void take_fix() {
    const double since_s = flight_.vehicle.fix_every_s;
    reckoned_.east.value += (place_.east_m - believed_.x_m) / since_s;
    reckoned_.north.value += (place_.north_m - believed_.y_m) / since_s;
    believed_ = {place_.east_m, place_.north_m};
  }

  struct Near {
    std::size_t index;
    PlacedBody placed;
  };

  const Flight& flight_;
  const Watcher& watch_;
  avoidance::AvoidanceSystem system_;
  std::vector<BodyVector> beams_;
  std::mt19937_64 water_rng_;
  std::mt19937_64 sonar_rng_;
  std::mt19937_64 adcp_rng_;
  double compass_bias_rad_{};
  double speed_scale_{1.0};
  geo::VelocityEn error_{};

  double time_s_{};
  SeaPoint place_{};
  geo::PlanePoint believed_{};
  geo::VelocityEn reckoned_{};
  geo::PlanePoint carried_{};
  double heading_rad_{};
  bool diving_{true};
  std::size_t next_{};
  avoidance::Guidance guided_{};
  std::vector<Near> near_;
  std::vector<std::optional<Sighting>> seen_;
  std::vector<avoidance::SonarReturn> returns_;
  std::vector<avoidance::CurrentBin> bins_;
  FlightResult result_{};
};

}  // namespace

FlightResult fly(const Flight& flight, const Watcher& watch) { return LightFlight{flight, watch}.run(); }

}  // namespace floeplan::support
