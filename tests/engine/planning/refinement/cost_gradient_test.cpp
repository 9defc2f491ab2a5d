#include "engine/planning/refinement/cost_gradient.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/motion/edge_time.hpp"
#include "engine/planning/currents/analytic_currents.hpp"
#include "tests/support/property.hpp"

namespace floeplan::planning::refinement::cost_gradient_test {
namespace {

const auto in_the_jet = [](geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart) {
  const core::Metres length{std::hypot(b.x_m - a.x_m, b.y_m - a.y_m)};
  return motion::edge_time({a, b, length}, depart, core::MetresPerSecond{2.0}, currents::MeanderingJet{},
                           {.relative_tolerance = 1e-8});
};

cost::Route random_route(std::mt19937_64& rng) {
  cost::Route route;
  for (int i = 0; i <= 6; ++i) {
    route.points.push_back({1.5 * i, support::uniform(rng, -1.0, 1.0)});
    route.fixed.push_back(i % 6 == 0);
  }
  return route;
}

/// The gradient of a random route's cost at one of its points is the difference quotient, within `accuracy`.
template <cost::CostedLeg Leg>
void expect_difference_quotient(std::mt19937_64& rng, const Leg& leg, double accuracy) {
  LegMeter legs{leg, RefinementBudget{}};
  const cost::Route route = random_route(rng);
  const CostGradient gradient = cost_gradient(legs, *legs.timed(route, core::Seconds{3.0}));

  const auto i = static_cast<std::size_t>(support::uniform_int(rng, 0, 6));
  constexpr double h = 1e-4;
  const auto cost_with = [&](double dx, double dy) {
    cost::Route moved = route;
    moved.points[i].x_m += dx;
    moved.points[i].y_m += dy;
    return legs.timed(moved, core::Seconds{3.0})->cost();
  };

  EXPECT_NEAR(gradient.x[i], (cost_with(h, 0.0) - cost_with(-h, 0.0)) / (2.0 * h), accuracy);
  EXPECT_NEAR(gradient.y[i], (cost_with(0.0, h) - cost_with(0.0, -h)) / (2.0 * h), accuracy);
}

TEST(CostGradient, IsTheDifferenceQuotientOfTheWholeRoutesTime) {
  support::for_each_seed(20, [](std::mt19937_64& rng) { expect_difference_quotient(rng, in_the_jet, 1e-3); });
}

TEST(CostGradient, IsTheDifferenceQuotientOfACostThatChangesFromPlaceToPlaceAndWithTime) {
  const auto dear_in_the_north = [](geo::PlanePoint a, geo::PlanePoint b,
                                    core::Seconds depart) -> std::optional<cost::LegCost> {
    const auto time = in_the_jet(a, b, depart);
    if (!time) return std::nullopt;
    const double power = 3.0 + std::sin(0.5 * (a.y_m + b.y_m)) + std::cos(0.2 * depart.count());
    return cost::LegCost{*time, power * time->count()};
  };
  support::for_each_seed(
      20, [&](std::mt19937_64& rng) { expect_difference_quotient(rng, dear_in_the_north, 3e-3); });
}

TEST(CostGradient, LooksToTheOpenSideBesideAClosedArea) {
  const auto closed_north_of_the_way = [](geo::PlanePoint a, geo::PlanePoint b,
                                          core::Seconds) -> tl::expected<core::Seconds, motion::EdgeClosed> {
    if (std::max(a.y_m, b.y_m) > 0.0) return tl::unexpected(motion::EdgeClosed::obstacle);
    return core::Seconds{std::hypot(b.x_m - a.x_m, b.y_m - a.y_m)};
  };
  LegMeter legs{closed_north_of_the_way, RefinementBudget{}};
  const cost::Route route{{{0.0, 0.0}, {100.0, 0.0}, {200.0, -50.0}}, {true, false, true}};

  const CostGradient gradient = cost_gradient(legs, *legs.timed(route, core::Seconds{0.0}));

  EXPECT_NEAR(gradient.y[1], 50.0 / std::hypot(100.0, 50.0), 0.01) << "southwards it gets shorter";
}

}  // namespace
}  // namespace floeplan::planning::refinement::cost_gradient_test
