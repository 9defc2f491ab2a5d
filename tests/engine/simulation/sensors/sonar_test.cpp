#include "engine/simulation/sensors/sonar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/core/random.hpp"
#include "tests/support/property.hpp"

namespace floeplan::simulation::sonar_test {
namespace {

constexpr auto nothing = [](Vector, Vector, double) -> std::optional<RayHit> { return std::nullopt; };

/// A wall of ice across the frame's north, at this distance from the origin.
auto wall_at(double north_m) {
  return [north_m](Vector origin, Vector direction, double max_m) -> std::optional<RayHit> {
    if (direction.north <= 1e-9) return std::nullopt;
    const double range_m = (north_m - origin.north) / direction.north;
    if (range_m > max_m) return std::nullopt;
    return RayHit{range_m, direction.north, Scatterer::ice};
  };
}

/// A ball of ice as large as a small berg.
auto ball_at(Vector centre, double radius_m) {
  return [=](Vector origin, Vector direction, double max_m) -> std::optional<RayHit> {
    const Vector to = centre - origin;
    const double middle_m = dot(to, direction);
    const double inside = radius_m * radius_m - (dot(to, to) - middle_m * middle_m);
    if (inside <= 0.0 || middle_m <= 0.0) return std::nullopt;
    const double range_m = middle_m - std::sqrt(inside);
    if (range_m > max_m) return std::nullopt;
    const Vector normal = (1.0 / radius_m) * (origin + range_m * direction - centre);
    return RayHit{range_m, std::max(0.0, -dot(normal, direction)), Scatterer::ice};
  };
}

SonarSettings quiet() {
  SonarSettings settings;
  settings.false_alarms_per_ping = 0.0;
  return settings;
}

TEST(Sonar, SeesAWallAheadAtItsRangeToACell) {
  support::for_each_seed(10, [](std::mt19937_64& rng) {
    Sonar sonar{quiet()};
    const double range_m = support::uniform(rng, 5.0, 150.0);
    double nearest_m = 1e9;
    for (int ping = 0; ping < 10; ++ping) {  // an echo of a single ping may fade
      for (const auto& echo : sonar.ping(TrueState{}, wall_at(range_m), rng)) {
        if (echo.beam.forward > 0.9999) nearest_m = std::min(nearest_m, echo.range.value);
      }
    }

    EXPECT_NEAR(nearest_m, range_m, 1.0 * sonar.cell_m());
  });
}

TEST(Sonar, LooksWhereTheVehicleIsTurnedTo) {
  support::for_each_seed(20, [](std::mt19937_64& rng) {
    Sonar sonar{quiet()};
    TrueState state;
    state.position = {100.0, -50.0, 80.0};
    state.attitude = {support::uniform(rng, 0.0, 6.28), support::uniform(rng, -0.5, 0.5),
                      support::uniform(rng, -0.2, 0.2)};
    // A ball 60 m ahead, 20 degrees to the right, a little above the hull's axis.
    const Vector towards = BodyAxes{state.attitude}.to_frame(std::cos(0.35), std::sin(0.35), -0.05);
    const Vector centre = state.position + (60.0 / length(towards)) * towards;

    const auto returns = sonar.ping(state, ball_at(centre, 5.0), rng);

    ASSERT_FALSE(returns.empty());
    for (const auto& echo : returns) {
      const double azimuth = std::atan2(echo.beam.starboard, echo.beam.forward);
      EXPECT_NEAR(azimuth, 0.35, 0.2);
      EXPECT_NEAR(echo.range.value, 55.0, 6.0);
    }
  });
}

TEST(Sonar, HearsAWallAtTheLevelOfTheSonarEquation) {
  SonarSettings settings = quiet();
  settings.beam.side_lobes_db = -60.0;
  Sonar sonar{settings};
  auto rng = core::random_stream(1, "levels");
  // Rays that meet the wall at the same range fall into the same cell: a shell instead of a wall.
  const auto shell = [](Vector, Vector, double) { return std::optional{RayHit{80.0, 1.0, Scatterer::ice}}; };
  double power = 0.0;
  int echoes = 0;
  for (int ping = 0; ping < 400; ++ping) {
    for (const auto& echo : sonar.ping(TrueState{}, shell, rng)) {
      power += std::pow(10.0, echo.echo_level_db / 10.0);
      ++echoes;
    }
  }

  EXPECT_GT(echoes, 400 * 120);
  EXPECT_NEAR(10.0 * std::log10(power / echoes), sonar.echo_of_wall_db(80.0, settings.ice_strength_db), 0.5);
}

TEST(Sonar, DetectsAsOftenAsTheSwerlingCurveSays) {
  SonarSettings settings = quiet();
  settings.beams = 1;
  settings.rows = 1;
  settings.false_alarms_per_ping = 0.001;
  const double cells = settings.range_m / (0.5 * settings.water.speed_m_s * settings.pulse_s);
  const double false_alarm = settings.false_alarms_per_ping / (cells - 1.0);
  for (const double wanted_db : {3.0, 10.0, 15.0}) {
    // With this strength of the ice, the echo is `wanted_db` above its background.
    Sonar loud{settings};
    SonarSettings faint = settings;
    faint.ice_strength_db +=
        loud.background_db(100.0) + wanted_db - loud.echo_of_wall_db(100.0, settings.ice_strength_db);
    faint.beam.side_lobes_db = -60.0;
    if (!faint.violations().empty()) faint.source_level_db += faint.ice_strength_db + 60.0;
    if (faint.ice_strength_db < -60.0) faint.ice_strength_db = -60.0;
    Sonar sonar{faint};
    const double ratio = std::pow(
        10.0, (sonar.echo_of_wall_db(100.0, faint.ice_strength_db) - sonar.background_db(100.0)) / 10.0);
    const auto shell = [](Vector, Vector, double) {
      return std::optional{RayHit{100.0, 1.0, Scatterer::ice}};
    };
    auto rng = core::random_stream(2, "swerling");
    int heard = 0;
    constexpr int pings = 4000;
    for (int ping = 0; ping < pings; ++ping) heard += sonar.ping(TrueState{}, shell, rng).empty() ? 0 : 1;

    const double expected = std::pow(false_alarm, 1.0 / (1.0 + ratio));
    EXPECT_NEAR(static_cast<double>(heard) / pings, expected, 5.0 * std::sqrt(expected / pings) + 0.02)
        << wanted_db;
  }
}

TEST(Sonar, GivesFalseAlarmsAtTheStatedRateAllOverItsRange) {
  SonarSettings settings;
  settings.false_alarms_per_ping = 0.5;
  Sonar sonar{settings};
  auto rng = core::random_stream(3, "alarms");
  constexpr int pings = 4000;
  int alarms = 0;
  double range_m = 0.0;
  for (int ping = 0; ping < pings; ++ping) {
    for (const auto& echo : sonar.ping(TrueState{}, nothing, rng)) {
      ++alarms;
      range_m += echo.range.value;
      EXPECT_GE(echo.echo_level_db, sonar.background_db(echo.range.value) + sonar.threshold_db() - 1e-9);
    }
  }

  EXPECT_NEAR(static_cast<double>(alarms) / pings, 0.5, 5.0 * std::sqrt(0.5 / pings));
  EXPECT_NEAR(range_m / alarms, 100.0, 5.0 * 58.0 / std::sqrt(alarms));
}

TEST(Sonar, HearsNothingBeyondItsRangeNorWhileItSends) {
  Sonar sonar{quiet()};
  auto rng = core::random_stream(4, "range");

  EXPECT_TRUE(sonar.ping(TrueState{}, wall_at(210.0), rng).empty());
  const auto close = [](Vector, Vector, double) { return std::optional{RayHit{0.3, 1.0, Scatterer::ice}}; };
  EXPECT_TRUE(sonar.ping(TrueState{}, close, rng).empty());
}

TEST(Sonar, TakesTheOpenSurfaceForBackgroundAndNeverForABody) {
  Sonar sonar{quiet()};
  auto rng = core::random_stream(5, "surface");
  const auto surface = [](Vector, Vector direction, double max_m) -> std::optional<RayHit> {
    if (direction.down >= 0.0) return std::nullopt;
    const double range_m = 10.0 / -direction.down;
    if (range_m > max_m) return std::nullopt;
    return RayHit{range_m, -direction.down, Scatterer::open_surface};
  };

  for (int ping = 0; ping < 50; ++ping) EXPECT_TRUE(sonar.ping(TrueState{}, surface, rng).empty());
}

TEST(Sonar, HearsLessOfAFaintBodyUnderARoughSurface) {
  // The body's echo lies in the same cell and directions as that of the surface.
  const auto faint_body_under = [](double wind_m_s) {
    SonarSettings settings;
    settings.false_alarms_per_ping = 0.0;
    settings.water.wind_m_s = wind_m_s;
    settings.ice_strength_db = -50.0;
    Sonar sonar{settings};
    auto rng = core::random_stream(6, "rough");
    std::size_t heard = 0;
    for (int ping = 0; ping < 50; ++ping) {
      const auto mixed = [](Vector, Vector direction, double) {
        const bool body = direction.east > 0.0;
        return std::optional{RayHit{50.0, 0.7, body ? Scatterer::ice : Scatterer::open_surface}};
      };
      heard += sonar.ping(TrueState{}, mixed, rng).size();
    }
    return heard;
  };

  EXPECT_LT(faint_body_under(15.0), faint_body_under(0.0));
}

TEST(Sonar, HearsNoGhostsOfAStrongEchoInItsSideLobes) {
  Sonar sonar{quiet()};
  auto rng = core::random_stream(7, "ghosts");
  TrueState state;
  for (int ping = 0; ping < 50; ++ping) {
    for (const auto& echo : sonar.ping(state, ball_at({0.0, 20.0, 0.0}, 3.0), rng)) {
      EXPECT_LT(std::abs(std::atan2(echo.beam.starboard, echo.beam.forward)), 0.5);
    }
  }
}

TEST(Sonar, PlacesTheSeaBedWhereItIsAndNotAheadOfTheVehicle) {
  Sonar sonar{quiet()};
  auto rng = core::random_stream(9, "bed");
  const auto bed = [](Vector, Vector direction, double max_m) -> std::optional<RayHit> {
    if (direction.down <= 0.0) return std::nullopt;
    const double range_m = 70.0 / direction.down;
    if (range_m > max_m) return std::nullopt;
    return RayHit{range_m, direction.down, Scatterer::sea_bed};
  };

  for (int ping = 0; ping < 20; ++ping) {
    for (const auto& echo : sonar.ping(TrueState{}, bed, rng)) {
      // Half a row's step off at most, of 200 m.
      EXPECT_NEAR(echo.range.value * echo.beam.down, 70.0, 30.0);
    }
  }
}

TEST(Sonar, GivesTheSamePingsForTheSameSeed) {
  const auto fly = [] {
    Sonar sonar{SonarSettings{}};
    auto rng = core::random_stream(8, "sonar");
    std::vector<avoidance::SonarReturn> all;
    for (int ping = 0; ping < 20; ++ping) {
      const auto returns = sonar.ping(TrueState{}, ball_at({10.0, 60.0, 5.0}, 20.0), rng);
      all.insert(all.end(), returns.begin(), returns.end());
    }
    return all;
  };

  EXPECT_EQ(fly(), fly());
}

TEST(Sonar, RefusesNonsenseWithEveryReason) {
  SonarSettings settings;
  settings.range_m = -5.0;
  settings.frequency_khz = std::nan("");
  settings.beams = 0;

  EXPECT_EQ(settings.violations().size(), 3U);
  EXPECT_THROW(Sonar{settings}, std::invalid_argument);
}

TEST(Sonar, RefusesAFanWiderThanItsHalfSpaceAndAnEchoTooLateForItsInterval) {
  SonarSettings settings;
  settings.beams = 80;
  settings.rows = 3;
  settings.beam_step_rad = 0.1;
  settings.most_returns_per_beam = 1;
  settings.range_m = 900.0;

  EXPECT_EQ(settings.violations().size(), 2U);
}

}  // namespace
}  // namespace floeplan::simulation::sonar_test
