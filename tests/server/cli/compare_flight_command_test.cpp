#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/server/cli/program.hpp"

namespace floeplan::cli::compare_flight_command_test {
namespace {

using support::Outcome;
using support::Program;
using ::testing::HasSubstr;

TEST(CompareFlight, SetsARealDiveBesideItsSimulation) {
  const Program program;
  const auto log = support::shared_sample("glider/slocum_comet-2019-222-02-154_nav.csv");
  if (!std::filesystem::exists(log)) GTEST_SKIP() << "the shared logs are not there";

  const Outcome outcome = program.run({"compare-flight", log.string(), "--json"});
  const Outcome table = program.run({"compare-flight", log.string()});

  EXPECT_EQ(outcome.exit_code, 0);
  const auto dive = outcome.json()["dives"][0];
  EXPECT_EQ(dive["dived"], "2019-08-21T13:56:42Z");
  EXPECT_EQ(dive["dives"]["logged"], 17.0);
  EXPECT_TRUE(outcome.json()["median"]["within_a_tenth"]);
  EXPECT_EQ(dive["currents_turned_from"]["utm_zone"], 32);
  EXPECT_EQ(dive["currents_turned_from"]["declination_from"], "m_gps_mag_var");
  EXPECT_NEAR(dive["currents_turned_from"]["declination_deg"].get<double>(), 1.3, 1e-4);
  EXPECT_THAT(table.out, HasSubstr("positions apart"));
  EXPECT_THAT(table.out, HasSubstr("currents turned from UTM zone 32, magnetic variation 1.3 degrees east"));
  EXPECT_THAT(table.out, HasSubstr("within a tenth"));
}

TEST(CompareFlight, NamesWhatIsWrongWithALog) {
  const Program program;
  const auto file = program.folder() / "log.csv";
  std::ofstream{file} << "m_present_time,m_depth\ntimestamp,m\n1,deep\n";

  const Outcome outcome =
      program.run({"compare-flight", file.string(), (program.folder() / "none").string()});

  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("log.csv/line 3/m_depth: must be a number"));
  EXPECT_THAT(outcome.err, HasSubstr("none: cannot be read"));
  EXPECT_EQ(program.run({"compare-flight", file.string(), "--vehicle", "boat"}).exit_code, 3);
  EXPECT_EQ(program.run({"compare-flight"}).exit_code, 2);
}

}  // namespace
}  // namespace floeplan::cli::compare_flight_command_test
