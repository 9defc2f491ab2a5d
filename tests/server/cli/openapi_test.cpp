#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"

namespace floeplan::cli {
namespace {

/// Holds the start of the plans, and binds none of them: its time has not come.
const char* const zone = R"({"type": "FeatureCollection", "features": [{"type": "Feature",
  "properties": {"name": "Range", "kind": "no_go", "from": "2027-06-01T00:00:00Z", "until": "2027-07-01T00:00:00Z"},
  "geometry": {"type": "Polygon", "coordinates": [[[-53.1, 68.9], [-52.8, 68.9], [-52.8, 69.1], [-53.1, 69.1],
                                                   [-53.1, 68.9]]]}}]})";

TEST(OpenApi, DescribesWhatEveryOperationAnswers) {
  if (std::system("python3 -c 'import jsonschema' 2> /dev/null") != 0)
    GTEST_SKIP() << "install the package python3-jsonschema to run this test";
  const support::Program program;
  const std::filesystem::path demo = program.folder() / "demo";
  ASSERT_EQ(program.run({"demo", demo.string()}).exit_code, 0);
  std::ofstream{demo / "zone.geojson"} << zone;
  std::vector<std::string> ingest{"ingest"};
  for (const auto& entry : std::filesystem::directory_iterator{demo})
    if (entry.path().extension() != ".txt") ingest.push_back(entry.path().string());
  ASSERT_EQ(program.run(ingest).exit_code, 0);
  const support::ServedProgram served{program.folder() / "store"};

  const std::string command =
      "python3 " FLOEPLAN_SOURCE_DIR "/tests/server/cli/openapi_responses.py " + served.address();

  EXPECT_EQ(std::system(command.c_str()), 0) << "what differs is printed above";
}

}  // namespace
}  // namespace floeplan::cli
