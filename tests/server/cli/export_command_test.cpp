#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"
#include "tests/support/places.hpp"

namespace floeplan::cli::export_command_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::Outcome;
using support::Program;
using ::testing::HasSubstr;

/// A plan in a sea without data.
std::string planned(const Program& program, const std::string& from = "--from=-53,69") {
  const Outcome plan =
      program.run({"plan", from, "--to=-52.75,69.05", "--depart", "2026-11-22T06:00:00Z", "--json"});
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  return plan.json()["plan_id"];
}

std::string text_of(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

TEST(Export, HandsAFullSetToAGliderAndNeverOverwritesIt) {
  const Program program;
  const std::string id = planned(program);
  const fs::path out = program.folder() / "dock";
  const std::vector<std::string> words{"export", id, "--full", "--glider", "amadeus", "--out", out.string()};

  const Outcome first = program.run(words);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const fs::path folder = out / "gliders" / "amadeus" / "to-glider";
  std::vector<std::string> check{"check"};
  for (const auto& file : fs::directory_iterator{folder}) check.push_back(file.path().string());
  EXPECT_EQ(check.size(), 11U) << "ten files, none left half written";
  EXPECT_EQ(program.run(check).exit_code, 0);

  std::ofstream{folder / "yo10.ma"} << "mine";
  EXPECT_EQ(program.run(words).exit_code, 1);
  EXPECT_EQ(text_of(folder / "yo10.ma"), "mine");
  std::vector<std::string> forced = words;
  forced.emplace_back("--force");
  EXPECT_EQ(program.run(forced).exit_code, 0);
  EXPECT_THAT(text_of(folder / "yo10.ma"), HasSubstr("behavior_name=yo"));
}

TEST(Export, ChecksWhatItIsTold) {
  const Program program;
  const std::string id = planned(program);

  EXPECT_EQ(program.run({"export", id, "--glider", "../up"}).exit_code, 2);
  EXPECT_EQ(program.run({"export", id, "--firmware", "new"}).exit_code, 2);
  EXPECT_EQ(program.run({"export", id, "--iceberg-depth", "30"}).exit_code, 2);
  EXPECT_EQ(program.run({"export", id, "--full", "--mission", "recov"}).exit_code, 3);
  EXPECT_EQ(program.run({"export", id, "--format", "doc"}).exit_code, 2);
}

TEST(Export, WritesEveryFormat) {
  const Program program;
  const std::string id = planned(program);
  const std::string out = (program.folder() / "out").string();
  for (const char* format : {"gpx", "kml", "geojson", "csv", "nmea", "targets", "imc", "html", "pdf"}) {
    const Outcome outcome = program.run({"export", id, "--format", format, "--out", out, "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << format << outcome.err;
    EXPECT_GT(fs::file_size(outcome.json()["files"][0].get<std::string>()), 50U) << format;
  }
  EXPECT_EQ(text_of(fs::path{out} / (id + ".pdf")).substr(0, 4), "%PDF");
  EXPECT_EQ(program.run({"export", id, "--zip", "--out", out}).exit_code, 0);
  EXPECT_EQ(text_of(fs::path{out} / (id + ".zip")).substr(0, 2), "PK");
}

TEST(Export, IsReadBackEvaluatedAndPlannedAnew) {
  const Program program;
  const std::string id = planned(program);
  const fs::path out = program.folder() / "out";
  ASSERT_EQ(program.run({"export", id, "--out", out.string()}).exit_code, 0);
  const std::vector<std::string> rest{"--from=-53,69", "--depart", "2026-11-22T06:00:00Z", "--json"};
  const auto with_rest = [&](std::vector<std::string> words) {
    words.insert(words.end(), rest.begin(), rest.end());
    return program.run(words);
  };

  const Outcome evaluated = with_rest({"evaluate", (out / "goto_l10.ma").string()});
  const Outcome told = program.run(
      {"evaluate", (out / "goto_l10.ma").string(), "--from=-53,69", "--depart", "2026-11-22T06:00:00Z"});
  const Outcome again = with_rest({"plan", "--goals", (out / "goto_l10.ma").string()});

  ASSERT_EQ(evaluated.exit_code, 0) << evaluated.err;
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(told.out, HasSubstr("route  2026-11-22T06:00:00Z to ")) << told.err;
  EXPECT_NEAR(evaluated.json()["distance_m"].get<double>(), again.json()["distance_m"].get<double>(), 1.0);
  EXPECT_NEAR(again.json()["waypoints"].back()["lon"].get<double>(), -52.75, 1e-6);
}

/// Icebergs whose sightings are too old may still be on the route.
TEST(Export, AsksToConfirmAPlanThatIgnoresIcebergsForTheirAge) {
  const Program program;
  const fs::path bergs = program.folder() / "bergs.csv";
  std::ofstream{bergs} << "id,lon,lat,observed,length_m\nold,-52.9,69.05,2026-11-10T00:00:00Z,80\n";
  ASSERT_EQ(program.run({"ingest", bergs.string(), "--kind", "icebergs"}).exit_code, 0);
  const std::vector<std::string> asked{"plan", "--from=-53,69", "--to=-52.75,69", "--depart",
                                       "2026-11-22T06:00:00Z"};
  std::vector<std::string> as_json = asked;
  as_json.emplace_back("--json");

  const Outcome told = program.run(asked);
  const nlohmann::json plan = program.run(as_json).json();

  ASSERT_EQ(told.exit_code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("danger: 1 of 1 iceberg was ignored, not seen since"));
  EXPECT_THAT(told.out, HasSubstr("ignored, not seen since 2026-11-19T00:00:00Z"));
  ASSERT_EQ(plan["dangers"].size(), 1U);
  EXPECT_EQ(plan["warnings"][0], plan["dangers"][0]);
  EXPECT_EQ(plan["sightings"]["oldest"], "2026-11-19T00:00:00Z");
  const std::string id = plan["plan_id"];
  const fs::path out = program.folder() / "out";
  const Outcome refused = program.run({"export", id, "--out", out.string()});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("not seen since"));
  EXPECT_THAT(refused.err, HasSubstr("--accept-dangers"));
  const Outcome written = program.run({"export", id, "--out", out.string(), "--accept-dangers"});
  EXPECT_EQ(written.exit_code, 0);
  EXPECT_THAT(written.err, HasSubstr("danger: 1 of 1 iceberg"));
}

/// Land on the route that was ingested after the plan was made.
TEST(Export, RefusesAPlanThatNewerDataClose) {
  const Program program;
  const std::string id = planned(program);
  const fs::path island = program.folder() / "coast.geojson";
  std::ofstream{island} << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
    "geometry":{"type":"Polygon","coordinates":[[[-52.9,68.9],[-52.85,68.9],[-52.85,69.2],[-52.9,69.2],[-52.9,68.9]]]}}]})";
  ASSERT_EQ(program.run({"ingest", island.string(), "--kind", "coastline"}).exit_code, 0);
  const fs::path out = program.folder() / "out";

  const Outcome refused = program.run({"export", id, "--out", out.string(), "--json"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.json()["status"], "dangerous");
  EXPECT_FALSE(fs::exists(out / "goto_l10.ma"));

  EXPECT_EQ(program.run({"export", id, "--out", out.string(), "--force"}).exit_code, 1)
      << "leave to overwrite is no leave to endanger";
  const std::vector<std::string> accepted{"export", id, "--out", out.string(), "--accept-dangers"};
  const Outcome written = program.run(accepted);
  EXPECT_EQ(written.exit_code, 0);
  EXPECT_THAT(written.err, HasSubstr("in the newest data, leg 1 is closed"));
  EXPECT_EQ(program.run(accepted).exit_code, 1) << "nor the reverse";
}

/// Every export of a plan asks for this confirmation, except the printed page, which shows the danger itself.
TEST(Export, RefusesSuchAPlanInEveryFormatOfAVehicleOrChart) {
  const Program program;
  const std::string id = planned(program);
  const fs::path island = program.folder() / "coast.geojson";
  std::ofstream{island} << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
    "geometry":{"type":"Polygon","coordinates":[[[-52.9,68.9],[-52.85,68.9],[-52.85,69.2],[-52.9,69.2],[-52.9,68.9]]]}}]})";
  ASSERT_EQ(program.run({"ingest", island.string(), "--kind", "coastline"}).exit_code, 0);
  const fs::path out = program.folder() / "out";
  const support::ServedProgram served{program.folder() / "store"};

  for (const std::string format :
       {"gliderdos", "seaglider", "gpx", "kml", "geojson", "csv", "nmea", "targets", "imc"}) {
    EXPECT_EQ(program.run({"export", id, "--format", format, "--out", out.string(), "--force"}).exit_code, 1)
        << format;
    EXPECT_FALSE(fs::exists(out)) << format;
    const bool set = format == "gliderdos" || format == "seaglider";
    const std::string path =
        "/collections/plans/items/" + id + "/mission" + (set ? "?format=" : ".") + format;
    EXPECT_EQ(served.get(path).status, 409) << format;
    EXPECT_EQ(served.get(path + (set ? "&" : "?") + "accept_dangers=true").status, 200) << format;
  }
  for (const std::string format : {"html", "pdf"}) {
    const Outcome brief = program.run({"export", id, "--format", format, "--out", out.string()});
    EXPECT_EQ(brief.exit_code, 0) << brief.err;
    EXPECT_THAT(brief.err, HasSubstr("danger: in the newest data, leg 1 is closed"));
    const auto served_brief = served.get("/collections/plans/items/" + id + "/mission." + format);
    EXPECT_EQ(served_brief.status, 200);
    if (format == "html") EXPECT_THAT(served_brief.body, HasSubstr("In the newest data, leg 1 is closed"));
  }
}

TEST(Export, WritesASeaglidersFilesForItsBaseStation) {
  const Program program;
  const std::string id = planned(program);
  const fs::path out = program.folder() / "out";
  const std::vector<std::string> words{
      "export",   id,      "--format",  "seaglider",    "--out",     out.string(),
      "--glider", "sg123", "--science", "20:5:1110:60", "--science", "200:10:1100:120"};

  ASSERT_EQ(program.run(words).exit_code, 0);
  const std::string folder = (out / "sg123").string();
  const Outcome checked =
      program.run({"check", folder + "/targets", folder + "/science", folder + "/cmdfile", "--json"});
  ASSERT_EQ(checked.exit_code, 0) << checked.out;
  const json judged = checked.json();
  for (const json& file : judged) EXPECT_EQ(file["verdict"], "ok") << file;
  EXPECT_EQ(checked.json()[0]["kind"], "targets");
  EXPECT_EQ(checked.json()[1]["bands"].size(), 2U);
  EXPECT_EQ(
      program.run({"evaluate", folder + "/targets", "--from=-53,69", "--depart", "2026-11-22T06:00:00Z"})
          .exit_code,
      0);
  EXPECT_EQ(program.run({"export", id, "--format", "seaglider", "--science", "20:5"}).exit_code, 2);
  EXPECT_EQ(program.run({"export", id, "--science", "20:5:1110:60"}).exit_code, 2);
}

/// Read by an independent program.
TEST(Export, WritesAnImcPlanThatOthersRead) {
  const Program program;
  const Outcome plan = program.run(
      {"plan", "--from=-53,69", "--to=-52.75,69.05", "--depart", "2026-11-22T06:00:00Z", "--json"});
  const std::string id = plan.json()["plan_id"];
  const fs::path out = program.folder() / "out";
  ASSERT_EQ(program.run({"export", id, "--format", "imc", "--out", out.string()}).exit_code, 0);
  const fs::path expected = program.folder() / "plan.json";
  std::ofstream{expected} << plan.out;
  const fs::path reader = program.folder() / "read.py";
  std::ofstream{reader} << R"(import json, math, sys
imc, plan = (json.load(open(name)) for name in sys.argv[1:])
assert imc["abbrev"] == "PlanSpecification" and imc["plan_id"] == plan["plan_id"]
gotos = {m["maneuver_id"]: m["data"] for m in imc["maneuvers"]}
follows = {t["source_man"]: t["dest_man"] for t in imc["transitions"]}
assert all(t["conditions"] == "ManeuverIsDone" for t in imc["transitions"])
at, places = imc["start_man_id"], []
while at:
    goto = gotos.pop(at)
    assert goto["abbrev"] == "Goto" and goto["z_units"] == 1 and goto["speed_units"] == 0, goto
    assert 0 <= goto["z"] <= 200 and abs(goto["speed"] - 0.35) < 1e-9 and 0 < goto["timeout"] <= 65535, goto
    places.append((math.degrees(goto["lon"]), math.degrees(goto["lat"])))
    at = follows.get(at)
assert not gotos, "every maneuver is on the way"
for waypoint in plan["waypoints"][1:]:
    assert min(math.hypot(waypoint["lon"] - lon, waypoint["lat"] - lat) for lon, lat in places) < 1e-9
assert math.hypot(places[-1][0] + 52.75, places[-1][1] - 69.05) < 1e-9
)";

  const std::string file = (out / (id + ".imc.json")).string();
  EXPECT_EQ(std::system(("python3 " + reader.string() + " " + file + " " + expected.string()).c_str()), 0);
  const Outcome again =
      program.run({"plan", "--goals", file, "--from=-53,69", "--depart", "2026-11-22T06:00:00Z", "--json"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NEAR(again.json()["waypoints"].back()["lat"].get<double>(), 69.05, 1e-9);
  EXPECT_EQ(program.run({"evaluate", file, "--from=-53,69", "--depart", "2026-11-22T06:00:00Z"}).exit_code,
            0);
}

/// The goals of a list on board, brought into another sea by moving all of them alike.
TEST(RoundTrip, KeepsTheGoalsOfRealLists) {
  for (const char* sample : {"../gliderdos/gpp__GOTO_L16.MA", "../gliderdos/sfmcapi__goto_l90.ma",
                             "../gliderdos/idx-69339466367__goto_l10.ma"}) {
    const fs::path original = support::shared_sample(sample);
    if (!fs::exists(original)) GTEST_SKIP() << "the shared sample files are not here";
    const Program program;
    const std::vector<std::string> when{"--depart", "2026-11-22T06:00:00Z", "--json"};
    const auto told = [&](std::vector<std::string> words) {
      words.insert(words.end(), when.begin(), when.end());
      return program.run(words);
    };
    const json goals = program.run({"check", original.string(), "--json"}).json()[0]["waypoints"];
    ASSERT_GE(goals.size(), 2U);

    const Outcome evaluated = told({"evaluate", original.string()});
    const Outcome planned = told({"plan", "--goals", original.string(), "--spacing", "20000"});
    ASSERT_EQ(evaluated.exit_code, 0) << sample << evaluated.err;
    ASSERT_EQ(planned.exit_code, 0) << sample << planned.err;
    const double before_s = evaluated.json()["travel_time_s"];
    EXPECT_LE(planned.json()["travel_time_s"].get<double>(), 1.001 * before_s) << sample;

    const fs::path out = program.folder() / "out";
    const std::string id = planned.json()["plan_id"];
    const Outcome exported = program.run({"export", id, "--out", out.string(), "--json"});
    ASSERT_EQ(exported.exit_code, 0) << sample << exported.err;
    std::vector<std::string> check{"check", "--json"};
    const json files = exported.json()["files"];
    for (const json& file : files) check.push_back(file);
    const json lists = program.run(check).json();
    std::vector<json> flown;
    for (const json& file : lists)
      for (const json& place : file["waypoints"]) flown.push_back(place);
    auto next = flown.begin();
    for (std::size_t i = 1; i < goals.size(); ++i) {  // the first is the place of the vehicle
      const auto is_goal = [&](const json& place) {
        return std::abs(place["lon"].get<double>() - goals[i]["lon"].get<double>()) < 2e-6 &&
               std::abs(place["lat"].get<double>() - goals[i]["lat"].get<double>()) < 2e-6;
      };
      next = std::find_if(next, flown.end(), is_goal);
      ASSERT_NE(next, flown.end()) << sample << ": goal " << i << " is not on the way, or out of order";
    }
  }
}

TEST(HandOverExample, CopiesTheFilesOnceAndReplacesThemOnlyWhenTold) {
  const Program program;
  const std::string id = planned(program);
  const support::ServedProgram served{program.folder() / "store"};
  const fs::path glider = program.folder() / "gliders" / "amadeus";
  const std::string command =
      "python3 " + support::source_folder() + "/api/examples/hand_over.py " + served.address() + " ";
  const std::string quiet = " >/dev/null 2>&1";
  const auto run = [&](const std::string& plan, const std::string& more) {
    return std::system((command + plan + " " + glider.string() + more + quiet).c_str());
  };

  EXPECT_EQ(run(id, " --query full=true"), 0);
  EXPECT_THAT(text_of(glider / "to-glider" / "plan.mi"), HasSubstr("behavior: abend"));
  EXPECT_NE(run(id, " --query full=true"), 0);
  EXPECT_EQ(run(id, " --query full=true --replace"), 0);
  EXPECT_NE(run("p000000000000", ""), 0);
}

}  // namespace
}  // namespace floeplan::cli::export_command_test
