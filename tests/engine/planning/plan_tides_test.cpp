#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "engine/ocean/currents/tide_overlay.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_tides_test {
namespace {

/// A tide that runs east and west along the route, growing from west to east.
std::vector<ocean::TideGrid> tide_along_the_way() {
  const ocean::HorizontalGrid grid = support::sea_grid();
  ocean::TideGrid::Line m2{tide::find_constituent("M2").value(), {}, {}, {}};
  ocean::TideGrid::Line k1{tide::find_constituent("K1").value(), {}, {}, {}};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const double lon_deg = grid.place(i % grid.x().size(), i / grid.x().size()).lon_deg;
    const double amplitude = 0.1 + 0.05 * (lon_deg + 56.0);
    m2.east.push_back(std::complex<float>{tide::harmonic_value(amplitude, 40.0)});
    m2.north.push_back(std::complex<float>{tide::harmonic_value(0.05, 100.0)});
    k1.east.push_back(std::complex<float>{tide::harmonic_value(0.05, 200.0)});
    k1.north.push_back({});
  }
  return {ocean::TideGrid{{grid, {m2, k1}}}};
}

/// The same currents as plain data at each step of the tide.
std::shared_ptr<const ocean::CurrentGrid> written_out(const ocean::CurrentGrid& currents) {
  const ocean::HorizontalGrid& grid = currents.samples().grid;
  ocean::CurrentGrid::Samples samples{
      .grid = grid, .depths_m = std::nullopt, .times_s = currents.times_s(), .u = {}, .v = {}};
  for (std::size_t t = 0; t < currents.times_s().size(); ++t) {
    for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
      for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
        const auto water = currents.column_at_node(ix, iy, t).value().mean({0.0}, {0.0});
        samples.u.push_back(static_cast<float>(water.east.value));
        samples.v.push_back(static_cast<float>(water.north.value));
      }
    }
  }
  return std::make_shared<const ocean::CurrentGrid>(std::move(samples));
}

TEST(PlanInTides, IsThePlanInTheSameCurrentsAsData) {
  const core::UtcTime start = core::from_unix_seconds(support::sea_start_s);
  ocean::Environment tidal;
  tidal.currents = std::make_shared<const ocean::CurrentGrid>(
      ocean::tide_alone(tide_along_the_way(), {start, start + core::Seconds{5.0 * 86'400.0}}));
  ocean::Environment plain = tidal;
  plain.currents = written_out(*tidal.currents);
  PlanRequest request = support::eastward_request();
  request.to = {-53.0, 69.05};
  request.depart = start + core::Seconds{3600.0};
  request.refine = false;

  const auto in_tide = plan_route(tidal, request, {}, {});
  const auto in_data = plan_route(plain, request, {}, {});

  ASSERT_TRUE(in_tide);
  ASSERT_TRUE(in_data);
  EXPECT_EQ(in_tide->waypoints.size(), in_data->waypoints.size());
  EXPECT_NEAR(in_tide->travel_time().count(), in_data->travel_time().count(), 1.0);
}

TEST(PlanInTides, GainsFromWaitingForTheTideToTurn) {
  const core::UtcTime start = core::from_unix_seconds(support::sea_start_s);
  ocean::Environment tidal;
  tidal.currents = std::make_shared<const ocean::CurrentGrid>(
      ocean::tide_alone(tide_along_the_way(), {start, start + core::Seconds{5.0 * 86'400.0}}));
  PlanRequest request = support::eastward_request();
  request.from = {-53.2, 69.0};
  request.to = {-53.1, 69.0};
  double shortest = 1e9;
  double longest = 0.0;
  for (int hour = 0; hour < 13; ++hour) {
    request.depart = start + core::Seconds{3600.0 * hour};
    request.refine = false;
    const auto plan = plan_route(tidal, request, {}, {});
    ASSERT_TRUE(plan);
    const double taken = plan->travel_time().count();
    shortest = std::min(shortest, taken);
    longest = std::max(longest, taken);
  }

  // 4 km at 0.35 m/s with and against a current of a good 0.2 m/s.
  EXPECT_LT(shortest, 9000.0);
  EXPECT_GT(longest, 15'000.0);
}

}  // namespace
}  // namespace floeplan::planning::plan_tides_test
