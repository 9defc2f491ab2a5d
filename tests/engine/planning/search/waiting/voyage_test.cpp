#include "engine/planning/search/waiting/voyage.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/planning/cost/loiter.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/search/route_search.hpp"
#include "engine/planning/search/waiting/later_ways.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::voyage_test {
namespace {

const geo::LocalProjection projection{{-53.0, 69.0}};
constexpr std::size_t plenty = 1'000'000;

TEST(Voyage, WithNothingToCarryArrivesWhenThePlainSearchDoes) {
  support::for_each_seed(5, [](std::mt19937_64& rng) {
    const double phase = support::uniform(rng, 0.0, 6.28);
    const ocean::Environment environment{.currents = support::currents_from(
                                             [&](geo::LonLat p, double hour) {
                                               return geo::VelocityEn{
                                                   {0.1 * std::cos(hour / 2.0 + phase)},
                                                   {0.15 * std::sin(hour / 2.0 + 4.0 * p.lon_deg)}};
                                             },
                                             240)};
    const PlanRequest request = support::eastward_request();
    const cost::RouteGrid grid = cost::lay_grid({-20'000.0, 0.0}, {20'000.0, 3000.0},
                                                {core::Metres{2000.0}, core::Metres{2000.0}}, {0.5, 0.25});
    const cost::Sea sea{environment, request, projection, grid.bounds().grown(2000.0), core::Metres{500.0}};
    const OpenGrid open = open_grid(sea, grid, request.sectors, {});
    const core::Seconds whenever{INFINITY};
    const Openings openings{sea, open, whenever, {}};
    Voyage voyage{sea, grid, openings, whenever};

    const auto search =
        graph::find_best_labels(open.graph, grid.start, grid.goal, 0.0, {}, voyage, plenty, {});

    const RouteSearch plain = search_route(sea, open, request, core::Seconds{0.0}, {}, [](double) {});
    const auto arrivals = cost::arrivals_along(sea, plain.path, core::Seconds{0.0});
    ASSERT_TRUE(search.goal && arrivals);
    EXPECT_NEAR(search.labels[*search.goal].arrival_s, arrivals->back().count(), 1e-6);
  });
}

/// A goal that a disc keeps until some hours after the vehicle could be there, and leave to wait for that.
class VoyageToAGoalThatOpens : public testing::Test {
 protected:
  static constexpr core::Seconds whenever{INFINITY};

  VoyageToAGoalThatOpens() {
    environment_.icebergs = {
        drifting_berg(projection.to_lon_lat(grid_.point(grid_.goal)), 1000.0, 0.02, 0.0)};
    request_.max_loiter = core::Seconds{24.0 * hour_s};
    request_.icebergs.max_inflation = core::Metres{1000.0};
  }

  PlanRequest request_{support::eastward_request()};
  ocean::Environment environment_;
  cost::RouteGrid grid_{cost::lay_grid({-12'000.0, 0.0}, {12'000.0, 0.0},
                                       {core::Metres{1000.0}, core::Metres{1000.0}}, {0.5, 0.5})};
};

TEST_F(VoyageToAGoalThatOpens, EndsWhenItDoesAndIsBoundedByThat) {
  const cost::Sea sea{environment_, request_, projection, grid_.bounds().grown(2000.0), core::Metres{500.0}};
  const OpenGrid open = open_grid(sea, grid_, request_.sectors, {});
  const Openings openings{sea, open, whenever, {}};
  Voyage voyage{sea, grid_, openings, whenever};
  const std::vector<TimeSpan> closed = sea.closed_times(grid_.point(grid_.goal));
  ASSERT_EQ(closed.size(), 1U);

  const auto search =
      graph::find_best_labels(open.graph, grid_.start, grid_.goal, 0.0, {}, voyage, plenty, {});

  ASSERT_TRUE(search.goal);
  const double arrival_s = search.labels[*search.goal].arrival_s;
  EXPECT_NEAR(arrival_s, closed[0].until.count(), cost::fineness_of_waits(core::Seconds{hour_s}).count());
  for (const auto& label : graph::way_to(search, *search.goal)) {
    const double bound_s = voyage.key(label.vertex, label.arrival_s, label.state);
    EXPECT_LE(bound_s, arrival_s);
    EXPECT_GE(bound_s, closed[0].until.count());
  }
}

TEST_F(VoyageToAGoalThatOpens, IsFoundWithoutALookAtEveryPlaceToWait) {
  const cost::Sea sea{environment_, request_, projection, grid_.bounds().grown(2000.0), core::Metres{500.0}};
  const OpenGrid open = open_grid(sea, grid_, request_.sectors, {});

  const LaterWay later =
      search_later_ways(sea, open, core::Seconds{0.0}, whenever, core::Seconds{1.0}, plenty, {});

  ASSERT_FALSE(later.path.empty());
  EXPECT_LT(later.counters.expansions, open.vertices / 4);
}

}  // namespace
}  // namespace floeplan::planning::search::voyage_test
