#include "engine/planning/obstacles/iceberg_discs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/geo/geodesic.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::obstacles::iceberg_discs_test {
namespace {

using support::uniform;

const geo::LocalProjection projection{{-53.0, 69.0}};
const plane::PlaneBox area{{-40'000.0, -40'000.0}, {40'000.0, 40'000.0}};
const core::UtcTime epoch = core::from_unix_seconds(support::sea_start_s);
constexpr core::Seconds horizon{72.0 * 3600.0};

IcebergDiscs discs_of(const ocean::Environment& environment, const IcebergRules& rules) {
  return {environment, rules, projection, area, epoch, horizon};
}

geo::PlanePoint eastwards(double distance_m) {
  return projection.to_plane(
      geo::geodesic_destination({-53.0, 69.0}, geo::Bearing::degrees(90.0), core::Metres{distance_m}));
}

bool covers(const std::vector<TimeSpan>& spans, double t_s) {
  return std::ranges::any_of(
      spans, [&](const TimeSpan& span) { return span.from.count() <= t_s && t_s <= span.until.count(); });
}

geo::PlanePoint random_point(std::mt19937_64& rng) {
  return {uniform(rng, -30'000.0, 30'000.0), uniform(rng, -30'000.0, 30'000.0)};
}

motion::EvenMove random_move(std::mt19937_64& rng) {
  const geo::PlanePoint from = random_point(rng);
  const double towards = uniform(rng, 0.0, 6.28);
  const double t0_s = uniform(rng, 0.0, 50.0 * 3600.0);
  const double duration_s = uniform(rng, 600.0, 30'000.0);
  const double speed_m_s = uniform(rng, 0.0, 0.5);
  return {from,
          {from.x_m + duration_s * speed_m_s * std::cos(towards),
           from.y_m + duration_s * speed_m_s * std::sin(towards)},
          t0_s,
          t0_s + duration_s};
}

/// Up to forty bergs, sighted up to two days ago, in a current that turns.
ocean::Environment drifting_sea(std::mt19937_64& rng) {
  const double turn = uniform(rng, 0.0, 6.28);
  ocean::Environment environment{.currents = support::currents_from(
                                     [&](geo::LonLat p, double hour) {
                                       return geo::VelocityEn{{0.3 * std::cos(0.3 * hour + p.lon_deg + turn)},
                                                              {0.3 * std::sin(0.2 * hour + p.lat_deg)}};
                                     },
                                     60)};
  const int count = support::uniform_int(rng, 1, 40);
  for (int i = 0; i < count; ++i) {
    auto berg = support::iceberg_at(projection.to_lon_lat(random_point(rng)), uniform(rng, 10.0, 400.0));
    berg.id = std::to_string(i);
    berg.observed = epoch - core::Seconds{uniform(rng, -10'000.0, 172'800.0)};
    if (i % 3 == 0) berg.position_uncertainty = core::Metres{uniform(rng, 0.0, 3000.0)};
    environment.icebergs.push_back(berg);
  }
  return environment;
}

TEST(IcebergDiscs, ThatStandKeepHalfTheLengthTheStatedErrorAndTheMargin) {
  ocean::Environment environment{.icebergs = {support::iceberg_at({-53.0, 69.0}, 200.0)}};
  environment.icebergs[0].position_uncertainty = core::Metres{300.0};
  const IcebergDiscs discs = discs_of(environment, {.drift = false});

  EXPECT_TRUE(discs.standing());
  EXPECT_TRUE(discs.touched({eastwards(899.0), eastwards(899.0), 0.0, 0.0}));
  EXPECT_FALSE(discs.touched({eastwards(901.0), eastwards(901.0), 0.0, 1e6}));
  EXPECT_NEAR(discs.nearest_hull({eastwards(901.0), eastwards(2000.0), 0.0, 1.0})->distance.value, 801.0,
              0.1);
}

/// Pilots are told metres on the ground, wherever the iceberg has drifted to on the plane.
TEST(IcebergDiscs, HaveTheScaleOfThePlaneWhereTheyAre) {
  const DriftingDisc disc{{{.t_s = 0.0, .centre = {}, .error = {}, .scale = 1.0},
                           {.t_s = 3600.0, .centre = {0.0, 5000.0}, .error = {}, .scale = 1.02}},
                          core::Metres{200.0},
                          core::Metres{500.0}};

  EXPECT_EQ(disc.hull(10.0).radius_m, 200.0);
  EXPECT_EQ(disc.hull(7200.0).scale, 1.02);
  EXPECT_NEAR(disc.hull(7200.0).radius_m, 204.0, 1e-9);
}

TEST(IcebergDiscs, GrowWithTheAgeOfTheSightingUpToTheMostAllowed) {
  ocean::Environment environment{.icebergs = {support::iceberg_at({-53.0, 69.0}, 200.0)}};
  const IcebergDiscs discs = discs_of(environment, {.max_inflation = core::Metres{3000.0}});
  const auto free_from = [&](double distance_m, double hours) {
    const geo::PlanePoint point = eastwards(distance_m);
    return !discs.touched({point, point, 3600.0 * hours, 3600.0 * hours});
  };

  EXPECT_FALSE(discs.standing());
  EXPECT_TRUE(free_from(601.0, 0.0));
  EXPECT_FALSE(free_from(599.0, 0.0));
  EXPECT_TRUE(free_from(2101.0, 2.0));
  EXPECT_FALSE(free_from(2099.0, 2.0));
  EXPECT_FALSE(free_from(3599.0, 4.0));
  EXPECT_TRUE(free_from(3601.0, 4.0));
  EXPECT_TRUE(free_from(3601.0, 100.0));  // after the horizon as at its end
  EXPECT_FALSE(free_from(3599.0, 100.0));
}

TEST(IcebergDiscs, MoveWithTheForecastDrift) {
  const ocean::Environment environment{
      .currents =
          support::currents_from([](geo::LonLat, double) { return geo::VelocityEn{{0.25}, {0.0}}; }, 24),
      .icebergs = {support::iceberg_at({-53.0, 69.0}, 100.0)}};
  const IcebergDiscs discs = discs_of(environment, {.max_inflation = core::Metres{0.0}});

  const auto closed = discs.closed_times(eastwards(4500.0));

  ASSERT_EQ(closed.size(), 1U);
  EXPECT_NEAR(closed[0].from.count(), (4500.0 - 550.0) / 0.25, 20.0);
  EXPECT_NEAR(closed[0].until.count(), (4500.0 + 550.0) / 0.25, 20.0);
  EXPECT_TRUE(discs.closed_times(eastwards(-600.0)).empty());
}

TEST(IcebergDiscs, AreTouchedExactlyWhereDenseSamplesSaySo) {
  int touched = 0;
  int clear = 0;
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const IcebergDiscs discs = discs_of(drifting_sea(rng), {});
    for (int i = 0; i < 20; ++i) {
      const motion::EvenMove move = random_move(rng);

      const bool answer = discs.touched(move);

      bool inside = false;
      bool nearly = false;
      for (int k = 0; k <= 400; ++k) {
        const double share = k / 400.0;
        const geo::PlanePoint p{move.from.x_m + share * (move.to.x_m - move.from.x_m),
                                move.from.y_m + share * (move.to.y_m - move.from.y_m)};
        const auto nearest = discs.nearest(p, core::Seconds{move.t0_s + share * (move.t1_s - move.t0_s)});
        const double gap_m = nearest->from_hull.value - nearest->kept_off.value;
        inside = inside || gap_m <= 0.0;
        nearly = nearly || gap_m <= 60.0;  // a step of the samples against the drift and the growth
      }
      if (inside) {
        EXPECT_TRUE(answer);
      }
      if (!nearly) {
        EXPECT_FALSE(answer);
      }
      ++(answer ? touched : clear);
    }
  });
  EXPECT_GT(touched, 100);
  EXPECT_GT(clear, 100);
}

TEST(IcebergDiscs, TellTheTimesAtWhichAPlaceIsClosed) {
  support::for_each_seed(40, [](std::mt19937_64& rng) {
    const IcebergDiscs discs = discs_of(drifting_sea(rng), {});
    for (int i = 0; i < 10; ++i) {
      const geo::PlanePoint point = random_point(rng);

      const auto closed = discs.closed_times(point);

      for (int k = 0; k <= 200; ++k) {
        const double t_s = 100.0 * 3600.0 * k / 200.0;
        const auto nearest = discs.nearest(point, core::Seconds{t_s});
        const double gap_m = nearest->from_hull.value - nearest->kept_off.value;
        if (std::abs(gap_m) < 1.0) continue;
        EXPECT_EQ(covers(closed, t_s), gap_m < 0.0) << "hour " << t_s / 3600.0;
      }
      for (std::size_t k = 1; k < closed.size(); ++k) EXPECT_GT(closed[k].from, closed[k - 1].until);
    }
  });
}

TEST(IcebergEncounters, AreTheShareOfTheErrorsThatPutTheBergOntoTheWay) {
  // The vehicle passes a standing berg on a practically endless line: the error across the line is normally distributed.
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const double length_m = uniform(rng, 20.0, 300.0);
    const double error_m = uniform(rng, 3000.0, 6000.0);
    const double passed_at_m = uniform(rng, 0.0, 12'000.0);
    ocean::Environment environment{.icebergs = {support::iceberg_at({-53.0, 69.0}, length_m)}};
    environment.icebergs[0].position_uncertainty = core::Metres{error_m};
    const IcebergDiscs discs = discs_of(environment, {.drift = false});

    const double encounters =
        discs.expected_encounters({{-80'000.0, passed_at_m}, {80'000.0, passed_at_m}, 0.0, 400'000.0});

    const double deviation_m = error_m / std::sqrt(0.5 * std::numbers::pi);
    const double kept_m = 0.5 * length_m + 500.0;
    const auto share_below = [&](double y_m) {
      return 0.5 * std::erfc(-y_m / deviation_m / std::numbers::sqrt2);
    };
    const double share = share_below(passed_at_m + kept_m) - share_below(passed_at_m - kept_m);
    EXPECT_NEAR(encounters, share, 0.05 * share + 2e-4);  // the density is taken as even across the strip
  });
}

TEST(IcebergEncounters, AreNoneWhereThePositionIsKnownAndReachFartherWithItsAge) {
  ocean::Environment environment{.icebergs = {support::iceberg_at({-53.0, 69.0}, 100.0)}};
  const motion::EvenMove past{eastwards(-20'000.0), eastwards(20'000.0), 0.0, 100'000.0};
  const motion::EvenMove aside{{-20'000.0, 25'000.0}, {20'000.0, 25'000.0}, 0.0, 100'000.0};

  EXPECT_EQ(discs_of(environment, {.drift = false}).expected_encounters(past), 0.0);
  const double fresh = discs_of(environment, {}).expected_encounters(aside);
  environment.icebergs[0].observed = epoch - core::Seconds{24.0 * 3600.0};
  const double old = discs_of(environment, {}).expected_encounters(aside);

  EXPECT_GT(fresh, 0.0);
  EXPECT_GT(old, fresh);
  EXPECT_LT(old, 0.1);
}

TEST(IcebergDiscs, TogetherAreTouchedWhenOneOfThemIs) {
  support::for_each_seed(30, [](std::mt19937_64& rng) {
    const ocean::Environment environment = drifting_sea(rng);
    const IcebergRules rules{.drift = support::uniform_int(rng, 0, 1) == 1};
    const IcebergDiscs all = discs_of(environment, rules);
    std::vector<IcebergDiscs> each;
    for (const ocean::Iceberg& berg : environment.icebergs) {
      ocean::Environment alone = environment;
      alone.icebergs = {berg};
      each.push_back(discs_of(alone, rules));
    }
    for (int i = 0; i < 50; ++i) {
      const motion::EvenMove move = random_move(rng);
      const auto touches = [&](const IcebergDiscs& discs) { return discs.touched(move); };
      EXPECT_EQ(all.touched(move), std::ranges::any_of(each, touches));
    }
  });
}

}  // namespace
}  // namespace floeplan::planning::obstacles::iceberg_discs_test
