#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::mission_check_test {
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

  EXPECT_EQ(answer["verdict"], "warn") << answer["messages"];
  EXPECT_THAT(answer["messages"].dump(), testing::HasSubstr("route_clear"));
  EXPECT_THAT(answer["messages"].dump(), testing::HasSubstr("no bathymetry is stored"))
      << "the store is empty";
}

TEST_F(MissionCheckTest, OfAMessageInEveryLineTheFirstOfEachSeverityAreListed) {
  std::string mission = "behavior: yo\n";
  for (int i = 0; i < 2'000; ++i) mission += "b_arg: d_target_depth(m) " + std::to_string(i) + "\n";

  const json answer = json_of(ask("POST", "/missions/check?name=a.mi", mission));

  EXPECT_EQ(answer["verdict"], "reject");
  EXPECT_EQ(answer["b_args"].size() + answer["behaviors"][0]["b_args"].size(), 2'000U);
  EXPECT_LT(answer["messages"].size(), 610U);
  EXPECT_THAT(answer["messages"].dump(), testing::HasSubstr("from here on are not listed"));
}

TEST_F(MissionCheckTest, VeryManyFaultsAreListedInPart) {
  std::string files = R"({"files":[{})";
  for (int i = 0; i < 300'000; ++i) files += ",{}";

  const auto response = ask("POST", "/missions/check", files + "]}", {{"content-type", "application/json"}});

  EXPECT_EQ(response.status, 400);
  EXPECT_LT(response.body.size(), 100'000U);
}

TEST_F(MissionCheckTest, FaultsOfTheFlightAreListed) {
  const auto response = ask("POST", "/missions/check?depart=soon&vehicle=whale&margin_m=wide", list);

  EXPECT_EQ(response.status, 400);
  for (const char* field : {"/depart", "/vehicle", "/margin_m"})
    EXPECT_THAT(response.body, testing::HasSubstr(field));
  EXPECT_EQ(ask("POST", "/missions/check?from=here", list).status, 400);
}

const std::string mission =
    "behavior: abend\nb_arg: overdepth(m) 150\nbehavior: goto_list\nb_arg: args_from_file(enum) 10\n"
    "behavior: yo\nb_arg: args_from_file(enum) 10\n";
const std::string yo =
    "behavior_name=yo\n<start:b_arg>\nb_arg: d_target_depth(m) 180\nb_arg: d_target_altitude(m) "
    "10\n<end:b_arg>\n";

std::vector<std::string> codes_of(const json& document) {
  std::vector<std::string> codes;
  for (const json& message : document["messages"]) codes.push_back(message["code"]);
  return codes;
}

std::string form_of(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string body;
  for (const auto& [name, text] : files) {
    body += "--XX\r\nContent-Disposition: form-data; name=\"file\"; filename=\"" + name + "\"\r\n\r\n" +
            text + "\r\n";
  }
  return body + "--XX--\r\n";
}

TEST_F(MissionCheckTest, AMissionIsJudgedTogetherWithItsArgumentFiles) {
  const std::map<std::string, std::string> as_form{{"content-type", "multipart/form-data; boundary=XX"}};
  const std::string flight = "/missions/check?depart=2026-11-20T06:00:00Z";

  const auto whole =
      ask("POST", flight,
          form_of({{"plan.mi", mission}, {"C:\\mafiles\\goto_l10.ma", list + "# \xe9\n"}, {"yo10.ma", yo}}),
          as_form);
  ASSERT_EQ(whole.status, 200) << whole.body;
  const json answer = json_of(whole);
  ASSERT_EQ(answer.size(), 3U);
  EXPECT_EQ(answer[1]["file"], "goto_l10.ma");
  EXPECT_EQ(answer[1]["encoding"], "iso-8859-1");
  EXPECT_EQ(answer[0]["verdict"], "reject");
  EXPECT_THAT(codes_of(answer[0]), testing::Contains("target_below_overdepth"));
  EXPECT_THAT(codes_of(answer[0]), testing::Not(testing::Contains("file_missing")));

  const json without_yo =
      json_of(ask("POST", flight, form_of({{"plan.mi", mission}, {"goto_l10.ma", list}}), as_form));
  EXPECT_THAT(codes_of(without_yo[0]), testing::Contains("file_missing"));
  EXPECT_EQ(ask("POST", flight, form_of({}), as_form).status, 400);
  EXPECT_EQ(
      ask("POST", flight, form_of(std::vector(101, std::pair<std::string, std::string>{"a.ma", ""})), as_form)
          .status,
      400);
}

TEST_F(MissionCheckTest, FilesComeAsJsonTooWithTheInputsOfTheirFlight) {
  const std::map<std::string, std::string> as_json{{"content-type", "application/json; charset=utf-8"}};
  const json files{{{"name", "plan.mi"}, {"text", mission}},
                   {{"name", "yo10.ma"}, {"text", yo}},
                   {{"name", "goto_l10.ma"}, {"text", list}}};
  const json no_go =
      json::parse(R"({"type":"Feature","properties":{"kind":"no_go","name":"range"},"geometry":{
      "type":"Polygon","coordinates":[[[-74,39],[-73.5,39],[-73.5,39.5],[-74,39.5],[-74,39]]]}})");

  const json read = json_of(ask("POST", "/missions/check", json{{"files", files}}.dump(), as_json));
  EXPECT_EQ(read.size(), 3U);
  EXPECT_EQ(read[2]["verdict"], "ok");

  json flight{{"depart", "2026-11-20T06:00:00Z"}, {"areas", no_go}, {"from", {-73.9, 39.2}}};
  const auto judged =
      ask("POST", "/missions/check", json{{"files", files}, {"inputs", flight}}.dump(), as_json);
  ASSERT_EQ(judged.status, 200) << judged.body;
  EXPECT_EQ(json_of(judged)[2]["verdict"], "reject") << "inside the area";
  flight["from"] = "here";
  EXPECT_EQ(ask("POST", "/missions/check", json{{"files", files}, {"inputs", flight}}.dump(), as_json).status,
            400);

  const auto faulty = ask("POST", "/missions/check",
                          R"({"files":[{"name":"a.ma"},3,{"name":"b","text":"","x":1}],"file":1})", as_json);
  EXPECT_EQ(faulty.status, 400);
  for (const char* pointer : {"/files/0/text", "/files/1", "/files/2/x", "/file"})
    EXPECT_THAT(faulty.body, testing::HasSubstr("\"" + std::string{pointer} + "\"")) << faulty.body;
  EXPECT_EQ(ask("POST", "/missions/check", "{", as_json).status, 400);
}

}  // namespace
}  // namespace floeplan::routes::mission_check_test
