#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/utc_text.hpp"
#include "storage/repository/features/coastline_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::geojson_test {
namespace {

using testing::HasSubstr;

class Geojson : public StoreFixture {
 protected:
  std::filesystem::path write(const std::string& features) const {
    return write_file("data.json", R"({"type": "FeatureCollection", "features": [)" + features + "]}");
  }
  static std::string point(const std::string& coordinates, const std::string& properties) {
    return R"({"type": "Feature", "geometry": {"type": "Point", "coordinates": )" + coordinates +
           R"(}, "properties": {)" + properties + "}}";
  }
  static std::string polygon(const std::string& rings) {
    return R"({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": )" + rings +
           R"(}, "properties": {"kind": "land"}})";
  }
};

TEST_F(Geojson, PointsBecomeIcebergs) {
  const auto report = ingest(
      write(point("[-54.25, 69.5]",
                  R"("id": "A-1", "observed": "2026-11-20T06:00:00Z", "length_m": 180, "draft_m": 90.5,
               "position_uncertainty_m": 340)") +
            "," + point("[-55, 69]", R"("name": "B", "time": "2026-11-20T08:00:00+02:00", "size": "bergy_bit",
                                     "position_uncertainty_m": 0)")));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto rows = repository::IcebergRepository{db_}.list({}, 0, 10);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].iceberg.id, "A-1");
  EXPECT_EQ(rows[0].iceberg.place, (geo::LonLat{-54.25, 69.5}));
  EXPECT_EQ(core::iso8601(rows[0].iceberg.observed), "2026-11-20T06:00:00Z");
  EXPECT_EQ(rows[0].iceberg.length, core::Metres{180.0});
  EXPECT_EQ(rows[0].iceberg.draft, core::Metres{90.5});
  EXPECT_EQ(rows[0].iceberg.position_uncertainty, core::Metres{340.0});
  EXPECT_EQ(rows[1].iceberg.id, "B");
  EXPECT_EQ(rows[1].iceberg.position_uncertainty, core::Metres{0.0});
  EXPECT_EQ(core::iso8601(rows[1].iceberg.observed), "2026-11-20T06:00:00Z");
  EXPECT_EQ(rows[1].iceberg.size, ocean::IcebergSize::bergy_bit);
}

TEST_F(Geojson, PointsHaveTheErrorOfTheirPositionUnderAnyNameOfIt) {
  const auto report = ingest(
      write(point("[-54.25, 69.5]",
                  R"("id": "A-1", "observed": "2026-11-20T06:00:00Z", "accuracyKm": 4, "radius_m": 9)")));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto rows = repository::IcebergRepository{db_}.list({}, 0, 10);
  EXPECT_EQ(rows[0].iceberg.position_uncertainty, core::Metres{4000.0});
  EXPECT_THAT(words(report), HasSubstr("\"radius_m\" may be the position error"));
}

TEST_F(Geojson, BadPointsAreLeftOutCountedAndExplained) {
  const std::string good = R"("id": "A", "observed": "2026-11-20T06:00:00Z")";
  const auto report = ingest(write(
      point("[0, 50]", good) + "," + point("[0, 95]", good) + "," + point("[400, 50]", good) + "," +
      point("[0, 50]", R"("id": "A", "observed": "2026-11-20T06:00:00")") + "," +
      point("[0, 50]", R"("id": "A")") + "," + point("[0, 50]", R"("observed": "2026-11-20T06:00:00Z")") +
      "," + point("[0, 50]", good + R"(, "length_m": -5)") + "," +
      point("[0, 50]", good + R"(, "position_uncertainty_m": -1)")));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->rows_accepted, 1);
  EXPECT_EQ(report.dataset->rows_refused, 7);
  EXPECT_THAT(words(report), HasSubstr("feature 2 was left out: the latitude 95"));
  EXPECT_THAT(words(report), HasSubstr("feature 3 was left out: the longitude 400"));
  EXPECT_THAT(words(report), HasSubstr("feature 7 was left out: its length_m"));
  EXPECT_THAT(words(report), HasSubstr("feature 8 was left out: its position_uncertainty_m"));
}

TEST_F(Geojson, AnIcebergInTheSaharaIsFlagged) {
  const auto report = ingest(write(point("[10, 25]", R"("id": "A1", "observed": "2026-11-20T06:00:00Z")")));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(words(report),
              HasSubstr("lies where no iceberg was ever seen. The first is \"A1\" at latitude 25"));
}

TEST_F(Geojson, PolygonsBecomeLand) {
  const auto report =
      ingest(write(polygon("[[[0,50],[4,50],[4,54],[0,54],[0,50]],[[1,51],[2,51],[2,52],[1,51]]]")));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->kind, repository::DatasetKind::coastline);
  const auto land =
      repository::CoastlineRepository{db_}.load(report.dataset->id, {-180.0, -90.0, 180.0, 90.0});
  ASSERT_EQ(land.size(), 1U);
  EXPECT_EQ(land[0].outer.size(), 4U);
  ASSERT_EQ(land[0].holes.size(), 1U);
  EXPECT_EQ(land[0].holes[0].size(), 3U);
}

TEST_F(Geojson, APolygonThatCannotBeUsedRefusesTheFile) {
  expect_refused(
      write(polygon("[[[0,50],[4,50],[4,54],[0,50]]]") + "," + polygon("[[[0,50],[4,95],[4,54],[0,50]]]")),
      "feature 2");
}

TEST_F(Geojson, MixedGeometriesAreRefused) {
  expect_refused(write(polygon("[[[0,50],[4,50],[4,54],[0,50]]]") + "," + point("[0, 50]", R"("id": "A")")),
                 "a mixture of shapes");
}

TEST_F(Geojson, ACutFileIsRefused) {
  expect_refused(
      write_file("cut.json", R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geom)"),
      "cut short");
}

TEST_F(Geojson, AnEmptyCollectionIsRefused) { expect_refused(write(""), "no features"); }

TEST_F(Geojson, AnotherReferenceSystemIsRefused) {
  expect_refused(
      write_file(
          "utm.json",
          R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "EPSG:32621"}},
                     "features": [)" +
              point("[500000, 7600000]", R"("id": "A")") + "]}"),
      "EPSG:4326");
}

}  // namespace
}  // namespace floeplan::ingest::geojson_test
