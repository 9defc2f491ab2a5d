#include "engine/motion/edge_fan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "engine/motion/edge_time.hpp"
#include "tests/support/property.hpp"

namespace floeplan::motion::edge_fan_test {
namespace {

constexpr float through_water_m_s = 0.35F;

std::vector<geo::PlanePoint> random_edges(std::mt19937_64& rng, int count) {
  std::vector<geo::PlanePoint> edges;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const double length_m = support::uniform(rng, 300.0, 4'000.0);
    edges.push_back({length_m * std::cos(angle), length_m * std::sin(angle)});
  }
  return edges;
}

/// A current within the bounds of a model: at each knot, its change per metre lies in the box that the model
/// gives for this quarter.
class AllowedWater {
 public:
  AllowedWater(std::mt19937_64& rng, double strength_m_s, double change_per_m) {
    model.u_x = 1.0F;
    model.v_y = 1.0F;
    const auto random = [&](double most) { return static_cast<float>(support::uniform(rng, -most, most)); };
    for (std::size_t q = 0; q < NearbyCurrent::quarters; ++q) {
      model.x_by_u[q] = random(change_per_m);
      model.y_by_u[q] = random(change_per_m);
      model.x_by_v[q] = random(change_per_m);
      model.y_by_v[q] = random(change_per_m);
      model.off_by_u[q] = std::abs(random(change_per_m));
      model.off_by_v[q] = std::abs(random(change_per_m));
    }
    const double first_s = support::uniform(rng, 100.0, 3'600.0);
    for (int i = 0; i < 9; ++i) {
      times_s.push_back(i == 0 ? 0.0 : first_s + 3'600.0 * (i - 1));
      values.push_back({support::uniform(rng, -strength_m_s, strength_m_s),
                        support::uniform(rng, -strength_m_s, strength_m_s)});
      for (std::size_t q = 0; q < NearbyCurrent::quarters; ++q) {
        by_u[q].push_back(within(rng, model.x_by_u[q], model.y_by_u[q], model.off_by_u[q]));
        by_v[q].push_back(within(rng, model.x_by_v[q], model.y_by_v[q], model.off_by_v[q]));
      }
    }
    CurrentXy before{};
    for (std::size_t i = 0; i + 1 < times_s.size(); ++i) {
      const double per_s = 1.0 / (times_s[i + 1] - times_s[i]);
      const CurrentXy slope{(values[i + 1].x_m_s - values[i].x_m_s) * per_s,
                            (values[i + 1].y_m_s - values[i].y_m_s) * per_s};
      if (i == 0) {
        model.x_m_s2 = static_cast<float>(slope.x_m_s);
        model.y_m_s2 = static_cast<float>(slope.y_m_s);
      } else {
        model.knot_s[i - 1] = static_cast<float>(times_s[i]);
        model.bend_x[i - 1] = static_cast<float>(slope.x_m_s - before.x_m_s);
        model.bend_y[i - 1] = static_cast<float>(slope.y_m_s - before.y_m_s);
        model.knots = i;
      }
      model.steepest_m_s2 =
          std::max(model.steepest_m_s2, static_cast<float>(std::hypot(slope.x_m_s, slope.y_m_s)));
      before = slope;
    }
    model.x_m_s = static_cast<float>(values[0].x_m_s);
    model.y_m_s = static_cast<float>(values[0].y_m_s);
    model.known_s = static_cast<float>(times_s.back());
  }

  std::optional<CurrentXy> operator()(geo::PlanePoint point, core::Seconds time) const {
    if (time.count() > times_s.back()) return std::nullopt;
    // A stage of the integration may need a time slightly before the departure; the first stretch continues
    // there.
    const auto after =
        static_cast<std::size_t>(std::ranges::upper_bound(times_s, time.count()) - times_s.begin());
    const std::size_t i = std::clamp(after, std::size_t{1}, times_s.size() - 1) - 1;
    const double share = (time.count() - times_s[i]) / (times_s[i + 1] - times_s[i]);
    const auto at = [&](const std::vector<CurrentXy>& of) {
      return CurrentXy{of[i].x_m_s + share * (of[i + 1].x_m_s - of[i].x_m_s),
                       of[i].y_m_s + share * (of[i + 1].y_m_s - of[i].y_m_s)};
    };
    const CurrentXy c = at(values);
    const std::size_t q = NearbyCurrent::quarter(point.x_m < 0.0, point.y_m < 0.0);
    const CurrentXy u = at(by_u[q]);
    const CurrentXy v = at(by_v[q]);
    return CurrentXy{c.x_m_s + u.x_m_s * point.x_m + v.x_m_s * point.y_m,
                     c.y_m_s + u.y_m_s * point.x_m + v.y_m_s * point.y_m};
  }

  NearbyCurrent model;

 private:
  static CurrentXy within(std::mt19937_64& rng, float x, float y, float off) {
    const double angle = support::uniform(rng, 0.0, 2.0 * std::numbers::pi);
    const auto far = 0.999 * static_cast<double>(off);
    return {static_cast<double>(x) + far * std::cos(angle), static_cast<double>(y) + far * std::sin(angle)};
  }

  std::vector<double> times_s;
  std::vector<CurrentXy> values;
  std::array<std::vector<CurrentXy>, NearbyCurrent::quarters> by_u;
  std::array<std::vector<CurrentXy>, NearbyCurrent::quarters> by_v;
};

constexpr FanVehicle vehicle{.through_water_m_s = through_water_m_s, .longest_s = 20'000.0F};

tl::expected<core::Seconds, EdgeClosed> exact_time(geo::PlanePoint edge, const AllowedWater& water) {
  const EdgeAccuracy exact{.relative_tolerance = 1e-7,
                           .longest_step = core::Metres{500.0},
                           .longest_duration = core::Seconds{600.0}};
  return edge_time({{0.0, 0.0}, edge, core::Metres{std::hypot(edge.x_m, edge.y_m)}}, core::Seconds{0.0},
                   core::MetresPerSecond{static_cast<double>(through_water_m_s)}, water, exact);
}

TEST(BoundFan, IsNeverMoreThanTheTimeInWaterThatTheModelAllows) {
  int bounded = 0;
  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    const auto edges = random_edges(rng, 16);
    const AllowedWater water{rng, support::uniform(rng, 0.0, 0.4), support::uniform(rng, 0.0, 6e-5)};
    FanTimes times;
    bound_fan(EdgeFan{edges}, water.model, vehicle, times);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (times.time_s[i] == 0.0F) continue;
      ++bounded;
      const auto exact = exact_time(edges[i], water);
      ASSERT_TRUE(exact.has_value()) << "the bound says that the edge is open";
      EXPECT_LE(static_cast<double>(times.time_s[i]), exact->count() * (1.0 + 1e-6));
    }
  });
  EXPECT_GT(bounded, 200);
}

TEST(BoundFan, IsNeverMoreThanTheTimeWhereNoCurrentStopsTheVehicle) {
  support::for_each_seed(200, [&](std::mt19937_64& rng) {
    const auto edges = random_edges(rng, 16);
    const AllowedWater water{rng, 0.2, support::uniform(rng, 0.0, 1e-5)};
    FanVehicle unstopped = vehicle;
    unstopped.never_stopped = true;
    FanTimes times;
    bound_fan(EdgeFan{edges}, water.model, unstopped, times);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto exact = exact_time(edges[i], water);
      if (!exact) continue;
      EXPECT_LE(static_cast<double>(times.time_s[i]), exact->count() * (1.0 + 1e-6));
    }
  });
}

TEST(BoundFan, IsWithinAFewHundredthsWhereSlopesDifferLittle) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const auto edges = random_edges(rng, 16);
    const AllowedWater water{rng, 0.0, 1e-6};
    FanTimes times;
    bound_fan(EdgeFan{edges}, water.model, vehicle, times);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      EXPECT_GT(static_cast<double>(times.time_s[i]), 0.95 * exact_time(edges[i], water)->count());
    }
  });
}

TEST(EstimateFan, IsTheTimeItselfInUniformWater) {
  NearbyCurrent uniform;
  uniform.x_m_s = 0.1F;
  uniform.known_s = 1e6F;
  FanTimes estimated;
  FanTimes bounded;
  const EdgeFan fan{{{1000.0, 0.0}, {0.0, 1000.0}, {-1000.0, 0.0}}};
  estimate_fan(fan, uniform, vehicle, estimated);
  bound_fan(fan, uniform, vehicle, bounded);

  const std::vector<double> expected{1000.0 / 0.45, 1000.0 / std::sqrt(0.35 * 0.35 - 0.01), 1000.0 / 0.25};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(estimated.time_s[i]), expected[i], 1e-5 * expected[i]);
    EXPECT_NEAR(static_cast<double>(bounded.time_s[i]), expected[i], 5e-5 * expected[i]);
  }
}

TEST(FanPaths, AllGiveTheBitsOfTheReference) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const EdgeFan fan{random_edges(rng, support::uniform_int(rng, 1, 80))};
    const AllowedWater water{rng, support::uniform(rng, 0.0, 0.5), support::uniform(rng, 0.0, 1e-4)};
    FanTimes bounds;
    FanTimes estimates;
    bound_fan(fan, water.model, vehicle, bounds, FanPath::reference);
    estimate_fan(fan, water.model, vehicle, estimates, FanPath::reference);
    for (const FanPath path : fan_paths()) {
      FanTimes times;
      bound_fan(fan, water.model, vehicle, times, path);
      for (std::size_t i = 0; i < fan.lanes; ++i) ASSERT_EQ(times.time_s[i], bounds.time_s[i]);
      estimate_fan(fan, water.model, vehicle, times, path);
      for (std::size_t i = 0; i < fan.lanes; ++i) ASSERT_EQ(times.time_s[i], estimates.time_s[i]);
    }
  });
}

TEST(EdgeFan, RefusesEdgesItCannotHold) {
  EXPECT_THROW((EdgeFan{std::vector<geo::PlanePoint>{}}), std::invalid_argument);
  EXPECT_THROW((EdgeFan{std::vector<geo::PlanePoint>(81, {1.0, 0.0})}), std::invalid_argument);
  EXPECT_THROW((EdgeFan{{{0.0, 0.0}}}), std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::motion::edge_fan_test
