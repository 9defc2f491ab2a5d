#include "engine/mission/writing/below_ice.hpp"

#include <gmock/gmock.h>

#include "tests/engine/mission/random_plan.hpp"

namespace floeplan::mission::below_ice_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Three waypoints; below ice that makes dives turn at `turn_m` on the leg to the second, where `may_surface` says.
planning::Plan plan_below(double turn_m, bool may_surface) {
  planning::Plan plan = support::plan_of({{-53.1, 69.0}, {-52.8, 69.0}, {-52.5, 69.0}});
  plan.surfacing.emplace().waypoints.resize(3);
  for (planning::SurfacingState& state : plan.surfacing->waypoints) state.leg_upper_turn = core::Metres{0.0};
  plan.surfacing->waypoints[1].leg_upper_turn = core::Metres{turn_m};
  plan.surfacing->waypoints[1].may_surface = may_surface;
  plan.surfacing->waypoints[1].least_upper_turn = core::Metres{may_surface ? 0.0 : turn_m};
  return plan;
}

TEST(BelowIce, TellsWhatHasComeToLieAboveAPlan) {
  const planning::Plan open = plan_below(0.0, true);
  planning::Plan without_ice = open;
  without_ice.surfacing.reset();

  for (const planning::Plan& plan : {open, without_ice}) {
    EXPECT_THAT(closed_above_since(plan, plan_below(57.6, false)),
                ElementsAre(HasSubstr("at 58 m or deeper. The plan was made for open water"),
                            HasSubstr("must not surface at waypoints 1, although")));
  }
  EXPECT_THAT(closed_above_since(plan_below(22.0, false), plan_below(30.0, false)),
              ElementsAre(HasSubstr("at 30 m or deeper. The plan was made for 22 m")));
}

TEST(BelowIce, FindsNothingAbovePlansThatTurnAsDeepAsTheyMust) {
  EXPECT_THAT(closed_above_since(plan_below(0.0, true), plan_below(0.0, true)), IsEmpty());
  EXPECT_THAT(closed_above_since(plan_below(30.0, false), plan_below(30.0, false)), IsEmpty());
  EXPECT_THAT(closed_above_since(plan_below(30.0, false), plan_below(22.0, true)), IsEmpty());
}

}  // namespace
}  // namespace floeplan::mission::below_ice_test
