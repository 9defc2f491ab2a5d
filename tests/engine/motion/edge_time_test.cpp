#include "engine/motion/edge_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "engine/motion/speed_over_ground.hpp"
#include "tests/support/property.hpp"

namespace floeplan::motion {
namespace {

constexpr core::MetresPerSecond glider{0.35};
constexpr PlaneEdge eastward{{0.0, 0.0}, {10'000.0, 0.0}, {10'000.0}};

auto uniform_current(double x_m_s, double y_m_s) {
  return [=](geo::PlanePoint, core::Seconds) -> std::optional<CurrentXy> { return CurrentXy{x_m_s, y_m_s}; };
}

TEST(EdgeTime, InStillWaterIsTheLengthOnTheGroundBySpeed) {
  const PlaneEdge stretched{{0.0, 0.0}, {3'000.0, 4'000.0}, {5'005.0}};

  const auto time = edge_time(stretched, core::Seconds{77.0}, glider, uniform_current(0.0, 0.0), {});

  EXPECT_NEAR(time->count(), 5'005.0 / 0.35, 1e-6);
}

TEST(EdgeTime, InAUniformCurrentFollowsTheNavigationTriangle) {
  const auto time_in = [](double x_m_s, double y_m_s) {
    return edge_time(eastward, core::Seconds{0.0}, glider, uniform_current(x_m_s, y_m_s), {})->count();
  };

  EXPECT_NEAR(time_in(0.1, 0.0), 10'000.0 / 0.45, 1e-6);
  EXPECT_NEAR(time_in(-0.1, 0.0), 10'000.0 / 0.25, 1e-6);
  EXPECT_NEAR(time_in(0.0, 0.21), 10'000.0 / 0.28, 1e-6);
}

TEST(EdgeTime, InAUniformCurrentAgreesWithSpeedOverGroundOnAnyCourse) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const geo::PlanePoint to{support::uniform(rng, -2e4, 2e4), support::uniform(rng, -2e4, 2e4)};
    const PlaneEdge edge{{0.0, 0.0}, to, {std::hypot(to.x_m, to.y_m)}};
    const double x_m_s = support::uniform(rng, -0.2, 0.2);
    const double y_m_s = support::uniform(rng, -0.2, 0.2);

    const auto time = edge_time(edge, core::Seconds{0.0}, glider, uniform_current(x_m_s, y_m_s), {});

    const auto speed =
        speed_over_ground(glider, {{x_m_s}, {y_m_s}}, geo::Bearing::towards(edge.to.x_m, edge.to.y_m));
    ASSERT_TRUE(time.has_value() && speed.has_value());
    EXPECT_NEAR(time->count(), edge.ground_length.value / speed->value, 1e-9 * time->count());
  });
}

TEST(EdgeTime, InACurrentThatGrowsOnTheWayHasTheClosedForm) {
  // ds/dt = V + g s: the time is ln(1 + g L / V) / g.
  constexpr double growth_per_s = 2e-5;
  const auto growing = [](geo::PlanePoint p, core::Seconds) -> std::optional<CurrentXy> {
    return CurrentXy{growth_per_s * p.x_m, 0.0};
  };

  const auto time = edge_time(eastward, core::Seconds{0.0}, glider, growing, {});

  const double expected_s = std::log(1.0 + growth_per_s * 10'000.0 / 0.35) / growth_per_s;
  EXPECT_NEAR(time->count(), expected_s, 1e-4 * expected_s);
}

TEST(EdgeTime, InACurrentThatGrowsWithTheClockHasTheClosedForm) {
  // ds/dt = V + a t: L = V w + a w^2 / 2.
  constexpr double growth_m_s2 = 5e-6;
  const auto growing = [](geo::PlanePoint, core::Seconds time) -> std::optional<CurrentXy> {
    return CurrentXy{growth_m_s2 * time.count(), 0.0};
  };

  const auto time = edge_time(eastward, core::Seconds{0.0}, glider, growing, {});

  const double expected_s = (std::sqrt(0.35 * 0.35 + 2.0 * growth_m_s2 * 10'000.0) - 0.35) / growth_m_s2;
  EXPECT_NEAR(time->count(), expected_s, 1e-4 * expected_s);
}

TEST(EdgeTime, OfNoLengthIsNothing) {
  const PlaneEdge nowhere{{1.0, 2.0}, {1.0, 2.0}, {0.0}};

  EXPECT_EQ(edge_time(nowhere, core::Seconds{0.0}, glider, uniform_current(9.0, 9.0), {})->count(), 0.0);
}

}  // namespace
}  // namespace floeplan::motion
