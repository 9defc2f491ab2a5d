#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"
#include "tests/support/places.hpp"

namespace floeplan::cli::openapi_test {
namespace {

/// Holds the start of the plans, and binds none of them: its time has not come.
const char* const zone = R"({"type": "FeatureCollection", "features": [{"type": "Feature",
  "properties": {"name": "Range", "kind": "no_go", "from": "2027-06-01T00:00:00Z", "until": "2027-07-01T00:00:00Z"},
  "geometry": {"type": "Polygon", "coordinates": [[[-53.1, 68.9], [-52.8, 68.9], [-52.8, 69.1], [-53.1, 69.1],
                                                   [-53.1, 68.9]]]}}]})";

/// A Slocum's log of one dive.
const char* const flight =
    "m_present_time,m_gps_lat,m_gps_lon,m_depth,x_dr_state,m_initial_water_vx,m_initial_water_vy\n"
    "1763704800,6900.0,-5300.0,0.5,4,0.1,0.1\n1763705400,,,90,1,,\n1763708400,6901.0,-5259.0,0.5,2,,\n"
    "1763708460,6901.0,-5259.0,0.5,3,0.2,-0.1\n";

/// A server with the demonstration data, a zone and the track of a glider.
class ServedDemo : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("python3 -c 'import jsonschema' 2> /dev/null") != 0)
      GTEST_SKIP() << "install the package python3-jsonschema to run this test";
    const std::filesystem::path demo = program_.folder() / "demo";
    ASSERT_EQ(program_.run({"demo", demo.string(), "--start", "2026-11-22"}).exit_code, 0);
    std::ofstream{demo / "zone.geojson"} << zone;
    std::ofstream{demo / "flight.csv"} << flight;
    std::vector<std::string> ingest{"ingest"};
    for (const auto& entry : std::filesystem::directory_iterator{demo})
      if (entry.path().extension() != ".txt") ingest.push_back(entry.path().string());
    ASSERT_EQ(program_.run(ingest).exit_code, 0);
    std::filesystem::create_directories(web() / "guide");
    for (const char* page : {"guide/index.html", "guide/data.html"})
      std::ofstream{web() / page} << "<h1>Guide</h1>";
  }

  /// A built client with no more than a guide.
  [[nodiscard]] std::filesystem::path web() const { return program_.folder() / "web"; }

  [[nodiscard]] int run(const std::string& script) const {
    const support::ServedProgram served{program_.folder() / "store", {"--web", web().string()}};
    return std::system(
        ("python3 " + support::source_folder() + "/tests/server/cli/" + script + ' ' + served.address())
            .c_str());
  }

  support::Program program_;
};

TEST_F(ServedDemo, AnswersEveryOperationAsItsOpenApiDocumentSays) {
  EXPECT_EQ(run("openapi_responses.py"), 0) << "what differs is printed above";
}

TEST_F(ServedDemo, MeetsTheConditionsOfTheSuitesOfOgcApi) {
  const auto planned = program_.run(
      {"plan", "--from=-53,69", "--to=-52.9,69.02", "--depart", "2026-11-22T06:00:00Z", "--no-refine"});
  ASSERT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_EQ(run("abstract_tests.py"), 0) << "what does not hold is printed above";
}

}  // namespace
}  // namespace floeplan::cli::openapi_test
