#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/messages/sentence.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/publish/warnings.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::publish::water_warnings_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> warnings_in(std::shared_ptr<const ocean::CurrentGrid> currents) {
  ocean::Environment environment;
  environment.currents = std::move(currents);
  environment.steady_currents = true;
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  const auto plan = plan_route(environment, request, {}, {});
  EXPECT_TRUE(plan.has_value());
  return plan ? messages::sentences(plan->messages) : std::vector<std::string>{};
}

std::vector<std::string> warnings_in(geo::VelocityEn everywhere) {
  return warnings_in(support::currents_from([=](geo::LonLat, double) { return everywhere; }, 1));
}

/// Still water on levels down to 300 m, known on the first `wet` of them.
std::shared_ptr<const ocean::CurrentGrid> still_water_on(std::size_t wet) {
  const ocean::HorizontalGrid grid = support::sea_grid();
  const ocean::Axis levels{{0.0, 20.0, 60.0, 140.0, 300.0}};
  std::vector<float> east(levels.size() * grid.size(), 0.0F);
  std::fill(east.begin() + static_cast<std::ptrdiff_t>(wet * grid.size()), east.end(), NAN);
  const ocean::Axis times{{support::sea_start_s}};
  return std::make_shared<const ocean::CurrentGrid>(
      ocean::CurrentGrid::Samples{.grid = grid, .depths_m = levels, .times_s = times, .u = east, .v = east});
}

TEST(WaterWarnings, TellWhereACurrentLeavesHardlyAnySpeed) {
  const auto hardly = Contains(HasSubstr("drift off the route"));

  EXPECT_THAT(warnings_in({{0.0}, {0.345}}), hardly);   // 0.35 m/s through the water, across
  EXPECT_THAT(warnings_in({{-0.338}, {0.0}}), hardly);  // ahead
  EXPECT_THAT(warnings_in({{0.0}, {0.32}}), Not(hardly));
  EXPECT_THAT(warnings_in({{0.345}, {0.0}}), Not(hardly)) << "astern it takes nothing";
}

TEST(WaterWarnings, TellWhereDivesGoMuchDeeperThanTheCurrentsAreKnown) {
  const auto unknown = Contains(HasSubstr("At worst they go to 200 m, where the currents end at 100 m"));

  EXPECT_THAT(warnings_in(still_water_on(3)), unknown);
  EXPECT_THAT(warnings_in(still_water_on(4)), Not(Contains(HasSubstr("go deeper than the current model"))));
  EXPECT_THAT(warnings_in(still_water_on(5)), Not(Contains(HasSubstr("go deeper than the current model"))));
}

}  // namespace
}  // namespace floeplan::planning::publish::water_warnings_test
