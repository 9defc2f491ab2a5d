#include "engine/mission/checking/plan_comparison.hpp"

#include <gmock/gmock.h>

#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/goto_lists.hpp"
#include "tests/engine/mission/random_plan.hpp"

namespace floeplan::mission::plan_comparison_test {
namespace {

using testing::ElementsAre;

constexpr core::Seconds hour{3600.0};

planning::Plan holding_plan() {
  planning::Plan plan = support::plan_of({{-53.2, 69.2}, {-53.1, 69.2}, {-53.0, 69.2}, {-52.8, 69.2}});
  plan.waypoints[2].wait = 4.0 * hour;
  plan.waypoints[3].eta += plan.waypoints[2].wait;
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i)
    plan.waypoints[i].current = geo::VelocityEn{{0.1}, {0.05}};
  return plan;
}

std::vector<Document> written(const planning::Plan& plan) {
  const MissionFiles lists = write_goto_lists(plan, {}).value();
  std::vector<Document> documents;
  for (const MissionFile& file : lists.files) documents.push_back(read_document(file.name, file.text));
  return documents;
}

/// Codes of the warnings and of the note that all is as planned.
std::vector<std::string> codes(const std::vector<Document>& documents) {
  std::vector<std::string> found;
  for (const Document& document : documents)
    for (const Message& message : document.messages)
      if (message.severity != Severity::note || message.code == "as_planned") found.push_back(message.code);
  return found;
}

std::vector<std::string> compared(std::vector<Document> documents, const planning::Plan& plan) {
  compare_with_plan(documents, plan, {});
  return codes(documents);
}

TEST(PlanComparison, FindsTheListsOfAPlanAsPlanned) {
  EXPECT_THAT(compared(written(holding_plan()), holding_plan()), ElementsAre("as_planned"));
}

TEST(PlanComparison, NamesAHoldOfAnotherLength) {
  planning::Plan longer = holding_plan();
  longer.waypoints[2].wait = 6.0 * hour;
  longer.waypoints[3].eta += 2.0 * hour;

  EXPECT_THAT(compared(written(holding_plan()), longer),
              ElementsAre("hold_of_other_time", "hold_of_other_length"));
}

TEST(PlanComparison, NamesAHoldThatIsNotPlannedOrMissing) {
  planning::Plan without = holding_plan();
  without.waypoints[2].wait = core::Seconds{0.0};

  EXPECT_THAT(compared(written(holding_plan()), without), ElementsAre("hold_not_in_plan"));
  std::vector<Document> lists = written(holding_plan());
  lists.erase(lists.begin() + 1);
  EXPECT_THAT(compared(lists, holding_plan()), ElementsAre("hold_missing"));
}

TEST(PlanComparison, NamesAHoldElsewhere) {
  planning::Plan moved = holding_plan();
  moved.waypoints[2].place.lat_deg += 0.01;
  std::vector<Document> lists = written(holding_plan());
  lists[1] = written(moved)[1];

  EXPECT_THAT(compared(lists, holding_plan()), ElementsAre("hold_beyond_circle"));
}

TEST(PlanComparison, NamesWaypointsThatAreLeftOutOrNotOfThePlan) {
  planning::Plan shorter = holding_plan();
  shorter.waypoints.erase(shorter.waypoints.begin() + 1);
  planning::Plan other = holding_plan();
  other.waypoints[1].place.lat_deg += 0.1;

  EXPECT_THAT(compared(written(shorter), holding_plan()), ElementsAre("waypoint_left_out"));
  EXPECT_THAT(compared(written(other), holding_plan()),
              ElementsAre("waypoint_not_in_plan", "waypoint_left_out"));
  EXPECT_THAT(compared({written(holding_plan())[0]}, holding_plan()),
              ElementsAre("waypoint_left_out", "hold_missing"));
}

}  // namespace
}  // namespace floeplan::mission::plan_comparison_test
