#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"

namespace floeplan::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using support::Outcome;
using support::Program;
using ::testing::HasSubstr;

/// A plan in a sea of which nothing is known.
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
  EXPECT_EQ(check.size(), 10U) << "nine files, none left half written";
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
  for (const char* format : {"gpx", "kml", "geojson", "csv", "nmea", "targets", "html", "pdf"}) {
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

/// Land that comes up on the way after the plan was made.
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
  EXPECT_THAT(written.err, HasSubstr("In the newest data"));
  EXPECT_EQ(program.run(accepted).exit_code, 1) << "nor the reverse";
}

TEST(HandOverExample, CopiesTheFilesOnceAndReplacesThemOnlyWhenTold) {
  const Program program;
  const std::string id = planned(program);
  const support::ServedProgram served{program.folder() / "store"};
  const fs::path glider = program.folder() / "gliders" / "amadeus";
  const std::string command =
      "python3 " FLOEPLAN_SOURCE_DIR "/api/examples/hand_over.py " + served.address() + " ";
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
}  // namespace floeplan::cli
