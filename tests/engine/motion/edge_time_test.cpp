#include "engine/motion/edge_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "engine/motion/speed_over_ground.hpp"
#include "tests/support/property.hpp"

namespace floeplan::motion::edge_time_test {
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

/// A current that changes on the way and with the clock, so that several steps are taken.
auto rolling_current() {
  return [](geo::PlanePoint p, core::Seconds time) -> std::optional<CurrentXy> {
    return CurrentXy{0.15 * std::sin(p.x_m / 900.0),
                     0.1 * std::cos(p.x_m / 1'100.0 + time.count() / 4'000.0)};
  };
}

TEST(EdgeTime, ShowsTheDriveInPiecesWithoutAGapFromDepartureToArrival) {
  std::vector<EdgePiece> pieces;
  const auto record = [&](const EdgePiece& piece) -> std::optional<EdgeClosed> {
    pieces.push_back(piece);
    return std::nullopt;
  };

  const core::Seconds depart{500.0};
  const auto time =
      edge_time(eastward, depart, glider, rolling_current(), {}, core::Seconds{INFINITY}, record);

  ASSERT_TRUE(time.has_value());
  ASSERT_GT(pieces.size(), 3U);
  EXPECT_EQ(pieces.front().t0_s, depart.count());
  EXPECT_EQ(pieces.front().way0_m, 0.0);
  EXPECT_EQ(pieces.back().t1_s, (depart + *time).count());
  EXPECT_EQ(pieces.back().way1_m, eastward.ground_length.value);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    EXPECT_EQ(pieces[i].t0_s, pieces[i - 1].t1_s);
    EXPECT_EQ(pieces[i].way0_m, pieces[i - 1].way1_m);
    EXPECT_EQ(pieces[i].v0_m_s, pieces[i - 1].v1_m_s);
  }
}

TEST(EdgeTime, GivesEveryPieceTheSpeedOfTheVehicleAtItsTwoEnds) {
  const auto current = rolling_current();
  const auto speed_at = [&](double way_m, double t_s) {
    const auto c = current({way_m, 0.0}, core::Seconds{t_s});
    return speed_over_ground(glider, {{c->x_m_s}, {c->y_m_s}}, geo::Bearing::degrees(90.0))->value;
  };
  const auto compare = [&](const EdgePiece& piece) -> std::optional<EdgeClosed> {
    EXPECT_NEAR(piece.v0_m_s, speed_at(piece.way0_m, piece.t0_s), 1e-5);
    EXPECT_NEAR(piece.v1_m_s, speed_at(piece.way1_m, piece.t1_s), 1e-5);
    return std::nullopt;
  };

  const auto time =
      edge_time(eastward, core::Seconds{0.0}, glider, current, {}, core::Seconds{INFINITY}, compare);

  EXPECT_TRUE(time.has_value());
}

TEST(EdgeTime, IsClosedByTheFirstPieceThatIsRefused) {
  const auto beyond_half_way = [](const EdgePiece& piece) -> std::optional<EdgeClosed> {
    if (piece.way1_m > 5'000.0) return EdgeClosed::obstacle;
    return std::nullopt;
  };

  const auto time = edge_time(eastward, core::Seconds{0.0}, glider, rolling_current(), {},
                              core::Seconds{INFINITY}, beyond_half_way);

  ASSERT_FALSE(time.has_value());
  EXPECT_EQ(time.error(), EdgeClosed::obstacle);
}

}  // namespace
}  // namespace floeplan::motion::edge_time_test
