#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "engine/core/utc_text.hpp"
#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"

namespace floeplan::cli::departure_window_test {
namespace {

using nlohmann::json;
using support::Program;
using ::testing::HasSubstr;
using ::testing::Not;

const char* const from = "-53.20,69.20";
const char* const to = "-52.90,69.18";

/// The demonstration data: currents from 2026-11-22T00:00:00Z on, tides and all.
class DemoStore : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    program_ = new Program;
    const std::string demo = (program_->folder() / "demo").string();
    ASSERT_EQ(program_->run({"demo", demo, "--start", "2026-11-22"}).exit_code, 0);
    std::vector<std::string> words{"ingest"};
    for (const auto& entry : std::filesystem::directory_iterator{demo}) {
      if (entry.path().extension() != ".txt" && entry.path().extension() != ".md")
        words.push_back(entry.path());
    }
    ASSERT_EQ(program_->run(words).exit_code, 0);
    const json listed = program_->run({"datasets", "--json"}).json();
    for (const json& dataset : listed["datasets"]) {
      if (dataset["kind"] == "currents")
        start_ = core::parse_iso8601(dataset["time_start"].get<std::string>());
    }
    ASSERT_TRUE(start_.has_value());
  }
  static void TearDownTestSuite() {
    delete program_;
    program_ = nullptr;
  }

  /// The demonstration currents have one step per hour.
  static std::string time(int step) { return core::iso8601(*start_ + core::Seconds{3600.0 * step}); }
  static support::Outcome plan(std::vector<std::string> more) {
    more.insert(more.begin(), {"plan", "--from", from, "--to", to, "--json"});
    return program_->run(more);
  }

  static Program* program_;
  static std::optional<core::UtcTime> start_;
};

Program* DemoStore::program_ = nullptr;
std::optional<core::UtcTime> DemoStore::start_;

TEST_F(DemoStore, PlansTheBestDepartureOfAWindowAndShowsTheCurve) {
  const auto outcome = plan({"--depart", time(0), "--depart-until", time(6), "--depart-step", "PT2H"});

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = outcome.json();
  ASSERT_EQ(document["departures"].size(), 4U);
  double least_s = 1e12;
  std::string best;
  for (const json& entry : document["departures"]) {
    ASSERT_EQ(entry["status"], "ok") << entry;
    if (entry["travel_time_s"].get<double>() >= least_s) continue;
    least_s = entry["travel_time_s"];
    best = entry["departure"];
  }
  EXPECT_EQ(document["departure"], best);
  EXPECT_LE(document["travel_time_s"].get<double>(), least_s * 1.001);
}

TEST_F(DemoStore, LeavesAsLateAsTheArrivalAllows) {
  const auto outcome = plan({"--arrive-by", time(30)});

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = outcome.json();
  EXPECT_LE(document["arrival"].get<std::string>(), time(30));
  EXPECT_GT(document["arrival"].get<std::string>(), time(29));
}

TEST_F(DemoStore, RefusesAWindowThatIsReversedEndlessOrOutsideTheData) {
  const auto refused = [&](std::vector<std::string> flags) {
    const auto outcome = plan(std::move(flags));
    EXPECT_EQ(outcome.exit_code, 3);
    return outcome.err;
  };
  EXPECT_THAT(refused({"--depart", time(6), "--depart-until", time(0)}),
              HasSubstr("floeplan: --depart-until"));
  EXPECT_THAT(refused({"--depart", time(0), "--depart-until", time(6), "--depart-step", "PT0S"}),
              HasSubstr("floeplan: --depart-step"));
  EXPECT_THAT(refused({"--depart", time(0), "--depart-until", time(6), "--depart-step", "PT1S"}),
              HasSubstr("1000 departures"));
  EXPECT_THAT(
      refused({"--depart", time(0), "--depart-until", "2027-11-22T00:00:00Z", "--depart-step", "P1D"}),
      HasSubstr("floeplan: --depart-until"));
  EXPECT_THAT(refused({"--arrive-by", "2031-01-01T00:00:00Z"}), HasSubstr("floeplan: --arrive-by"));
}

TEST_F(DemoStore, SaysLineByLineWhyThereIsNoPlan) {
  const std::string goal_on_land = "-53.00,69.50";  // Disko island

  const support::Outcome refused =
      program_->run({"plan", "--from", from, "--to", goal_on_land, "--depart", time(6)});

  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, testing::MatchesRegex("floeplan: no plan: the goal lies on land[^\n]*\n"
                                                 "  where: 69°30.000′N 053°00.000′W\n"
                                                 "  what to do: [^\n]*\n"
                                                 "(  would help: move the goal [^\n]*\n)?"
                                                 "[^/_]*"))
      << "neither a pointer nor a name of the code";
}

TEST_F(DemoStore, DrawsWhatCanBeReachedAndFromWhere) {
  const auto there =
      program_->run({"reach", "--from", from, "--depart", time(0), "--hours", "3,6", "--json"});
  const auto back = program_->run({"reach", "--to", from, "--arrive-by", time(12), "--hours", "6", "--json"});

  ASSERT_EQ(there.exit_code, 0) << there.err;
  ASSERT_EQ(back.exit_code, 0) << back.err;
  const json areas = there.json()["features"];
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_LT(areas[0]["properties"]["area_km2"], areas[1]["properties"]["area_km2"]);
  EXPECT_EQ(back.json()["features"][0]["properties"]["time"], time(6));
}

/// Law: the process of a command accepts every flag in the help of the command.
TEST_F(DemoStore, OffersNoFlagForReachThatReachRefuses) {
  const std::string help = program_->run({"reach", "--help-all"}).out;
  for (const char* flag : {"--objective", "--thruster", "--require-battery", "--max-loiter",
                           "--surfacing-interval", "--escape-plan"}) {
    EXPECT_THAT(help, Not(HasSubstr(flag)));
    const auto refused =
        program_->run({"reach", "--from", from, "--depart", time(0), "--hours", "3", flag, "1"});
    EXPECT_EQ(refused.exit_code, 2) << flag;
  }
}

TEST_F(DemoStore, TimesARouteForAVehicleOfItsOwn) {
  const auto planned = plan({"--depart", time(0), "--no-refine"});
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  const std::string id = planned.json()["plan_id"];
  const std::string request = (program_->folder() / "request.json").string();
  std::ofstream{request} << R"({"vehicle": {"name": "mine", "speed_m_s": 0.5}})";

  const auto usual = program_->run({"evaluate", id, "--depart", time(0), "--json"});
  const auto own = program_->run({"evaluate", id, "--depart", time(0), "--request", request, "--json"});

  ASSERT_EQ(own.exit_code, 0) << own.err << own.out;
  EXPECT_LT(own.json()["travel_time_s"], usual.json()["travel_time_s"]);
}

TEST_F(DemoStore, AnswersTheSameOverHttp) {
  const support::ServedProgram server{program_->folder() / "store"};
  const json window{{"from", {-53.20, 69.20}},
                    {"to", {-52.90, 69.18}},
                    {"depart", time(0)},
                    {"depart_until", time(2)},
                    {"depart_step", "PT1H"}};
  const json area{{"from", {-53.20, 69.20}}, {"depart", time(0)}, {"hours", {3, 6}}};

  const auto plan_answer = server.execute("plan-route", window);
  const auto reach_answer = server.execute("reach", area);

  ASSERT_EQ(plan_answer.status, 200) << plan_answer.body;
  EXPECT_EQ(plan_answer.json()["plan"]["departures"].size(), 3U);
  ASSERT_EQ(reach_answer.status, 200) << reach_answer.body;
  EXPECT_EQ(reach_answer.json()["reach"]["features"].size(), 2U);
  EXPECT_EQ(server.execute("reach", {{"from", {-53.2, 69.2}}}).status, 400);
}

}  // namespace
}  // namespace floeplan::cli::departure_window_test
