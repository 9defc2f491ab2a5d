#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using support::json_of;
using MissionCheckTest = support::ApiTest;

const std::string list =
    "behavior_name=goto_list\n<start:b_arg>\nb_arg: num_waypoints(nodim) 1\n<end:b_arg>\n"
    "<start:waypoints>\n-7348.0000\t3917.0000\n<end:waypoints>\n";

TEST_F(MissionCheckTest, ASoundListIsReadAndNoted) {
  const auto response = ask("POST", "/missions/check?name=goto_l10.ma", list);

  EXPECT_EQ(response.status, 200);
  const json answer = json_of(response);
  EXPECT_EQ(answer["file"], "goto_l10.ma");
  EXPECT_EQ(answer["kind"], "ma");
  EXPECT_EQ(answer["verdict"], "ok");
  EXPECT_EQ(answer["behavior"], "goto_list");
  EXPECT_EQ(answer["b_args"][0], json::parse(R"({"name":"num_waypoints","unit":"nodim","value":1.0,"raw":"1",
                                                 "line":3})"));
  EXPECT_DOUBLE_EQ(answer["waypoints"][0]["lon"], -73.8);
  EXPECT_EQ(answer["messages"][0]["code"], "list_when_wpt_dist_not_given");
}

TEST_F(MissionCheckTest, ARejectedFileIsAnAnswerWithItsReason) {
  const json answer = json_of(ask("POST", "/missions/check?name=a.mi", "b_arg: overtime(sec) 10\n"));

  EXPECT_EQ(answer["verdict"], "reject");
  EXPECT_EQ(answer["messages"].back()["line"], 1);
}

TEST_F(MissionCheckTest, JunkIsAnswered) {
  EXPECT_EQ(json_of(ask("POST", "/missions/check", ""))["verdict"], "reject");
  EXPECT_EQ(json_of(ask("POST", "/missions/check", std::string(100'000, '\0')))["verdict"], "reject");
  EXPECT_EQ(json_of(ask("POST", "/missions/check?name=%ff.ma", "\xff\xfe"))["verdict"], "reject");
  EXPECT_EQ(ask("POST", "/missions/check?name=" + std::string(201, 'x'), list).status, 400);
  EXPECT_EQ(ask("GET", "/missions/check").status, 405);
}

TEST_F(MissionCheckTest, WithADepartureTheRouteIsFollowedThroughTheStoredData) {
  const json answer =
      json_of(ask("POST", "/missions/check?name=goto_l10.ma&depart=2026-11-20T06:00:00Z&from=-74,39", list));

  EXPECT_EQ(answer["verdict"], "ok") << answer["messages"];
  EXPECT_THAT(answer["messages"].dump(), testing::HasSubstr("route_clear"));
}

TEST_F(MissionCheckTest, FaultsOfTheFlightAreListed) {
  const auto response = ask("POST", "/missions/check?depart=soon&vehicle=whale&margin_m=wide", list);

  EXPECT_EQ(response.status, 400);
  for (const char* field : {"/depart", "/vehicle", "/margin_m"})
    EXPECT_THAT(response.body, testing::HasSubstr(field));
  EXPECT_EQ(ask("POST", "/missions/check?from=here", list).status, 400);
}

}  // namespace
}  // namespace floeplan::routes
