#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/codec/documents/plan_document.hpp"
#include "api/codec/inputs/plan_input_parts.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec::refinement_test {
namespace {

using nlohmann::json;
using testing::IsEmpty;
using testing::SizeIs;

planning::Plan refined_plan() {
  planning::Plan plan;
  plan.departure = core::parse_iso8601("2026-11-20T06:00:00Z").value();
  plan.arrival = plan.departure + core::Seconds{7000.0};
  plan.refinement = planning::RefinementReport{.before = core::Seconds{7200.0},
                                               .after = core::Seconds{7000.0},
                                               .evaluations = 12'345,
                                               .end = planning::RefinementEnd::evaluations,
                                               .trade = {{.legs = 1, .travel_time = core::Seconds{8000.0}},
                                                         {.legs = 2, .travel_time = core::Seconds{7000.0}}}};
  return plan;
}

TEST(RefinementReport, IsWrittenBesideThePlan) {
  const json document = plan_document(refined_plan(), "p1", "");

  EXPECT_EQ(document["refinement"], json::parse(R"({"before_s": 7200.0, "after_s": 7000.0,
                                                    "evaluations": 12345, "stopped_by": "evaluations"})"));
  EXPECT_EQ(document["leg_trade"], json::parse(R"([{"legs": 1, "travel_time_s": 8000.0},
                                                   {"legs": 2, "travel_time_s": 7000.0}])"));
}

TEST(RefinementReport, IsReadBackAsItWasWritten) {
  const json document = plan_document(refined_plan(), "p1", "");

  EXPECT_EQ(plan_document(parse_plan_document(document), "p1", ""), document);
}

TEST(RefinementReport, IsEmptyInAPlanThatWasNotRefinedOrIsOlder) {
  planning::Plan plan = refined_plan();
  plan.refinement.reset();
  json document = plan_document(plan, "p1", "");
  EXPECT_TRUE(document["refinement"].is_null());
  EXPECT_THAT(document["leg_trade"], IsEmpty());

  document.erase("refinement");
  document.erase("leg_trade");
  EXPECT_FALSE(parse_plan_document(document).refinement.has_value());
}

TEST(RefineSeconds, AreReadAndWrittenOut) {
  const json inputs{{"refine_seconds", 2.5}};
  InputReader reader{inputs};
  planning::PlanRequest request;

  read_search(reader, request);
  json written;
  write_search(request, written);

  EXPECT_THAT(reader.violations(), IsEmpty());
  EXPECT_EQ(request.refine_time, core::Seconds{2.5});
  EXPECT_EQ(written["refine_seconds"], 2.5);
}

TEST(RefineSeconds, AreRefusedOutsideTheirRange) {
  for (const json& wrong : {json(0.0), json(61), json(-1.0), json("1"), json(true)}) {
    const json inputs{{"refine_seconds", wrong}};
    InputReader reader{inputs};
    planning::PlanRequest request;

    read_search(reader, request);

    ASSERT_THAT(reader.violations(), SizeIs(1)) << wrong;
    EXPECT_EQ(reader.violations().front().field, "/refine_seconds");
  }
}

}  // namespace
}  // namespace floeplan::codec::refinement_test
