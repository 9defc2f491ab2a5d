#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "storage/ingest/data_formats.hpp"
#include "tests/server/cli/program.hpp"

namespace floeplan::cli::formats_command_test {
namespace {

using nlohmann::json;
using support::Outcome;
using support::Program;
using ::testing::HasSubstr;

TEST(Formats, AreTheRowsOfTheTableThatIngestReadsBy) {
  const Program program;

  const Outcome listed = program.run({"formats", "--json"});

  ASSERT_EQ(listed.exit_code, 0);
  const auto& formats = ingest::data_formats();
  ASSERT_EQ(listed.json().size(), formats.size());
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const json row = listed.json()[i];
    EXPECT_EQ(row["name"], std::string{formats[i].name});
    EXPECT_EQ(row["reads"], std::string{formats[i].reads});
    EXPECT_EQ(row["tested_with"], std::string{formats[i].tested_with});
    EXPECT_EQ(row["kinds"].size(), formats[i].kinds.size());
  }
}

TEST(Formats, AreThreeLinesEachForAPerson) {
  const Program program;

  const Outcome listed = program.run({"formats"});

  EXPECT_EQ(listed.exit_code, 0);
  EXPECT_EQ(listed.err, "");
  EXPECT_THAT(listed.out, HasSubstr("GRIB2                     currents, wind\n"
                                    "                          currents, and wind 10 m above the sea\n"
                                    "                          tested with: currents of CMEMS"));
  EXPECT_THAT(listed.out, HasSubstr("International Ice Patrol  icebergs\n"));
}

}  // namespace
}  // namespace floeplan::cli::formats_command_test
