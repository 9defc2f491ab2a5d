#include "engine/simulation/flight/random_icebergs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/core/random.hpp"
#include "engine/simulation/vehicle/glider_motion.hpp"
#include "engine/simulation/world/iceberg_shape.hpp"

namespace floeplan::simulation {
namespace {

constexpr double about_route_m = 3000.0;       // bergs farther away do not come near during the flight
constexpr core::Seconds fix_every{900.0};      // of a berg's track
constexpr core::Seconds fix_interval{3600.0};  // interval of surfacings for a fix
constexpr std::array forms{IcebergForm::tabular,  IcebergForm::blocky, IcebergForm::domed,
                           IcebergForm::pinnacle, IcebergForm::wedge,  IcebergForm::drydock};

void check(const IcebergFieldSettings& settings) {
  const bool good = settings.route.value > 0.0 && settings.km2_for_each > 0.0 &&
                    settings.least_length.value > 0.0 && settings.least_length < settings.greatest_length &&
                    settings.median_length.value > 0.0;
  if (!good)
    throw std::invalid_argument{"a field of icebergs needs a route, an area for each berg, and lengths"};
}

Vector in_any_direction(double length, std::mt19937_64& rng) {
  const double towards = 2.0 * std::numbers::pi * core::uniform(rng);
  return {length * std::sin(towards), length * std::cos(towards), 0.0};
}

double length_m(const IcebergFieldSettings& settings, std::mt19937_64& rng) {
  for (;;) {
    const double length = settings.median_length.value * std::exp(settings.length_sigma * core::normal(rng));
    if (length >= settings.least_length.value && length <= settings.greatest_length.value) return length;
  }
}

/// Track of a berg that the current at half its draft carries and that also moves through the water.
std::vector<Body::Fix> drift(Vector place, double draft_m, Vector through_water, const TrueCurrent& current,
                             core::UtcTime from, core::Seconds duration) {
  std::vector<Body::Fix> track;
  place.down = 0.5 * draft_m;
  for (core::UtcTime time = from; time < from + duration + fix_every; time += fix_every) {
    track.push_back({time, place.east, place.north});
    const Vector water = current.at(place, time).value_or(Vector{});
    place = place + fix_every.count() * (water + through_water);
  }
  return track;
}

Body berg(const IcebergFieldSettings& settings, const vehicle::GliderProfile& vehicle, Vector place,
          const TrueCurrent& current, core::UtcTime departure, std::mt19937_64& rng, std::string name) {
  const auto form = forms[static_cast<std::size_t>(core::uniform(rng) * forms.size())];
  const core::Metres length{length_m(settings, rng)};
  const core::Metres draft = likely_draft(length, rng);
  Shape shape = iceberg_shape(form, length, draft, rng);
  const double speed = settings.most_drift * vehicle.speed_through_water.value * core::uniform(rng);
  const Vector through_water = in_any_direction(speed, rng);
  const double spin = settings.most_spin_deg_h * (2.0 * core::uniform(rng) - 1.0);
  return {std::move(name),
          std::move(shape),
          {.track = drift(place, draft.value, through_water, current, departure,
                          longest_flight(settings, vehicle)),
           .heading_rad = 2.0 * std::numbers::pi * core::uniform(rng),
           .spin_rad_s = core::degrees_to_radians(spin) / 3600.0}};
}

vehicle::GliderProfile glider(core::Metres dive_depth) {
  vehicle::GliderProfile profile = vehicle::known_profiles().front();
  profile.dive_depth = dive_depth;
  return flown_vehicle(profile).value();
}

/// A mission eastwards with the yo of the profile that surfaces every hour for a fix, and at the end.
MissionOrders orders_for(const World& world, const IcebergFieldSettings& settings,
                         const vehicle::GliderProfile& vehicle) {
  MissionOrders orders;
  orders.name = "random-icebergs";
  orders.lists.push_back(
      {.waypoints = {world.to_lon_lat({settings.route.value, 0.0, 0.0})}, .radius = {50.0}});
  orders.yo = {.dive = {.depth = vehicle.dive_depth,
                        .altitude = vehicle.altimeter_margin,
                        .pitch_rad = -vehicle.pitch.value,
                        .buoyancy_m3 = -vehicle.buoyancy.value},
               .climb = {.depth = vehicle.climb_to,
                         .pitch_rad = vehicle.pitch.value,
                         .buoyancy_m3 = vehicle.buoyancy.value}};
  orders.surfaces.push_back(
      {.cause = SurfaceOrders::Cause::every, .interval = fix_interval, .climb = orders.yo.climb});
  orders.surfaces.push_back(
      {.cause = SurfaceOrders::Cause::any_idle, .ends_mission = true, .climb = orders.yo.climb});
  return orders;
}

}  // namespace

core::Seconds longest_flight(const IcebergFieldSettings& settings, const vehicle::GliderProfile& vehicle) {
  return 4.0 * (settings.route / vehicle.speed_through_water);
}

IcebergField random_icebergs(const IcebergFieldSettings& settings, geo::LonLat start, core::UtcTime departure,
                             std::uint64_t seed) {
  check(settings);
  const vehicle::GliderProfile vehicle = glider(settings.dive_depth);
  auto rng = core::random_stream(seed, "iceberg field");
  const Vector forecast = in_any_direction(settings.current.value, rng);
  const TrueCurrent current{
      forecast,
      CurrentErrorField{{.rms = std::numbers::sqrt2 / 2.0 * settings.current_error}, departure, seed}};
  WorldParts parts{.origin = start, .current = current};
  const double width_m = settings.route.value + 2.0 * about_route_m;
  const double count = width_m * 2.0 * about_route_m / (1e6 * settings.km2_for_each);
  for (int i = 0; i < static_cast<int>(std::lround(count)); ++i) {
    const Vector place{-about_route_m + width_m * core::uniform(rng),
                       about_route_m * (2.0 * core::uniform(rng) - 1.0), 0.0};
    Body body = berg(settings, vehicle, place, current, departure, rng, "berg " + std::to_string(i + 1));
    if (length(place) < body.shape().radius_m + settings.free_about_start.value) continue;
    parts.bodies.push_back(std::move(body));
  }
  World world{std::move(parts)};
  MissionOrders orders = orders_for(world, settings, vehicle);
  return {std::move(world), std::move(orders), vehicle, {{forecast.east}, {forecast.north}}};
}

}  // namespace floeplan::simulation
