#include <gtest/gtest.h>

#include <cmath>

#include "engine/motion/edge_time.hpp"
#include "engine/motion/speed_over_ground.hpp"
#include "tests/engine/motion/random_waves.hpp"
#include "tests/support/property.hpp"

namespace floeplan::motion::edge_time_laws_test {
namespace {

/// The same travel time by dt/ds = 1 / v(s, t) in ten thousand equal steps of the way (classical Runge-Kutta).
double reference_time_s(const PlaneEdge& edge, double depart_s, const RandomWaves& waves) {
  constexpr int steps = 10'000;
  const double dx = edge.to.x_m - edge.from.x_m;
  const double dy = edge.to.y_m - edge.from.y_m;
  const geo::Bearing course = geo::Bearing::towards(dx, dy);
  const auto slowness = [&](double way_m, double t_s) {
    const double share = way_m / edge.ground_length.value;
    const auto c = waves({edge.from.x_m + share * dx, edge.from.y_m + share * dy}, core::Seconds{t_s});
    return 1.0 / speed_over_ground(glider, {{c->x_m_s}, {c->y_m_s}}, course)->value;
  };
  const double h = edge.ground_length.value / steps;
  double t = depart_s;
  for (int i = 0; i < steps; ++i) {
    const double s = h * i;
    const double k1 = slowness(s, t);
    const double k2 = slowness(s + 0.5 * h, t + 0.5 * h * k1);
    const double k3 = slowness(s + 0.5 * h, t + 0.5 * h * k2);
    const double k4 = slowness(s + h, t + h * k3);
    t += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return t - depart_s;
}

PlaneEdge backwards(const PlaneEdge& edge) { return {edge.to, edge.from, edge.ground_length}; }

void expect_within_tolerance(const PlaneEdge& edge, double depart_s, const RandomWaves& waves) {
  const double expected_s = reference_time_s(edge, depart_s, waves);
  for (const double tolerance : {1e-3, 1e-4, 1e-6}) {
    const auto time = edge_time(edge, core::Seconds{depart_s}, glider, waves, wave_accuracy(tolerance));
    ASSERT_TRUE(time.has_value());
    EXPECT_NEAR(time->count(), expected_s, tolerance * expected_s) << "tolerance " << tolerance;
  }
}

TEST(EdgeTime, AgreesWithAFineReferenceBothWaysAlongTheEdge) {
  support::for_each_seed(40, [](std::mt19937_64& rng) {
    const RandomWaves waves{rng};
    const PlaneEdge edge = random_edge(rng);
    const double depart_s = support::uniform(rng, 0.0, 1e5);

    expect_within_tolerance(edge, depart_s, waves);
    expect_within_tolerance(backwards(edge), depart_s, waves);
  });
}

double mean_relative_error(double tolerance) {
  constexpr std::uint64_t edges = 20;
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= edges; ++seed) {
    std::mt19937_64 rng{seed};
    const RandomWaves waves{rng};
    const PlaneEdge edge = random_edge(rng);
    const double expected_s = reference_time_s(edge, 0.0, waves);
    const auto time = edge_time(edge, core::Seconds{0.0}, glider, waves, wave_accuracy(tolerance));
    sum += std::abs(time->count() - expected_s) / expected_s;
  }
  return sum / edges;
}

TEST(EdgeTime, ConvergesWithTheTolerance) {
  const double coarse = mean_relative_error(1e-3);
  const double fine = mean_relative_error(1e-5);
  const double finest = mean_relative_error(1e-7);

  EXPECT_LT(fine, 0.2 * coarse);
  EXPECT_LT(finest, 0.2 * fine);
  EXPECT_LT(finest, 1e-7);
}

TEST(EdgeTime, NeverArrivesEarlierForLeavingLater) {
  constexpr double tolerance = 1e-6;
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const RandomWaves waves{rng};
    const PlaneEdge edge = random_edge(rng);
    const core::Seconds early{support::uniform(rng, 0.0, 1e5)};
    const core::Seconds late = early + core::Seconds{std::exp(support::uniform(rng, -1.0, 11.0))};

    const auto early_time = edge_time(edge, early, glider, waves, wave_accuracy(tolerance));
    const auto late_time = edge_time(edge, late, glider, waves, wave_accuracy(tolerance));

    ASSERT_TRUE(early_time.has_value() && late_time.has_value());
    const core::Seconds allowance = 5.0 * tolerance * (*early_time + *late_time);
    EXPECT_LE(early + *early_time, late + *late_time + allowance);
  });
}

}  // namespace
}  // namespace floeplan::motion::edge_time_laws_test
