#include "engine/motion/disc_encounter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/property.hpp"

namespace floeplan::motion::disc_encounter_test {
namespace {

using support::uniform;

constexpr double forever = std::numeric_limits<double>::infinity();

geo::PlanePoint place(const EvenMove& move, double t) {
  const double share = move.t1_s > move.t0_s ? (t - move.t0_s) / (move.t1_s - move.t0_s) : 0.0;
  return {move.from.x_m + share * (move.to.x_m - move.from.x_m),
          move.from.y_m + share * (move.to.y_m - move.from.y_m)};
}

double distance(const EvenMove& move, const MovingDisc& disc, double t) {
  const geo::PlanePoint p = place(move, t);
  return std::hypot(p.x_m - disc.centre0.x_m - (t - disc.t0_s) * disc.velocity.x_m_s,
                    p.y_m - disc.centre0.y_m - (t - disc.t0_s) * disc.velocity.y_m_s);
}

double radius(const MovingDisc& disc, double t) { return disc.radius0_m + (t - disc.t0_s) * disc.growth_m_s; }

EvenMove random_move(std::mt19937_64& rng) {
  const double t0 = uniform(rng, 0.0, 5000.0);
  return {{uniform(rng, -3000.0, 3000.0), uniform(rng, -3000.0, 3000.0)},
          {uniform(rng, -3000.0, 3000.0), uniform(rng, -3000.0, 3000.0)},
          t0,
          t0 + uniform(rng, 100.0, 8000.0)};
}

MovingDisc random_disc(std::mt19937_64& rng) {
  const double t0 = uniform(rng, -2000.0, 4000.0);
  const bool ends = support::uniform_int(rng, 0, 1) == 1;
  return {t0,
          ends ? t0 + uniform(rng, 100.0, 6000.0) : forever,
          {uniform(rng, -2000.0, 2000.0), uniform(rng, -2000.0, 2000.0)},
          {uniform(rng, -0.6, 0.6), uniform(rng, -0.6, 0.6)},
          uniform(rng, 10.0, 900.0),
          uniform(rng, 0.0, 0.4)};
}

TEST(DiscEncounter, IsFoundWhereDenseSamplesFindIt) {
  int touched = 0;
  support::for_each_seed(3000, [&](std::mt19937_64& rng) {
    const EvenMove move = random_move(rng);
    const MovingDisc disc = random_disc(rng);

    const auto touch = first_touch(move, disc);
    const auto least = least_distance(move, disc);

    const double t0 = std::max(move.t0_s, disc.t0_s);
    const double t1 = std::min(move.t1_s, disc.t1_s);
    ASSERT_EQ(least.has_value(), t0 <= t1);
    if (!least) {
      EXPECT_FALSE(touch);
      return;
    }
    double first = forever;
    double nearest = forever;
    constexpr int samples = 4000;
    for (int i = 0; i <= samples; ++i) {
      const double t = t0 + (t1 - t0) * i / samples;
      const double d = distance(move, disc, t);
      nearest = std::min(nearest, d);
      if (first == forever && d <= radius(disc, t)) first = t;
    }
    const double step = (t1 - t0) / samples;
    if (first < forever) {
      ++touched;
      ASSERT_TRUE(touch);
      EXPECT_NEAR(*touch, first - 0.5 * step, 0.51 * step);
    } else if (touch) {
      EXPECT_LE(distance(move, disc, *touch), radius(disc, *touch) + 1e-6);  // between two samples
    }
    EXPECT_LE(*least, nearest + 1e-9);
    EXPECT_NEAR(*least, nearest, 100.0 * step);  // nothing here makes 100 m/s
  });
  EXPECT_GT(touched, 500);
}

TEST(DiscEncounter, IsNeverBeforeTheTouchAndAlwaysOnTheRimThen) {
  support::for_each_seed(2000, [&](std::mt19937_64& rng) {
    const EvenMove move = random_move(rng);
    const MovingDisc disc = random_disc(rng);
    const auto touch = first_touch(move, disc);
    if (!touch || *touch == std::max(move.t0_s, disc.t0_s)) return;
    EXPECT_NEAR(distance(move, disc, *touch), radius(disc, *touch), 1e-6);
  });
}

TEST(DiscEncounter, OfAWaitingVehicleIsWhenTheDiscArrives) {
  const EvenMove waiting{{0.0, 0.0}, {0.0, 0.0}, 0.0, 10'000.0};
  const MovingDisc coming{0.0, forever, {2000.0, 0.0}, {-0.5, 0.0}, 300.0, 0.0};

  EXPECT_NEAR(first_touch(waiting, coming).value(), 3400.0, 1e-6);
}

TEST(DiscEncounter, MeetsADiscThatGrowsFasterThanTheVehicleFlees) {
  const EvenMove fleeing{{1000.0, 0.0}, {4000.0, 0.0}, 0.0, 10'000.0};
  const MovingDisc growing{0.0, forever, {0.0, 0.0}, {0.0, 0.0}, 500.0, 0.4};

  EXPECT_NEAR(first_touch(fleeing, growing).value(), 5000.0, 1e-6);
}

TEST(DiscEncounter, CountsTheRimAsInside) {
  const EvenMove past{{-1000.0, 100.0}, {1000.0, 100.0}, 0.0, 2000.0};
  const MovingDisc disc{0.0, forever, {0.0, 0.0}, {0.0, 0.0}, 100.0, 0.0};

  EXPECT_NEAR(first_touch(past, disc).value(), 1000.0, 1e-3);
}

/// The distance s(t) covered on a piece.
double way_at(const EdgePiece& piece, double t) {
  const double h = piece.t1_s - piece.t0_s;
  const double u = (t - piece.t0_s) / h;
  return (1.0 + 2.0 * u) * (1.0 - u) * (1.0 - u) * piece.way0_m +
         u * (1.0 - u) * (1.0 - u) * h * piece.v0_m_s + u * u * (3.0 - 2.0 * u) * piece.way1_m +
         u * u * (u - 1.0) * h * piece.v1_m_s;
}

TEST(PieceOfADrive, IsFollowedWithoutAGapWithinTheDeviation) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const PlaneEdge edge{{uniform(rng, -1e4, 1e4), uniform(rng, -1e4, 1e4)},
                         {uniform(rng, -1e4, 1e4), uniform(rng, -1e4, 1e4)},
                         core::Metres{uniform(rng, 5000.0, 2e4)}};
    EdgePiece piece{.t0_s = uniform(rng, 0.0, 1e5), .way0_m = uniform(rng, 0.0, 2000.0)};
    piece.t1_s = piece.t0_s + uniform(rng, 100.0, 7200.0);
    piece.v0_m_s = uniform(rng, 0.05, 1.0);
    piece.v1_m_s = uniform(rng, 0.05, 1.0);
    piece.way1_m =
        piece.way0_m + uniform(rng, 0.3, 0.7) * (piece.v0_m_s + piece.v1_m_s) * (piece.t1_s - piece.t0_s);
    const double stretch =
        std::hypot(edge.to.x_m - edge.from.x_m, edge.to.y_m - edge.from.y_m) / edge.ground_length.value;

    double reached = piece.t0_s;
    const auto look = [&](const EvenMove& move, double deviation_m) -> std::optional<int> {
      EXPECT_EQ(move.t0_s, reached);
      reached = move.t1_s;
      EXPECT_LE(deviation_m, 1.0);
      for (int i = 0; i <= 8; ++i) {
        const double t = move.t0_s + (move.t1_s - move.t0_s) * i / 8;
        const double way = way_at(piece, t) * stretch;
        const geo::PlanePoint p = place(move, t);
        EXPECT_NEAR(std::hypot(p.x_m - edge.from.x_m, p.y_m - edge.from.y_m), way, deviation_m + 1e-6);
      }
      return std::nullopt;
    };
    EXPECT_FALSE(follow_piece(edge, piece, 1.0, look));
    EXPECT_EQ(reached, piece.t1_s);
  });
}

TEST(PieceOfADrive, IsLeftAtTheFirstAnswer) {
  const PlaneEdge edge{{0.0, 0.0}, {1000.0, 0.0}, core::Metres{1000.0}};
  const EdgePiece piece{0.0, 0.0, 0.2, 2000.0, 1000.0, 0.9};
  int looks = 0;

  const auto answer = follow_piece(edge, piece, 1.0, [&](const EvenMove&, double) -> std::optional<int> {
    return ++looks == 3 ? std::optional{7} : std::nullopt;
  });

  EXPECT_EQ(answer, 7);
  EXPECT_EQ(looks, 3);
}

}  // namespace
}  // namespace floeplan::motion::disc_encounter_test
