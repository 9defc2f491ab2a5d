#include "engine/planning/search/bounds/arrival_ladder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/engine/planning/search/bounds/foresight_waters.hpp"

namespace floeplan::planning::search::arrival_ladder_test {
namespace {

using graph::SearchTree;
using graph::Vertex;

TEST(ArrivalLadder, IsNeverLaterThanAnArrivalThatIsPossible) {
  int bounded = 0;
  support::for_each_seed(6, [&](std::mt19937_64& rng) {
    const Waters waters{random_environment(rng)};
    const core::Seconds depart{support::uniform(rng, 0.0, 40'000.0)};
    const GridTravelTime exact{waters.sea, waters.grid};
    const SearchTree all = graph::find_earliest_arrivals(
        waters.open.graph, graph::Query{waters.grid.start, {}, depart}, exact, {});
    if (!all.is_reached(waters.grid.goal)) return;
    const double best_s = all.arrival_s(waters.grid.goal);
    const core::Seconds last{best_s + 0.3 * (best_s - depart.count())};
    Foresight foresight{waters.sea, waters.open};
    ArrivalLadder ladder{foresight, waters.open, depart, last, {}};
    ASSERT_TRUE(ladder.has_hope());

    for (int i = 0; i < 20; ++i) {
      const Vertex v = random_vertex(rng, waters.open);
      if (!all.is_reached(v) || v == waters.grid.goal) continue;
      const double here_s = all.arrival_s(v) + support::uniform(rng, 0.0, 5'000.0);
      const SearchTree onward = graph::find_earliest_arrivals(
          waters.open.graph, graph::Query{v, waters.grid.goal, core::Seconds{here_s}}, exact, {});
      const double arrival_s = onward.arrival_s(waters.grid.goal);
      const double bound_s = ladder.earliest_s(v, here_s);
      if (arrival_s <= last.count()) {
        EXPECT_LE(bound_s, arrival_s);
        EXPECT_LE(here_s, ladder.latest_use_s(v));
      } else {
        EXPECT_LE(bound_s, std::isinf(bound_s) ? bound_s : last.count());
      }
      if (bound_s > best_s) ++bounded;
      EXPECT_LE(bound_s, ladder.earliest_s(v, here_s + 1'000.0)) << "later at a place, no earlier bound";
    }
  });
  EXPECT_GT(bounded, 0) << "it says something";
}

TEST(ArrivalLadder, IsNeverLaterThanAWayAmongIcebergsThatDrift) {
  int found = 0;
  support::for_each_seed(8, [&](std::mt19937_64& rng) {
    ocean::Environment environment = random_environment(rng);
    for (int i = 0; i < 10; ++i) {
      const geo::LonLat place{support::uniform(rng, -53.4, -52.6), support::uniform(rng, 68.9, 69.1)};
      environment.icebergs.push_back(
          drifting_berg(place, 200.0, support::uniform(rng, 0.0, 0.3), support::uniform(rng, 0.0, 360.0)));
    }
    const Waters waters{environment};
    const core::Seconds depart{0.0};
    const SearchTree tree = graph::find_earliest_arrivals(
        waters.open.graph, graph::Query{waters.grid.start, waters.grid.goal, depart},
        GridTravelTime{waters.sea, waters.grid}, {});
    if (!tree.is_reached(waters.grid.goal)) return;
    ++found;
    const double arrival_s = tree.arrival_s(waters.grid.goal);
    Foresight foresight{waters.sea, waters.open};
    const ArrivalLadder ladder{foresight, waters.open, depart, core::Seconds{1.2 * arrival_s}, {}};

    ASSERT_TRUE(ladder.has_hope());
    for (const Vertex v : graph::path_to(waters.open.graph, tree, waters.grid.goal)) {
      EXPECT_LE(ladder.earliest_s(v, tree.arrival_s(v)), arrival_s);
      EXPECT_LE(tree.arrival_s(v), ladder.latest_use_s(v));
    }
  });
  EXPECT_GT(found, 2);
}

TEST(ArrivalLadder, HasNoHopeOfAnArrivalThatNoVehicleMakes) {
  const Waters waters{{.currents = support::currents_from(
                           [](geo::LonLat, double) { return geo::VelocityEn{{-0.05}, {0.0}}; }, 120)}};
  Foresight foresight{waters.sea, waters.open};
  const double straight_s = 40'000.0 / (waters.sea.through_water().value - 0.05);

  EXPECT_FALSE((ArrivalLadder{foresight, waters.open, core::Seconds{0.0}, core::Seconds{0.9 * straight_s}, {}}
                    .has_hope()));
  EXPECT_TRUE((ArrivalLadder{foresight, waters.open, core::Seconds{0.0}, core::Seconds{1.1 * straight_s}, {}}
                   .has_hope()));
}

}  // namespace
}  // namespace floeplan::planning::search::arrival_ladder_test
