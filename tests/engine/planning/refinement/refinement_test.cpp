#include "engine/planning/refinement/refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/motion/edge_time.hpp"
#include "engine/planning/currents/analytic_currents.hpp"
#include "tests/support/property.hpp"

namespace floeplan::planning::refinement::refinement_test {
namespace {

using Leg = tl::expected<core::Seconds, motion::EdgeClosed>;

double distance(geo::PlanePoint a, geo::PlanePoint b) { return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m); }

/// A grid of points with a start and a goal.
struct Lattice {
  geo::PlanePoint low;
  double dx;
  double dy;
  int nx;
  int ny;
  int start_column;
  int start_row;
  int goal_column;
  int goal_row;
};

/// The fastest route of a 3-sector search; empty when there is none.
template <class Timer>
std::optional<cost::Route> way_on(const Lattice& lattice, const Timer& leg_time) {
  const graph::GridGraph grid{lattice.nx, lattice.ny, 3};
  const auto point = [&](graph::Vertex v) {
    return geo::PlanePoint{lattice.low.x_m + lattice.dx * grid.column(v),
                           lattice.low.y_m + lattice.dy * grid.row(v)};
  };
  const auto edge_time = [&](const graph::Edge& edge, core::Seconds depart, core::Seconds) -> Leg {
    return leg_time(point(edge.tail), point(edge.head), depart);
  };
  const graph::Vertex goal = grid.vertex(lattice.goal_column, lattice.goal_row);
  const graph::Query query{grid.vertex(lattice.start_column, lattice.start_row), goal, core::Seconds{0.0}};
  const auto tree = graph::find_earliest_arrivals(grid, query, edge_time, std::stop_token{});
  cost::Route route;
  for (const graph::Vertex v : graph::path_to(grid, tree, goal)) {
    route.points.push_back(point(v));
    route.fixed.push_back(v == query.source || v == goal);
  }
  if (route.points.empty()) return std::nullopt;
  return route;
}

template <class Timer>
cost::Itinerary timed(const Timer& leg_time, const cost::Route& route) {
  return LegMeter{leg_time, RefinementBudget{}}.timed(route, core::Seconds{0.0}).value();
}

template <class Current>
struct InCurrent {
  Current current;
  core::MetresPerSecond through_water;
  double tolerance;

  Leg operator()(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart) const {
    return motion::edge_time({a, b, core::Metres{distance(a, b)}}, depart, through_water, current,
                             {.relative_tolerance = tolerance});
  }
};

// The paper's two cases: the river, and of the jet the stand-in whose optimum was found by collocation.
const InCurrent<currents::RiverCurrent> river{{}, core::MetresPerSecond{2.2}, 1e-5};
const Lattice river_lattice{{0.0, 0.0}, 10.0, 5.0, 31, 13, 0, 6, 30, 6};
constexpr double river_optimum_s = 161.792;
const InCurrent<currents::MeanderingJet> jet{{}, core::MetresPerSecond{0.5}, 1e-4};
const Lattice jet_lattice{{-10.0, -5.0}, 0.5, 0.5, 41, 21, 4, 6, 40, 12};
constexpr double jet_optimum_s = 17.1588;

/// A leg timer whose results differ in the last bits, as on another processor. The same arguments always give the same
/// result.
template <class Timer>
struct WithOtherLastBits {
  Timer timer;
  std::uint64_t seed;

  Leg operator()(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart) const {
    std::uint64_t state = seed;
    for (const double argument : {a.x_m, a.y_m, b.x_m, b.y_m, depart.count()})
      state = std::rotl(state ^ std::bit_cast<std::uint64_t>(argument), 29) *
              0x9e3779b97f4a7c15;  // Fibonacci hashing
    const double share = 1e-13 * (std::ldexp(static_cast<double>(state >> 11), -52) - 1.0);
    return timer(a, b, depart).map([share](core::Seconds time) { return time * (1.0 + share); });
  }
};

/// By how many per cent the best route of at most `legs` legs is slower than the optimum.
template <class Timer>
double deviation_pct(const Timer& leg_time, const Lattice& lattice, double optimum_s, std::size_t legs) {
  const Refined refined = refine_route(leg_time, timed(leg_time, *way_on(lattice, leg_time)),
                                       {.most_legs = legs, .least_gain = 0.0}, {});
  EXPECT_LE(refined.itinerary.route.legs(), legs);
  return 100.0 * (refined.itinerary.travel_time().count() / optimum_s - 1.0);
}

TEST(Refinement, ComesAsNearToTheRiversOptimumAsItsLegsAllow) {
  EXPECT_LE(deviation_pct(river, river_lattice, river_optimum_s, 8), 0.39);
  EXPECT_LE(deviation_pct(river, river_lattice, river_optimum_s, 10), 0.26);
  EXPECT_LE(deviation_pct(river, river_lattice, river_optimum_s, 16), 0.11);
}

TEST(Refinement, ComesAsNearToTheJetsOptimumAsItsLegsAllow) {
  EXPECT_LE(deviation_pct(jet, jet_lattice, jet_optimum_s, 12), 2.04);
  EXPECT_LE(deviation_pct(jet, jet_lattice, jet_optimum_s, 21), 0.78);
  EXPECT_LE(deviation_pct(jet, jet_lattice, jet_optimum_s, 42), 0.23);
  EXPECT_LE(deviation_pct(jet, jet_lattice, jet_optimum_s, 84), 0.061);
}

TEST(Refinement, ComesAsNearWhateverTheLastBitsOfTheCurrents) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const WithOtherLastBits<decltype(river)> other_river{river, seed};
    EXPECT_LE(deviation_pct(other_river, river_lattice, river_optimum_s, 8), 0.39) << seed;
    const WithOtherLastBits<decltype(jet)> other_jet{jet, seed};
    EXPECT_LE(deviation_pct(other_jet, jet_lattice, jet_optimum_s, 12), 2.04) << seed;
    EXPECT_LE(deviation_pct(other_jet, jet_lattice, jet_optimum_s, 21), 0.78) << seed;
  }
}

TEST(Refinement, LosesThreeQuartersOfItsErrorWithTwiceTheLegs) {
  double last = deviation_pct(river, river_lattice, river_optimum_s, 8);
  for (const std::size_t legs : {16U, 32U, 64U}) {
    const double now = deviation_pct(river, river_lattice, river_optimum_s, legs);
    EXPECT_GT(now, -1e-3) << "nothing is faster than the optimum";
    EXPECT_LT(now, 0.35 * last) << "straight legs err by the square of their length";
    last = now;
  }
}

TEST(Refinement, HardlyDependsOnTheGridThatTheWayCameFrom) {
  const Lattice coarse{{0.0, 0.0}, 30.0, 15.0, 11, 5, 0, 2, 10, 2};
  EXPECT_NEAR(deviation_pct(river, coarse, river_optimum_s, 16),
              deviation_pct(river, river_lattice, river_optimum_s, 16), 0.01);
}

TEST(Refinement, TakesAsManyLegsAsServeAndTellsWhatTheyAreWorth) {
  const Refined refined = refine_route(river, timed(river, *way_on(river_lattice, river)), {}, {});

  EXPECT_EQ(refined.itinerary.route.legs(), 32U) << "16 legs more gain 0.07 %, 32 legs more 0.02 %";
  ASSERT_GE(refined.report.trade.size(), 6U);
  EXPECT_EQ(refined.report.trade.front().legs, 1U);
  EXPECT_NEAR(refined.report.trade.front().travel_time.count(), 179.517, 0.001) << "direct drive";
  for (std::size_t i = 1; i < refined.report.trade.size(); ++i) {
    EXPECT_GT(refined.report.trade[i].legs, refined.report.trade[i - 1].legs);
    EXPECT_LT(refined.report.trade[i].travel_time, refined.report.trade[i - 1].travel_time);
  }
}

TEST(Refinement, LeavesTheStraightLineOfStillWaterWithOneLeg) {
  const auto still = [](geo::PlanePoint a, geo::PlanePoint b, core::Seconds) -> Leg {
    return core::Seconds{distance(a, b)};
  };
  const cost::Route route{{{0.0, 0.0}, {100.0, 50.0}, {200.0, 0.0}}, {true, false, true}};

  const Refined refined = refine_route(still, timed(still, route), {}, {});

  EXPECT_EQ(refined.itinerary.route.points, (std::vector<geo::PlanePoint>{{0.0, 0.0}, {200.0, 0.0}}));
  EXPECT_EQ(refined.report.end, RefinementEnd::converged);
}

/// A sea of 4 x 2 km with a tide, closed cells of 100 m, standing discs and one that is closed for a while.
class RandomScene {
 public:
  explicit RandomScene(std::mt19937_64& rng) : tide_{support::uniform(rng, 0.0, 0.25)} {
    for (int i = 0; i < 8; ++i) discs_.push_back({random_point(rng), support::uniform(rng, 50.0, 250.0)});
    passing_ = {random_point(rng), 300.0};
    closed_until_s_ = support::uniform(rng, 0.0, 8000.0);
    cells_.resize(40 * 20);
    for (auto&& cell : cells_) cell = support::uniform(rng, 0.0, 1.0) < 0.04;
  }

  Leg operator()(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart) const {
    for (const Disc& disc : discs_) {
      if (touches(disc, a, b)) return tl::unexpected(motion::EdgeClosed::obstacle);
    }
    if (depart.count() < closed_until_s_ && touches(passing_, a, b))
      return tl::unexpected(motion::EdgeClosed::obstacle);
    if (crosses_a_closed_cell(a, b)) return tl::unexpected(motion::EdgeClosed::too_shallow);
    const auto tide = [this](geo::PlanePoint p, core::Seconds time) -> std::optional<motion::CurrentXy> {
      return motion::CurrentXy{tide_ * std::sin(time.count() / 3000.0), tide_ * std::cos(p.x_m / 700.0)};
    };
    return motion::edge_time({a, b, core::Metres{distance(a, b)}}, depart, core::MetresPerSecond{0.35}, tide,
                             {.relative_tolerance = 1e-4});
  }

 private:
  struct Disc {
    geo::PlanePoint centre;
    double radius_m;
  };

  static geo::PlanePoint random_point(std::mt19937_64& rng) {
    return {support::uniform(rng, 600.0, 3400.0), support::uniform(rng, 0.0, 2000.0)};
  }
  static bool touches(const Disc& disc, geo::PlanePoint a, geo::PlanePoint b) {
    const double length = distance(a, b);
    const double along =
        ((disc.centre.x_m - a.x_m) * (b.x_m - a.x_m) + (disc.centre.y_m - a.y_m) * (b.y_m - a.y_m));
    const double share = length > 0.0 ? std::clamp(along / (length * length), 0.0, 1.0) : 0.0;
    return distance({a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)}, disc.centre) <=
           disc.radius_m;
  }
  [[nodiscard]] bool crosses_a_closed_cell(geo::PlanePoint a, geo::PlanePoint b) const {
    const int samples = 2 + static_cast<int>(distance(a, b) / 5.0);
    for (int i = 0; i <= samples; ++i) {
      const double share = static_cast<double>(i) / samples;
      const double column = (a.x_m + share * (b.x_m - a.x_m)) / 100.0;
      const double row = (a.y_m + share * (b.y_m - a.y_m)) / 100.0;
      if (column < 0.0 || column >= 40.0 || row < 0.0 || row >= 20.0) return true;
      if (cells_[static_cast<std::size_t>(row) * 40 + static_cast<std::size_t>(column)]) return true;
    }
    return false;
  }

  double tide_;
  std::vector<Disc> discs_;
  Disc passing_{};
  double closed_until_s_{};
  std::vector<bool> cells_;  // [row][column], true: closed
};

const Lattice scene_lattice{{25.0, 25.0}, 50.0, 50.0, 80, 40, 2, 20, 77, 20};

TEST(Refinement, IsNeverClosedNorSlowerAndKeepsFixedPointsAmongObstacles) {
  int refined_scenes = 0;
  int faster = 0;
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    const RandomScene scene{rng};
    auto route = way_on(scene_lattice, scene);
    if (!route) return;
    const std::size_t via = route->points.size() / 2;
    route->fixed[via] = true;

    const Refined refined = refine_route(scene, timed(scene, *route), {}, {.most_evaluations = 25'000});

    LegMeter legs{scene, RefinementBudget{}};
    const auto again = legs.timed(refined.itinerary.route, core::Seconds{0.0});
    ASSERT_TRUE(again.has_value()) << "no leg is closed";
    EXPECT_EQ(again->times, refined.itinerary.times) << "by the one cost";
    EXPECT_EQ(refined.report.before, legs.timed(*route, core::Seconds{0.0})->travel_time());
    EXPECT_LE(refined.itinerary.travel_time(), refined.report.before);
    EXPECT_EQ(refined.itinerary.route.points.front(), route->points.front());
    EXPECT_EQ(refined.itinerary.route.points.back(), route->points.back());
    std::vector<geo::PlanePoint> kept;
    for (std::size_t i = 0; i < refined.itinerary.route.points.size(); ++i) {
      if (refined.itinerary.route.fixed[i]) kept.push_back(refined.itinerary.route.points[i]);
    }
    EXPECT_EQ(kept, (std::vector{route->points.front(), route->points[via], route->points.back()}));
    ++refined_scenes;
    if (refined.itinerary.travel_time() < 0.995 * refined.report.before) ++faster;
  });
  EXPECT_GT(refined_scenes, 20) << "most scenes have a way";
  EXPECT_GT(2 * faster, refined_scenes) << "grid ways can be shortened, among obstacles too";
}

TEST(Refinement, GoesTightlyRoundADisc) {
  const auto round_the_disc = [](geo::PlanePoint a, geo::PlanePoint b, core::Seconds) -> Leg {
    const double length = distance(a, b);
    const double along =
        length > 0.0
            ? std::clamp(-(a.x_m * (b.x_m - a.x_m) + a.y_m * (b.y_m - a.y_m)) / (length * length), 0.0, 1.0)
            : 0.0;
    if (distance({a.x_m + along * (b.x_m - a.x_m), a.y_m + along * (b.y_m - a.y_m)}, {}) < 1000.0)
      return tl::unexpected(motion::EdgeClosed::obstacle);
    return core::Seconds{length};
  };
  const Lattice lattice{{-3000.0, -2000.0}, 100.0, 100.0, 61, 41, 0, 20, 60, 20};
  // The shortest route: two tangents of sqrt(3000^2 - 1000^2) and the arc between them.
  const double shortest = 2.0 * std::sqrt(8.0e6) + 1000.0 * 2.0 * std::asin(1.0 / 3.0);

  const Refined refined =
      refine_route(round_the_disc, timed(round_the_disc, *way_on(lattice, round_the_disc)), {}, {});

  EXPECT_GE(refined.itinerary.travel_time().count(), shortest);
  EXPECT_LT(refined.itinerary.travel_time().count(), 1.002 * shortest);
}

TEST(Refinement, GivesTheSameRouteForTheSameInput) {
  support::for_each_seed(3, [](std::mt19937_64& rng) {
    const RandomScene scene{rng};
    const auto route = way_on(scene_lattice, scene);
    if (!route) return;
    const RefinementBudget budget{.most_evaluations = 30'000};

    const Refined once = refine_route(scene, timed(scene, *route), {}, budget);
    const Refined twice = refine_route(scene, timed(scene, *route), {}, budget);

    EXPECT_EQ(once.itinerary.route.points, twice.itinerary.route.points);
    EXPECT_EQ(once.report.trade, twice.report.trade);
    EXPECT_EQ(once.report.evaluations, twice.report.evaluations);
  });
}

TEST(Refinement, EndsWithItsBudgetAndKeepsWhatItHasFound) {
  const cost::Route route = *way_on(jet_lattice, jet);
  for (const std::int64_t most : {0, 1, 500, 20'000}) {
    const Refined refined = refine_route(jet, timed(jet, route), {}, {.most_evaluations = most});

    EXPECT_EQ(refined.report.end, RefinementEnd::evaluations);
    EXPECT_EQ(refined.report.evaluations, most);
    EXPECT_LE(refined.itinerary.travel_time(), refined.report.before);
  }
}

TEST(Refinement, LeavesNoPointTwiceWhenItsBudgetHasEnded) {
  cost::Route route = *way_on(jet_lattice, jet);
  const auto again = static_cast<std::ptrdiff_t>(route.points.size() / 2);
  route.points.insert(route.points.begin() + again, route.points[static_cast<std::size_t>(again)]);
  route.fixed.insert(route.fixed.begin() + again, false);
  for (const std::int64_t most : {0, 500}) {
    const Refined refined = refine_route(jet, timed(jet, route), {}, {.most_evaluations = most});

    ASSERT_EQ(refined.report.end, RefinementEnd::evaluations);
    const std::vector<geo::PlanePoint>& points = refined.itinerary.route.points;
    EXPECT_EQ(std::ranges::adjacent_find(points), points.end()) << most;
  }
}

TEST(Refinement, EndsWhenItIsCancelled) {
  const cost::Route route = *way_on(jet_lattice, jet);
  std::stop_source source;
  source.request_stop();
  const Refined cancelled = refine_route(jet, timed(jet, route), {}, {.stop = source.get_token()});
  EXPECT_EQ(cancelled.report.end, RefinementEnd::cancelled);
  EXPECT_EQ(cancelled.itinerary.route.points, route.points);
}

}  // namespace
}  // namespace floeplan::planning::refinement::refinement_test
