#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/codec/plan_document.hpp"

namespace floeplan::codec::infeasible_document_test {
namespace {

TEST(InfeasibleDocument, TellsAChangeWithTheOneThatBelongsToIt) {
  planning::Infeasible why;
  why.reason = planning::Reason::goal_unreachable;
  why.binding = planning::Constraint::zone;
  const planning::Change depth{"vehicle/minimum_working_depth_m", 180.0, 149.0, "work in water of 149 m"};
  why.changes = {
      {"areas/features/0", std::string{"bank"}, std::string{}, "leave out the area, and work", {depth}}};

  const nlohmann::json document = infeasible_document(why, {});

  const nlohmann::json& change = document.at("smallest_change");
  EXPECT_EQ(change, document.at("changes").at(0));
  EXPECT_EQ(change.at("with").at(0).at("input"), "vehicle/minimum_working_depth_m");
  EXPECT_EQ(change.at("with").at(0).at("to"), 149.0);
  EXPECT_TRUE(change.at("with").at(0).at("with").empty());
}

}  // namespace
}  // namespace floeplan::codec::infeasible_document_test
