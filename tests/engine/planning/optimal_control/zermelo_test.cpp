#include "engine/planning/optimal_control/zermelo.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/planning/paper_waters.hpp"
#include "tests/support/property.hpp"
#include "tests/support/river_crossing.hpp"

namespace floeplan::planning::optimal_control::zermelo_test {
namespace {

using geo::PlanePoint;

constexpr std::size_t pieces = 64;

/// Runs with the same speed everywhere.
struct Steady {
  motion::CurrentXy velocity;

  std::optional<motion::CurrentXy> operator()(PlanePoint, core::Seconds) const { return velocity; }
  [[nodiscard]] std::optional<motion::SlopedCurrent> slopes_at(PlanePoint, core::Seconds) const {
    return motion::SlopedCurrent{.velocity = velocity};
  }
};

/// Like the jet, but known within a box only.
struct FencedJet {
  currents::MeanderingJet jet;

  [[nodiscard]] static bool known(PlanePoint p) { return std::abs(p.y_m) < 1.0; }
  std::optional<motion::CurrentXy> operator()(PlanePoint p, core::Seconds t) const {
    return known(p) ? jet(p, t) : std::nullopt;
  }
  [[nodiscard]] std::optional<motion::SlopedCurrent> slopes_at(PlanePoint p, core::Seconds t) const {
    return known(p) ? jet.slopes_at(p, t) : std::nullopt;
  }
};

/// The extremal near a route that is driven in `duration` at a steady pace over the ground.
template <motion::SlopedPlaneCurrent Current>
tl::expected<Extremal, NoExtremal> solve_near(const Crossing& crossing, const Current& current,
                                              const TimedWay& route, const std::stop_token& stop = {}) {
  const auto guess = guess_along(route, current, pieces);
  if (!guess) return tl::unexpected(NoExtremal::outside_data);
  const core::Seconds step = guess->duration / (8.0 * pieces);
  return solve_extremal(crossing, ZermeloFlow{current, crossing.through_water, step}, *guess, stop);
}

const TimedWay straight_over_the_river{{over_the_river.from, over_the_river.to},
                                       {core::Seconds{0.0}, core::Seconds{179.0}}};

TEST(Zermelo, GoesStraightInASteadyCurrent) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    const double east = support::uniform(rng, -0.2, 0.2);
    const double north = support::uniform(rng, -0.2, 0.2);
    const Steady current{{east, north}};
    const Crossing crossing{{0.0, 0.0}, {3000.0, 1000.0}, core::Seconds{500.0}, {0.35}};
    const double length = std::hypot(3000.0, 1000.0);
    const auto exact =
        motion::edge_time({crossing.from, crossing.to, {length}}, crossing.depart, {0.35}, current, {});
    const TimedWay detour{{crossing.from, {1200.0, 900.0}, crossing.to},
                          {core::Seconds{500.0}, core::Seconds{6000.0}, core::Seconds{15000.0}}};

    const auto extremal = solve_near(crossing, current, detour);

    ASSERT_TRUE(extremal.has_value());
    EXPECT_NEAR(extremal->duration.count(), exact->count(), 1e-7 * exact->count());
    for (const SteeredPoint& at : extremal->points) EXPECT_NEAR(at.y_m, at.x_m / 3.0, 1e-5);
  });
}

TEST(Zermelo, CrossesTheRiverInTheTimeOfTheClosedSolution) {
  const currents::RiverCurrent river;

  const auto extremal = solve_near(over_the_river, river, straight_over_the_river);

  ASSERT_TRUE(extremal.has_value());
  const double closed_s =
      support::river_crossing_by_optimal_control(river, over_the_river.through_water).count();
  EXPECT_NEAR(closed_s, 161.792, 0.0005);
  EXPECT_NEAR(extremal->duration.count(), closed_s, 1e-6);
}

TEST(Zermelo, KeepsItsConstantOnTheWayOverTheRiver) {
  const currents::RiverCurrent river;

  const auto extremal = solve_near(over_the_river, river, straight_over_the_river);

  ASSERT_TRUE(extremal.has_value());
  const auto constant = [&](const SteeredPoint& at) {
    const double c = river.slopes_at({at.x_m, at.y_m}, core::Seconds{0.0})->velocity.y_m_s;
    return std::sin(at.heading) / (over_the_river.through_water.value + c * std::sin(at.heading));
  };
  for (const SteeredPoint& at : extremal->points) {
    EXPECT_NEAR(constant(at), constant(extremal->points.front()), 1e-7);
  }
}

TEST(Zermelo, SaysThatTheGuessLeavesTheData) {
  const TimedWay northward{{along_the_jet.from, {0.0, 4.0}, along_the_jet.to},
                           {core::Seconds{0.0}, core::Seconds{10.0}, core::Seconds{20.0}}};

  const auto extremal = solve_near(along_the_jet, FencedJet{}, northward);

  ASSERT_FALSE(extremal.has_value());
  EXPECT_EQ(extremal.error(), NoExtremal::outside_data);
}

TEST(Zermelo, SaysThatItDidNotConvergeWhereNoWayLeads) {
  const Steady against{{-1.0, 0.0}};
  const Crossing crossing{{0.0, 0.0}, {1000.0, 0.0}, core::Seconds{0.0}, {0.35}};

  const auto extremal = solve_near(
      crossing, against, {{crossing.from, crossing.to}, {core::Seconds{0.0}, core::Seconds{3000.0}}});

  ASSERT_FALSE(extremal.has_value());
  EXPECT_EQ(extremal.error(), NoExtremal::not_converged);
}

TEST(Zermelo, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();

  const auto extremal =
      solve_near(over_the_river, currents::RiverCurrent{}, straight_over_the_river, source.get_token());

  ASSERT_FALSE(extremal.has_value());
  EXPECT_EQ(extremal.error(), NoExtremal::cancelled);
}

}  // namespace
}  // namespace floeplan::planning::optimal_control::zermelo_test
