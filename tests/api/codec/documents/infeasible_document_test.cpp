#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/codec/documents/plan_document.hpp"
#include "engine/messages/refusal_messages.hpp"

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

TEST(InfeasibleDocument, TellsWhatStandsInTheWayAndWhatWasFoundOutBesides) {
  planning::Infeasible why;
  why.why = messages::refusal<"way-in-zone">().at({-53.0, 69.0});
  why.besides = {messages::refusal<"way-without-zones">(), messages::refusal<"area-searched">(104.0)};

  const nlohmann::json document = infeasible_document(why, {});

  EXPECT_EQ(document.at("explanation"),
            "the route breaks the rule of a zone. Without the zones, a route exists. The search went up to "
            "104 km to "
            "either side of the direct line and beyond its ends");
  EXPECT_EQ(document.at("suggestion"), "Change the zones or their times");
  EXPECT_EQ(document.at("why").at(0).at("code"), "way-in-zone");
  EXPECT_EQ(document.at("why").at(0).at("place").at("lat"), 69.0);
  EXPECT_EQ(document.at("why").at(2).at("values").at("beside_km"), 104.0);
  EXPECT_TRUE(document.at("warnings").empty()) << "these are of the data";
}

}  // namespace
}  // namespace floeplan::codec::infeasible_document_test
