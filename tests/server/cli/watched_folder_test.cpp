#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"
#include "tests/server/jobs/wait_until.hpp"

namespace floeplan::cli::watched_folder_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Does not say whether values are depths or elevations, so it is refused.
const char* const bed =
    "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 50\ncellsize 0.5\n-900 -800 70\n-600 -5 4\n";

const char* const zone = R"({"type": "FeatureCollection", "features": [{"type": "Feature",
  "properties": {"name": "Range", "kind": "no_go"}, "geometry": {"type": "Polygon",
  "coordinates": [[[-53.1, 68.9], [-52.8, 68.9], [-52.8, 69.1], [-53.1, 68.9]]]}}]})";

class WatchedFolder : public testing::Test {
 protected:
  WatchedFolder() { fs::create_directories(inbox_); }

  void drop(const std::string& name, const std::string& content) const {
    std::ofstream{inbox_ / (name + ".part")} << content;
    fs::rename(inbox_ / (name + ".part"), inbox_ / name);
  }
  [[nodiscard]] support::ServedProgram serve() const {
    return support::ServedProgram{program_.folder() / "store", {"--watch", inbox_.string()}};
  }
  [[nodiscard]] bool appears(const std::string& name) const {
    return support::wait_until([&] { return fs::exists(inbox_ / name); });
  }
  [[nodiscard]] json report_of(const std::string& name) const {
    std::ifstream in{inbox_ / (name + ".report.json")};
    return json::parse(in, nullptr, false);
  }

  support::Program program_;
  const fs::path inbox_{program_.folder() / "inbox"};
};

TEST_F(WatchedFolder, PutsWhatItStoredAndWhatItRefusedAwayWithReports) {
  drop("zone.geojson", zone);
  drop("bed.asc", bed);
  drop("bed.prj", "of bed.asc");
  std::ofstream{inbox_ / "unfinished.nc.part"} << "half";
  const auto served = serve();

  ASSERT_TRUE(appears("done/zone.geojson"));
  ASSERT_TRUE(appears("refused/bed.asc"));
  ASSERT_TRUE(appears("refused/bed.prj"));

  EXPECT_EQ(report_of("done/zone.geojson").at("datasets").at(0).at("status"), "stored");
  EXPECT_EQ(report_of("refused/bed.asc").at("datasets").at(0).at("status"), "refused");
  EXPECT_TRUE(fs::exists(inbox_ / "unfinished.nc.part"));
  EXPECT_EQ(served.get("/datasets").json().at("datasets").size(), 1U);
}

TEST_F(WatchedFolder, TakesWhatCameWhileNobodyServedAndKeepsAnEarlierFileOfTheSameName) {
  {
    const auto served = serve();
    drop("zone.geojson", zone);
    ASSERT_TRUE(appears("done/zone.geojson"));
  }
  drop("zone.geojson", zone);
  const auto again = serve();

  ASSERT_TRUE(appears("done/zone-2.geojson"));
  EXPECT_EQ(report_of("done/zone-2.geojson").at("datasets").at(0).at("status"), "unchanged");
  EXPECT_EQ(again.get("/datasets").json().at("datasets").size(), 1U);
}

}  // namespace
}  // namespace floeplan::cli::watched_folder_test
