#include "engine/planning/refinement/kept_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tl/expected.hpp>

#include "engine/motion/edge_closed.hpp"
#include "tests/support/property.hpp"

namespace floeplan::planning::refinement::kept_points_test {
namespace {

using Leg = tl::expected<core::Seconds, motion::EdgeClosed>;

/// Legs are slower to the north, so that their cost is not their length. Steep legs are closed.
Leg in_a_shear(geo::PlanePoint a, geo::PlanePoint b, core::Seconds) {
  if (std::abs(b.y_m - a.y_m) > 3.0 * (b.x_m - a.x_m)) return tl::unexpected(motion::EdgeClosed::obstacle);
  return core::Seconds{geo::distance_m(a, b) * (1.0 + 0.001 * (a.y_m + b.y_m))};
}

cost::Itinerary random_line(std::mt19937_64& rng, int legs) {
  cost::Route route;
  for (int i = 0; i <= legs; ++i) {
    route.points.push_back({100.0 * i, support::uniform(rng, 0.0, 200.0)});
    route.fixed.push_back(i == 0 || i == legs || support::uniform_int(rng, 0, 5) == 0);
  }
  return LegMeter{in_a_shear, RefinementBudget{}}.timed(route, core::Seconds{0.0}).value();
}

/// The least cost of each number of legs, over every choice of free points.
std::map<std::size_t, double> least_of_all_choices(LegMeter<decltype(in_a_shear)>& legs,
                                                   const cost::Itinerary& timed) {
  std::map<std::size_t, double> least;
  const std::size_t count = timed.route.points.size();
  for (std::uint32_t choice = 0; choice < (1U << count); ++choice) {
    cost::Route route;
    bool keeps_fixed = true;
    for (std::size_t i = 0; i < count; ++i) {
      const bool stays = ((choice >> i) & 1U) != 0;
      keeps_fixed = keeps_fixed && (stays || !timed.route.fixed[i]);
      if (!stays) continue;
      route.points.push_back(timed.route.points[i]);
      route.fixed.push_back(timed.route.fixed[i]);
    }
    if (!keeps_fixed) continue;
    const auto shorter = legs.timed(route, core::Seconds{0.0});
    if (!shorter) continue;
    const auto [at, is_new] = least.try_emplace(route.legs(), shorter->cost());
    if (!is_new) at->second = std::min(at->second, shorter->cost());
  }
  return least;
}

TEST(KeptPoints, AreTheBestOfAllChoicesWhereALegsCostDoesNotDependOnItsTime) {
  int thinned = 0;
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    LegMeter legs{in_a_shear, RefinementBudget{}};
    const cost::Itinerary line = random_line(rng, support::uniform_int(rng, 2, 9));
    const std::map<std::size_t, double> least = least_of_all_choices(legs, line);

    for (std::size_t most = 1; most < line.route.legs(); ++most) {
      const auto kept = keep_best_points(legs, line, most);

      const auto best =
          std::find_if(least.rbegin(), least.rend(), [&](const auto& l) { return l.first <= most; });
      ASSERT_EQ(kept.has_value(), best != least.rend()) << most;
      if (!kept) continue;
      ++thinned;
      EXPECT_EQ(kept->route.legs(), best->first);
      EXPECT_NEAR(kept->cost(), best->second, 1e-9 * best->second);
      EXPECT_EQ(std::ranges::count(kept->route.fixed, true), std::ranges::count(line.route.fixed, true));
    }
  });
  EXPECT_GT(thinned, 100);
}

TEST(KeptPoints, AreNoneWhereTheBudgetHasEnded) {
  std::mt19937_64 rng{1};
  LegMeter legs{in_a_shear, RefinementBudget{.most_evaluations = 0}};

  EXPECT_FALSE(keep_best_points(legs, random_line(rng, 8), 4).has_value());
}

TEST(KeptPoints, OfEqualChainsAreThoseThatComeFirst) {
  const std::vector<Shortcut> shortcuts{{0, 1, 0.0}, {1, 2, 0.0}, {0, 2, 1.0}, {2, 3, 0.0}, {1, 3, 1.0}};

  EXPECT_EQ(least_loss(shortcuts, 4, 2), (std::vector<std::size_t>{0, 2, 3}));
}

}  // namespace
}  // namespace floeplan::planning::refinement::kept_points_test
