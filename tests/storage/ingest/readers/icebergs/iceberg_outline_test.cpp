#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "storage/repository/features/iceberg_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::iceberg_outline_test {
namespace {

class IcebergOutline : public StoreFixture {
 protected:
  IngestReport read(const std::string& ring, const std::string& properties) {
    const std::string text = R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":)" +
                             properties + R"(,"geometry":{"type":"Polygon","coordinates":[)" + ring + "]}}]}";
    return ingest(write_file("outline.geojson", text), {.kind = repository::DatasetKind::icebergs});
  }

  ocean::Iceberg only(const IngestReport& report) {
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto list = repository::IcebergRepository{db_}.list({}, 0, 10);
    return list.empty() ? ocean::Iceberg{} : list.back().iceberg;
  }
};

TEST_F(IcebergOutline, IsACircleThatHoldsAllOfIt) {
  const ocean::Iceberg berg = only(read("[[-50,-60],[-49,-60],[-49,-59.5],[-50,-59.5],[-50,-60]]",
                                        R"({"name":"A99","observed":"2026-11-20T06:00:00Z"})"));

  EXPECT_EQ(berg.id, "A99");
  EXPECT_NEAR(berg.place.lon_deg, -49.5, 1e-9);
  EXPECT_NEAR(berg.place.lat_deg, -59.75, 1e-9);
  // Half a degree of longitude at 59.5 S is 28.3 km, a quarter of latitude 27.9 km; twice the way to a corner 79.3 km.
  EXPECT_NEAR(berg.length.value_or(core::Metres{0.0}).value, 79'300.0, 100.0);
}

TEST_F(IcebergOutline, StaysInOnePieceAcrossTheDateLine) {
  const ocean::Iceberg berg = only(read("[[179.9,-70],[-179.9,-70],[-179.9,-69.9],[179.9,-69.9],[179.9,-70]]",
                                        R"({"id":"C1","observed":"2026-11-20T06:00:00Z"})"));

  EXPECT_NEAR(std::abs(berg.place.lon_deg), 180.0, 1e-9);
  EXPECT_LT(berg.length.value_or(core::Metres{0.0}).value, 20'000.0);
}

TEST_F(IcebergOutline, OfAContinentIsNoIceberg) {
  const IngestReport report = read("[[-60,-80],[-20,-80],[-20,-65],[-60,-65],[-60,-80]]",
                                   R"({"name":"land","observed":"2026-11-20T06:00:00Z"})");
  EXPECT_EQ(report.status, IngestStatus::refused);
  EXPECT_THAT(words(report), testing::HasSubstr("larger than any iceberg"));
}

TEST_F(IcebergOutline, GivesWayToAStatedLength) {
  const ocean::Iceberg berg = only(read("[[-50,-60],[-49.9,-60],[-49.9,-59.9],[-50,-60]]",
                                        R"({"id":"A1","observed":"2026-11-20T06:00:00Z","length_m":5000})"));
  EXPECT_EQ(berg.length, core::Metres{5000.0});
}

}  // namespace
}  // namespace floeplan::ingest::iceberg_outline_test
