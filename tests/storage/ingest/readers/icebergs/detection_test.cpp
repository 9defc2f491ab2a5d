#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/utc_text.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::detection_test {
namespace {

using testing::HasSubstr;

class IcebergDetections : public StoreFixture {
 protected:
  std::vector<ocean::Iceberg> stored(const std::filesystem::path& file) {
    report_ = ingest(file);
    EXPECT_EQ(report_.status, IngestStatus::stored) << words(report_);
    std::vector<ocean::Iceberg> all;
    for (const auto& sighting : repository::IcebergRepository{db_}.list({}, 0, 100))
      all.push_back(sighting.iceberg);
    return all;
  }

  IngestReport report_;
};

const std::string header = "lat,lon,acquired,length_m,confidence\n";

TEST_F(IcebergDetections, AllCountWithTheirLengthAndConfidence) {
  const auto bergs = stored(write_file("s1.csv", header + "69.1,-52.5,2026-11-20T06:00:00Z,120,0.87\n"
                                                          "69.2,-52.6,2026-11-20T06:00:00Z,60,0.05\n"));
  ASSERT_EQ(bergs.size(), 2U);
  const auto& first = bergs[0].place.lat_deg < 69.15 ? bergs[0] : bergs[1];
  EXPECT_EQ(first.length->value, 120.0);
  EXPECT_EQ(first.method, "confidence 0.87");
  EXPECT_EQ(core::iso8601(first.observed), "2026-11-20T06:00:00Z");
  EXPECT_EQ(first.id, "detection 69.10000 -52.50000 2026-11-20T06:00:00Z");
  EXPECT_THAT(words(report_), HasSubstr("however unsure"));
}

TEST_F(IcebergDetections, OfALaterImageDoNotStandInForThoseOfAnEarlierOne) {
  ASSERT_EQ(stored(write_file("a.csv", header + "69.1,-52.5,2026-11-20T06:00:00Z,120,0.87\n")).size(), 1U);
  EXPECT_EQ(stored(write_file("b.csv", header + "69.4,-52.9,2026-11-21T06:00:00Z,100,0.80\n")).size(), 2U);
}

TEST_F(IcebergDetections, KeepTheNameAndTheMethodThatTheyHave) {
  const auto bergs = stored(write_file("s1.csv",
                                       "berg_id,lat,lon,time,method,length_m,confidence\n"
                                       "S1A-17,69.1,-52.5,2026-11-20T06:00:00Z,SAR,120,high\n"));
  ASSERT_EQ(bergs.size(), 1U);
  EXPECT_EQ(bergs[0].id, "S1A-17");
  EXPECT_EQ(bergs[0].method, "SAR, confidence high");
}

TEST_F(IcebergDetections, MayBePointsOfGeoJson) {
  const auto bergs = stored(write_file("s1.geojson", R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"acquired": "2026-11-20T06:00:00Z", "length_m": 90, "confidence": 0.5},
     "geometry": {"type": "Point", "coordinates": [-52.5, 69.1]}},
    {"type": "Feature", "properties": {"acquired": "2026-11-20T06:00:00Z", "length_m": 70, "confidence": null},
     "geometry": {"type": "Point", "coordinates": [-52.6, 69.2]}}]})"));
  ASSERT_EQ(bergs.size(), 2U);
  EXPECT_NE(bergs[0].id, bergs[1].id);
  const auto& first = bergs[0].place.lat_deg < 69.15 ? bergs[0] : bergs[1];
  EXPECT_EQ(first.method, "confidence 0.5");
  EXPECT_EQ(first.length->value, 90.0);
}

TEST_F(IcebergDetections, WithAConfidenceThatIsNoneAreLeftOut) {
  const auto bergs = stored(write_file("s1.csv", header + "69.1,-52.5,2026-11-20T06:00:00Z,120,250\n"
                                                          "69.2,-52.6,2026-11-20T06:00:00Z,60,95\n"));
  EXPECT_EQ(bergs.size(), 1U);
  EXPECT_THAT(words(report_), HasSubstr("confidence 250"));
}

TEST_F(IcebergDetections, WithoutAnythingThatTellsOfIcebergsAreAskedFor) {
  expect_refused(write_file("ships.csv", "lat,lon,time,confidence\n69.1,-52.5,2026-11-20T06:00:00Z,0.9\n"),
                 "");
}

}  // namespace
}  // namespace floeplan::ingest::detection_test
