#include "tests/engine/avoidance/light/random_icebergs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.hpp"

namespace floeplan::support {
namespace {

constexpr double aside_m = 3500.0;  // no berg from farther off drifts onto the route in time
constexpr double beyond_m = 3000.0;

double length_of(std::mt19937_64& rng, const IcebergField& field) {
  for (;;) {
    const double length_m = field.median_length_m * std::exp(field.length_sigma * core::normal(rng));
    if (length_m >= field.least_length_m && length_m <= field.most_length_m) return length_m;
  }
}

Body berg(std::mt19937_64& rng, const IcebergField& field, double speed_m_s) {
  const double length_m = length_of(rng, field);
  const double width_m = length_m * (0.55 + 0.4 * core::uniform(rng));
  Body body;
  body.centre = {-beyond_m + (field.route_m + 2.0 * beyond_m) * core::uniform(rng),
                 aside_m * (2.0 * core::uniform(rng) - 1.0), 0.0};
  body.half_axes = {0.5 * length_m, 0.5 * width_m, 2.91 * std::pow(length_m, 0.71)};
  body.bearing_rad = 2.0 * std::numbers::pi * core::uniform(rng);
  const double towards = 2.0 * std::numbers::pi * core::uniform(rng);
  const double drift = field.most_drift * speed_m_s * core::uniform(rng);
  body.drift = {drift * std::sin(towards), drift * std::cos(towards)};
  body.turn_rad_s =
      core::degrees_to_radians(field.most_turn_deg_h) / 3600.0 * (2.0 * core::uniform(rng) - 1.0);
  return body;
}

/// A vehicle at its first sighting that knows the present and future place of every body; in the plane of the
/// drifting water.
class Foreknowledge {
 public:
  Foreknowledge(const Flight& flight, const Sighting& sighting) : flight_{flight}, sighting_{sighting} {}

  /// Whether it keeps clear when it steers for `first` until `change_s`, and then for `second`.
  [[nodiscard]] bool is_clear(double first, double change_s, double second) const {
    SeaPoint place{sighting_.place.east_m - sighting_.carried.x_m,
                   sighting_.place.north_m - sighting_.carried.y_m, 0.0};
    double heading = sighting_.heading_rad;
    const double most_turn = core::degrees_to_radians(flight_.vehicle.turn_deg_s) * step_s;
    for (double since_s = 0.0; since_s < span_s; since_s += step_s) {
      const double turn =
          std::remainder((since_s < change_s ? first : second) - heading, 2.0 * std::numbers::pi);
      heading += std::clamp(turn, -most_turn, most_turn);
      place.east_m += step_s * flight_.vehicle.through_water_m_s * std::sin(heading);
      place.north_m += step_s * flight_.vehicle.through_water_m_s * std::cos(heading);
      for (const Body& body : flight_.sea.bodies) {
        if (is_inside(placed_at(body, sighting_.time_s + since_s, {}), place, hull_m)) return false;
      }
    }
    return true;
  }

 private:
  static constexpr double step_s = 4.0;
  static constexpr double span_s = 1200.0;

  const Flight& flight_;
  const Sighting& sighting_;
};

}  // namespace

bool could_be_saved(const Flight& flight, const FlightResult& result) {
  if (!result.first_seen) return false;  // never seen: no knowledge to act on
  const Foreknowledge foreknowledge{flight, *result.first_seen};
  constexpr double step = 2.0 * std::numbers::pi / 36.0;
  for (int first = 0; first < 36; ++first) {
    if (foreknowledge.is_clear(first * step, 0.0, first * step)) return true;
  }
  for (const double change_s : {60.0, 180.0, 360.0}) {
    for (int first = 0; first < 36; ++first) {
      for (int second = 0; second < 36; ++second) {
        if (foreknowledge.is_clear(first * step, change_s, second * step)) return true;
      }
    }
  }
  return false;
}

Flight random_icebergs(std::uint64_t seed, const IcebergField& field) {
  auto rng = core::random_stream(seed, "icebergs");
  Flight flight;
  flight.seed = seed;
  flight.waypoints = {{field.route_m, 0.0}};
  flight.most_s = 3.0 * field.route_m / flight.vehicle.through_water_m_s;
  flight.settings.deepest = core::Metres{flight.vehicle.deepest_m};
  const double towards = 2.0 * std::numbers::pi * core::uniform(rng);
  flight.sea.forecast = {{field.current_m_s * std::sin(towards)}, {field.current_m_s * std::cos(towards)}};
  flight.sea.current_error_m_s = field.current_error_m_s;

  const double area_km2 = (field.route_m + 2.0 * beyond_m) * 2.0 * aside_m / 1e6;
  const int bergs = core::poisson(rng, area_km2 / field.km2_for_each);
  for (int i = 0; i < bergs; ++i) {
    const Body body = berg(rng, field, flight.vehicle.through_water_m_s);
    if (std::hypot(body.centre.east_m, body.centre.north_m) < reach_m(body) + field.free_round_start_m)
      continue;
    flight.sea.bodies.push_back(body);
  }
  return flight;
}

}  // namespace floeplan::support
