#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "engine/core/utc_text.hpp"
#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"

namespace floeplan::cli::ogr2ogr_test {
namespace {

using nlohmann::json;

constexpr int bergs = 130;
constexpr int columns = 13;
const core::UtcTime first_seen = core::parse_iso8601("2026-11-01T00:00:00Z").value();

/// A lattice of bergs half a degree apart from 60 W, 60 N on, seen an hour after the other; every tenth has one name.
json bergs_on_a_lattice() {
  json features = json::array();
  for (int i = 0; i < bergs; ++i) {
    const double lon = -60.0 + 0.5 * (i % columns);
    const double lat = 60.0 + 0.5 * (i / columns);
    features.push_back({{"type", "Feature"},
                        {"properties",
                         {{"id", i % 10 == 3 ? "B-3" : "A-" + std::to_string(i)},
                          {"observed", core::iso8601(first_seen + i * core::Seconds{3600.0})},
                          {"length_m", i == bergs - 1 ? 80.5 : 80.0}}},
                        {"geometry", {{"type", "Point"}, {"coordinates", {lon, lat}}}}});
  }
  return {{"type", "FeatureCollection"}, {"features", features}};
}

/// GDAL's driver for OGC API - Features, run as its users run it.
class Ogr2ogr : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("ogr2ogr --version > /dev/null 2>&1") != 0)
      GTEST_SKIP() << "install the package gdal-bin to run this test";
    const std::filesystem::path file = program_.folder() / "bergs.geojson";
    std::ofstream{file} << bergs_on_a_lattice();
    ASSERT_EQ(program_.run({"ingest", file.string()}).exit_code, 0);
  }

  /// The collection as ogr2ogr reads it, in GeoJSON.
  [[nodiscard]] json read(const std::string& collection, const std::string& flags) const {
    const support::ServedProgram served{program_.folder() / "store"};
    const std::filesystem::path out = program_.folder() / "out.geojson";
    const std::string command = "ogr2ogr -f GeoJSON " + out.string() + " OAPIF:" + served.address() + ' ' +
                                collection + ' ' + flags + " 2> " + (program_.folder() / "ogr.txt").string();
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::ifstream said{program_.folder() / "ogr.txt"};
    EXPECT_EQ(said.peek(), std::ifstream::traits_type::eof()) << said.rdbuf();
    std::ifstream in{out};
    return json::parse(in, nullptr, false).at("features");
  }

  support::Program program_;
};

std::set<std::string> times_of(const json& features) {
  std::set<std::string> times;
  for (const json& feature : features)
    times.insert(feature.at("properties").at("observed").get<std::string>());
  return times;
}

TEST_F(Ogr2ogr, ReadsEveryFeatureOverManyPages) {
  const json all = read("icebergs", "-oo PAGE_SIZE=40");

  EXPECT_EQ(all.size(), static_cast<std::size_t>(bergs));
  EXPECT_EQ(times_of(all).size(), static_cast<std::size_t>(bergs)) << "each once";
  EXPECT_EQ(all.back().at("properties").at("length_m"), 80.5) << "by its schema, not by the first page";
}

TEST_F(Ogr2ogr, ReadsABox) {
  const json inside = read("icebergs", "-oo PAGE_SIZE=7 -spat -58.6 61.4 -56.9 63.1");

  EXPECT_EQ(inside.size(), 4U * 4U);
  for (const json& feature : inside) {
    const json& place = feature.at("geometry").at("coordinates");
    EXPECT_THAT(place.at(0).get<double>(), testing::AllOf(testing::Ge(-58.6), testing::Le(-56.9)));
    EXPECT_THAT(place.at(1).get<double>(), testing::AllOf(testing::Ge(61.4), testing::Le(63.1)));
  }
}

TEST_F(Ogr2ogr, FiltersByAttributeAndByTime) {
  const json named = read("icebergs", "-where \"berg_id = 'B-3'\"");
  EXPECT_EQ(named.size(), static_cast<std::size_t>(bergs) / 10);
  for (const json& feature : named) EXPECT_EQ(feature.at("properties").at("berg_id"), "B-3");

  const json of_a_day = read(
      "icebergs", "-where \"observed >= '2026-11-02T00:00:00Z' AND observed <= '2026-11-02T23:00:00Z'\"");
  EXPECT_EQ(of_a_day.size(), 24U);
}

}  // namespace
}  // namespace floeplan::cli::ogr2ogr_test
