#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/utc_text.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::iceberg_vector_test {
namespace {

class IcebergsInKml : public StoreFixture {
 protected:
  IngestReport read(const std::string& placemarks, const IngestOptions& options = {}) {
    return ingest(write_file("bergs.kml", R"(<?xml version="1.0" encoding="UTF-8"?>
<kml xmlns="http://www.opengis.net/kml/2.2"><Document>)" +
                                              placemarks + "</Document></kml>"),
                  options);
  }
};

const std::string point =
    "<Placemark><name>A99</name><TimeStamp><when>2026-11-20T06:30:00Z</when></TimeStamp>"
    "<Point><coordinates>-49.5,-60.25,0</coordinates></Point></Placemark>";

TEST_F(IcebergsInKml, AreItsPoints) {
  const IngestReport report = read(point);

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->kind, repository::DatasetKind::icebergs);
  const auto stored = repository::IcebergRepository{db_}.list({}, 0, 10);
  ASSERT_EQ(stored.size(), 1U);
  EXPECT_EQ(stored[0].iceberg.id, "A99");
  EXPECT_EQ(stored[0].iceberg.place, (geo::LonLat{-49.5, -60.25}));
  EXPECT_EQ(core::iso8601(stored[0].iceberg.observed), "2026-11-20T06:30:00Z");
}

TEST_F(IcebergsInKml, AreItsOutlinesWhenAskedFor) {
  const IngestReport report = read(
      "<Placemark><name>B1</name><TimeStamp><when>2026-11-20T06:30:00Z</when></TimeStamp><Polygon>"
      "<outerBoundaryIs><LinearRing><coordinates>-50,-60 -49.9,-60 -49.9,-59.9 -50,-60</coordinates>"
      "</LinearRing></outerBoundaryIs></Polygon></Placemark>",
      {.kind = repository::DatasetKind::icebergs});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto stored = repository::IcebergRepository{db_}.list({}, 0, 10);
  ASSERT_EQ(stored.size(), 1U);
  EXPECT_GT(stored[0].iceberg.length.value_or(core::Metres{0.0}).value, 5'000.0);
}

TEST_F(IcebergsInKml, MayCountTheirLongitudesOnInEitherSense) {
  for (const char* const lon : {"-180.5", "179.5"}) {
    const IngestReport report =
        read("<Placemark><name>A99</name><TimeStamp><when>2026-11-20</when></TimeStamp><Point><coordinates>" +
             std::string{lon} + ",70</coordinates></Point></Placemark>");

    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto stored = repository::IcebergRepository{db_}.list({}, 0, 10);
    ASSERT_EQ(stored.size(), 1U);
    EXPECT_EQ(stored[0].iceberg.place, (geo::LonLat{179.5, 70.0}));
    EXPECT_EQ(core::iso8601(stored[0].iceberg.observed), "2026-11-20T00:00:00Z");
    db_ = repository::open_store_in_memory();
  }
}

TEST_F(IcebergsInKml, WithoutATimeAreRefused) {
  const IngestReport report =
      read("<Placemark><name>A99</name><Point><coordinates>-49.5,-60.25,0</coordinates></Point></Placemark>");
  EXPECT_EQ(report.status, IngestStatus::refused);
}

}  // namespace
}  // namespace floeplan::ingest::iceberg_vector_test
