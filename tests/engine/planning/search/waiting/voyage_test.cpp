#include "engine/planning/search/waiting/voyage.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/search/route_search.hpp"
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

}  // namespace
}  // namespace floeplan::planning::search::voyage_test
