#include "engine/planning/cost/energy_meter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/planning/cost/sea.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::cost::energy_meter_test {
namespace {

using vehicle::Drive;

const geo::LocalProjection projection{{-53.0, 69.0}};
const plane::PlaneBox area{{-30'000.0, -30'000.0}, {30'000.0, 30'000.0}};
constexpr core::Seconds never{INFINITY};

PlanRequest hybrid_request() {
  PlanRequest request = support::eastward_request();
  request.vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();
  return request;
}

/// Banks of some kilometres. The current is strong over them, and may turn with a tide.
ocean::Environment random_sea(std::mt19937_64& rng) {
  const double seed = support::uniform(rng, 0.0, 100.0);
  const double strongest_m_s = support::uniform(rng, 0.1, 0.25);
  const double a_hour = support::uniform_int(rng, 0, 1) == 0 ? 0.0 : 0.5;
  const auto bank = [=](geo::LonLat p) { return std::sin(seed + 40.0 * p.lon_deg + 60.0 * p.lat_deg); };
  return {
      .currents = support::currents_from(
          [=](geo::LonLat p, double hour) {
            const double m_s = -0.5 * strongest_m_s * (1.0 + bank(p)) * std::cos(a_hour * hour);
            return geo::VelocityEn{{m_s}, {0.3 * m_s}};
          },
          240),
      .bathymetry = support::bathymetry_from([=](geo::LonLat p) { return bank(p) > 0.2 ? 25.0 : 300.0; })};
}

struct RandomLeg {
  geo::PlanePoint a;
  geo::PlanePoint b;
  core::Seconds depart;
};

RandomLeg random_leg(std::mt19937_64& rng) {
  const auto metres = [&] { return support::uniform(rng, -15'000.0, 15'000.0); };
  return {{metres(), metres()}, {metres(), metres()}, core::Seconds{support::uniform(rng, 0.0, 1e5)}};
}

geo::PlanePoint between(const RandomLeg& leg, double share) {
  return {leg.a.x_m + share * (leg.b.x_m - leg.a.x_m), leg.a.y_m + share * (leg.b.y_m - leg.a.y_m)};
}

/// The power over the sea bed at a place.
core::Watts power_at(const PlanRequest& request, const currents::FlownDepths& depths, geo::PlanePoint place,
                     Drive drive) {
  const vehicle::GliderProfile& profile = request.vehicle;
  const bool on_thruster = drive == Drive::thruster;
  const core::MetresPerSecond vertical =
      profile.vertical_speed(on_thruster ? profile.thruster->speed : profile.speed_through_water);
  const core::Watts pump = vehicle::pump_power(profile.energy, profile.buoyancy,
                                               depths.at(projection.to_lon_lat(place)), vertical);
  return vehicle::steady_power(profile.energy) + pump +
         (on_thruster ? profile.thruster->power : core::Watts{0.0});
}

/// The energy along a straight line, summed second by second at the speed over ground that the current allows.
core::Joules stepped_energy(const Sea& sea, const PlanRequest& request, const currents::FlownDepths& depths,
                            const RandomLeg& leg, Drive drive) {
  const double way_m = geo::distance_m(leg.a, leg.b);
  const double ground_m = sea.domain().lengths().between(leg.a, leg.b).value;
  const double east = (leg.b.x_m - leg.a.x_m) / way_m;
  const double north = (leg.b.y_m - leg.a.y_m) / way_m;
  const double through_water_m_s = sea.speed(drive).value;
  core::Joules energy;
  double now_s = leg.depart.count();
  for (double way = 0.0; way < ground_m;) {
    const geo::PlanePoint here = between(leg, way / ground_m);
    const auto current = (*sea.domain().currents())(here, core::Seconds{now_s});
    const double across = current->x_m_s * north - current->y_m_s * east;
    const double speed = current->x_m_s * east + current->y_m_s * north +
                         std::sqrt(through_water_m_s * through_water_m_s - across * across);
    const double step_s = std::min(1.0, (ground_m - way) / speed);
    energy = energy + power_at(request, depths, here, drive) * core::Seconds{step_s};
    way += speed * step_s + 1e-9;
    now_s += step_s;
  }
  return energy;
}

TEST(EnergyMeter, CountsPowerOverTheTimeThatIsReallySpentInEachPlace) {
  support::for_each_seed(15, [](std::mt19937_64& rng) {
    const PlanRequest request = hybrid_request();
    const ocean::Environment environment = random_sea(rng);
    const Sea sea{environment, request, projection, area, core::Metres{1000.0}};
    const currents::FlownDepths depths{request.vehicle.dive_limits(), environment.bathymetry};
    const RandomLeg leg = random_leg(rng);
    for (const Drive drive : sea.drives()) {
      const auto time = sea.leg_time(leg.a, leg.b, leg.depart, never, drive);
      ASSERT_TRUE(time.has_value());

      const double energy_j = sea.energy_along(leg.a, leg.b, leg.depart, *time, drive).total().value;

      EXPECT_NEAR(energy_j, stepped_energy(sea, request, depths, leg, drive).value, 0.005 * energy_j);
    }
  });
}

TEST(EnergyMeter, FindsTheSameOnALegAndOnItsParts) {
  constexpr int parts = 100;
  support::for_each_seed(25, [](std::mt19937_64& rng) {
    const PlanRequest request = hybrid_request();
    const ocean::Environment environment = random_sea(rng);
    const Sea sea{environment, request, projection, area, core::Metres{1000.0}};
    const RandomLeg leg = random_leg(rng);
    for (const Drive drive : sea.drives()) {
      const auto whole = sea.metered_leg(leg.a, leg.b, leg.depart, core::Seconds{0.0}, never, drive);
      ASSERT_TRUE(whole.has_value());
      core::Seconds now = leg.depart;
      EnergyUse in_parts;
      for (int i = 0; i < parts; ++i) {
        const geo::PlanePoint from = between(leg, static_cast<double>(i) / parts);
        const geo::PlanePoint to = between(leg, (i + 1.0) / parts);
        const auto part = sea.metered_leg(from, to, now, core::Seconds{0.0}, never, drive);
        ASSERT_TRUE(part.has_value());
        in_parts += part->energy;
        now += part->leg.time;
      }

      const double energy_j = whole->energy.total().value;
      EXPECT_NEAR(in_parts.total().value, energy_j, 0.005 * energy_j);
      EXPECT_NEAR(in_parts.inflections, whole->energy.inflections, 0.005 * whole->energy.inflections);
      EXPECT_NEAR(sea.energy_along(leg.a, leg.b, leg.depart, whole->leg.time, drive).total().value, energy_j,
                  1e-9 * energy_j);
    }
  });
}

TEST(EnergyMeter, FindsTheSameWhateverIsLaidOutAroundALeg) {
  const geo::LocalProjection elsewhere{{-52.6, 69.2}};
  const plane::PlaneBox wide{{-90'000.0, -80'000.0}, {90'000.0, 85'000.0}};
  support::for_each_seed(25, [&](std::mt19937_64& rng) {
    const PlanRequest request = hybrid_request();
    const ocean::Environment environment = random_sea(rng);
    const Sea sea{environment, request, projection, area, core::Metres{1000.0}};
    const Sea wide_sea{environment, request, elsewhere, wide, core::Metres{1000.0}};
    const RandomLeg leg = random_leg(rng);
    const auto there = [&](geo::PlanePoint p) { return elsewhere.to_plane(projection.to_lon_lat(p)); };
    for (const Drive drive : sea.drives()) {
      const auto here = sea.metered_leg(leg.a, leg.b, leg.depart, core::Seconds{0.0}, never, drive);
      const auto wider =
          wide_sea.metered_leg(there(leg.a), there(leg.b), leg.depart, core::Seconds{0.0}, never, drive);

      ASSERT_TRUE(here && wider);
      const double energy_j = here->energy.total().value;
      EXPECT_NEAR(wider->energy.total().value, energy_j, 1e-3 * energy_j);
    }
  });
}

TEST(EnergyMeter, SpreadsEvenlyWhatADriveLeavesOfTheTime) {
  const PlanRequest request = hybrid_request();
  const ocean::Environment environment{
      .bathymetry = support::bathymetry_from([](geo::LonLat p) { return p.lon_deg < -53.0 ? 30.0 : 400.0; })};
  const Sea sea{environment, request, projection, area, core::Metres{1000.0}};
  const core::Seconds time{7200.0};

  const EnergyUse wait = sea.energy_along({-9000.0, 0.0}, {-9000.0, 0.0}, time, time, Drive::buoyancy);

  const currents::FlownDepths depths{request.vehicle.dive_limits(), environment.bathymetry};
  EXPECT_NEAR(wait.total().value, (power_at(request, depths, {-9000.0, 0.0}, Drive::buoyancy) * time).value,
              1e-5 * wait.total().value);
  EXPECT_GT(wait.total(),
            sea.energy_along({9000.0, 0.0}, {9000.0, 0.0}, time, time, Drive::buoyancy).total());
}

}  // namespace
}  // namespace floeplan::planning::cost::energy_meter_test
