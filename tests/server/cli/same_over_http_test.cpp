#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"

namespace floeplan::cli::same_over_http_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

const char* const bed =
    "ncols 3\nnrows 3\nxllcorner -54\nyllcorner 68\ncellsize 1\n900 800 700\n900 850 700\n900 900 900\n";

/// A zone across the parallel of 69 N, 0.05 degrees wide.
std::string zone(const std::string& name, double west_deg) {
  const std::string west = std::to_string(west_deg);
  const std::string east = std::to_string(west_deg + 0.05);
  return R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"kind":"no_go","name":")" +
         name + R"("},"geometry":{"type":"Polygon","coordinates":[[[)" + west + ",68.99],[" + east +
         ",68.99],[" + east + ",69.01],[" + west + ",69.01],[" + west + R"(,68.99]]]}}]})";
}

/// The document without the values that depend on the machine and the time.
json lasting(json document) {
  if (document.is_object()) {
    for (const char* name : {"seconds", "created", "ingested", "generated"}) document.erase(name);
  }
  if (document.is_structured())
    for (json& member : document) member = lasting(member);
  return document;
}

/// The same data in a store for the command line and in one that is served.
class SameOverHttp : public testing::Test {
 protected:
  SameOverHttp() {
    for (const support::Program* program : {&shell_, &server_}) {
      store(*program, "bed.asc", bed);
      store(*program, "range.geojson", zone("Range", -53.05));
    }
  }

  static void store(const support::Program& program, const std::string& name, const std::string& content) {
    std::ofstream{program.folder() / name} << content;
    const auto outcome = program.run(
        {"ingest", "--positive", "down", "--crs", "EPSG:4326", (program.folder() / name).string()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  [[nodiscard]] json printed(std::vector<std::string> words) const {
    words.emplace_back("--json");
    const auto outcome = shell_.run(words);
    EXPECT_EQ(outcome.err, "");
    return lasting(outcome.json());
  }
  [[nodiscard]] json executed(const std::string& process, const json& inputs,
                              const std::string& output) const {
    const auto answer = served_.execute(process, inputs);
    EXPECT_EQ(answer.status, 200) << answer.body;
    return lasting(answer.json().at(output));
  }
  [[nodiscard]] json got(const std::string& target) const {
    const auto answer = served_.get(target);
    EXPECT_EQ(answer.status, 200) << answer.body;
    return lasting(answer.json());
  }
  /// The output of the command line for a plan round the zone.
  [[nodiscard]] std::string planned(const std::string& goal) const {
    return printed({"plan", "--from=-53.2,69", "--to=" + goal, "--depart", "2026-11-22T06:00:00Z",
                    "--spacing", "1000", "--no-refine"})
        .at("plan_id");
  }

  const support::Program shell_;
  const support::Program server_;
  const support::ServedProgram served_{server_.folder() / "store"};
  const std::string depart_{"2026-11-22T06:00:00Z"};
  const json inputs_{{"from", {-53.2, 69}},
                     {"to", {-52.8, 69}},
                     {"depart", depart_},
                     {"spacing_m", 1000},
                     {"refine", false}};
};

TEST_F(SameOverHttp, PlansWindowsAndEvaluations) {
  const std::string id = planned("-52.8,69");
  const json plan = executed("plan-route", inputs_, "plan");
  EXPECT_EQ(plan, printed({"plan", "--from=-53.2,69", "--to=-52.8,69", "--depart", depart_, "--spacing",
                           "1000", "--no-refine"}));
  EXPECT_EQ(plan.at("plan_id"), id);

  json window = inputs_;
  window.update({{"depart_until", "2026-11-22T12:00:00Z"}, {"depart_step", "PT3H"}});
  EXPECT_EQ(executed("plan-route", window, "plan"),
            printed({"plan", "--from=-53.2,69", "--to=-52.8,69", "--depart", depart_, "--depart-until",
                     "2026-11-22T12:00:00Z", "--depart-step", "PT3H", "--spacing", "1000", "--no-refine"}));

  EXPECT_EQ(executed("evaluate-route", {{"plan_id", id}, {"depart", "2026-11-23T06:00:00Z"}}, "evaluation"),
            printed({"evaluate", id, "--depart", "2026-11-23T06:00:00Z"}));
}

TEST_F(SameOverHttp, ComparesExportsAndRechecks) {
  const std::string near = planned("-52.8,69");
  const std::string far = planned("-52.7,69");
  json to_far = inputs_;
  to_far["to"] = {-52.7, 69};
  static_cast<void>(executed("plan-route", inputs_, "plan"));
  static_cast<void>(executed("plan-route", to_far, "plan"));
  const std::string plan = "/collections/plans/items/" + near;

  const json comparison = got(plan + "/comparison?with=" + far);
  EXPECT_EQ(comparison, printed({"compare", near, far}));
  EXPECT_GT(comparison.at("difference").at("distance_m"), 3000.0);
  EXPECT_EQ(comparison.at("inputs").at(0).at("input"), "to");
  EXPECT_EQ(served_.get(plan + "/comparison?with=none").status, 400);
  EXPECT_EQ(shell_.run({"compare", near, "none"}).exit_code, 1);

  const fs::path out = shell_.folder() / "out";
  ASSERT_EQ(shell_.run({"export", near, "--format", "csv", "--out", out.string()}).exit_code, 0);
  std::ifstream file{fs::directory_iterator{out} -> path()};
  EXPECT_EQ(served_.get(plan + "/mission.csv").body, std::string(std::istreambuf_iterator<char>{file}, {}));
  EXPECT_EQ(got(plan + "/check"), printed({"recheck", near}));
}

TEST_F(SameOverHttp, ShowsDatasetsPlacesAndMissionFiles) {
  EXPECT_EQ(got("/datasets"), printed({"datasets"}));
  EXPECT_EQ(got("/probe?lon=-53.02&lat=69&time=" + depart_),
            printed({"probe", "--at=-53.02,69", "--time", depart_}));

  const std::string mission =
      "behavior_name=goto_list\n<start:b_arg>\n\tb_arg: num_waypoints(nodim) 1\n<end:b_arg>\n"
      "<start:waypoints>\n-5300.0000\t6900.0000\n<end:waypoints>\n";
  std::ofstream{shell_.folder() / "goto_l10.ma"} << mission;
  json checked = printed({"check", (shell_.folder() / "goto_l10.ma").string()}).at(0);
  checked["file"] = "goto_l10.ma";
  const json files{{"files", {{{"name", "goto_l10.ma"}, {"text", mission}}}}};
  EXPECT_EQ(lasting(served_.ask("POST", "/missions/check", "", files.dump()).json()), json::array({checked}));

  const json rules{{"older_than", "P1D"}, {"dry_run", true}};
  EXPECT_EQ(lasting(served_.ask("POST", "/datasets/prune", "", rules.dump()).json()),
            printed({"datasets", "prune", "--older-than", "P1D", "--dry-run"}));
}

TEST_F(SameOverHttp, TellsOfAPlanWhoseDataHaveChangedAndLeavesThePlanAsItWas) {
  const std::string id = executed("plan-route", inputs_, "plan").at("plan_id");
  const std::string plan = "/collections/plans/items/" + id;
  const std::string before = served_.get(plan).body;
  EXPECT_EQ(got(plan + "/check").at("stale"), false);

  store(server_, "new_range.geojson", zone("New range", -52.9));
  const json added = got(plan + "/check");
  EXPECT_EQ(added.at("stale"), true);
  EXPECT_EQ(added.at("changed_data").at(0).at("change"), "added");
  EXPECT_EQ(added.at("changed_data").at(0).at("kind"), "zones");
  EXPECT_FALSE(added.at("dangers").empty()) << "the way leads through the new zone: " << added;
  EXPECT_EQ(served_.get(plan + "/mission.gpx").status, 409);

  for (const json& dataset : json(got("/datasets").at("datasets")))
    if (dataset.at("kind") == "bathymetry") {
      EXPECT_EQ(served_.remove("/datasets/" + dataset.at("id").get<std::string>()).status, 204);
    }
  EXPECT_THAT(got(plan + "/check").at("changed_data").dump(), HasSubstr(R"("change":"removed")"));
  EXPECT_EQ(served_.get(plan).body, before);
  for (const char* method : {"PUT", "PATCH", "POST"})
    EXPECT_EQ(served_.ask(method, plan, "", "{}").status, 405);
}

}  // namespace
}  // namespace floeplan::cli::same_over_http_test
