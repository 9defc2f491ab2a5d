#include <gmock/gmock.h>

#include "tests/storage/ingest/support/foreign_files.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::geopackage_test {
namespace {

class GeoPackages : public StoreFixture {
 protected:
  std::filesystem::path with(const std::vector<std::string>& statements) {
    std::filesystem::remove(path("bergs.gpkg"));
    write_points("GPKG", path("bergs.gpkg"), statements);
    return path("bergs.gpkg");
  }
};

TEST_F(GeoPackages, AreReadAsGdalWritesThem) {
  const IngestReport report = ingest(with({}));
  EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->rows_accepted, 5);
}

TEST_F(GeoPackages, AreReadWithTheStylesAndTriggersOfQgis) {
  const IngestReport report = ingest(with(
      {"CREATE TABLE layer_styles (id INTEGER PRIMARY KEY AUTOINCREMENT, f_table_name TEXT, styleName TEXT, "
       "styleQML TEXT, useAsDefault BOOLEAN, update_time DATETIME DEFAULT CURRENT_TIMESTAMP)",
       "INSERT INTO layer_styles (f_table_name, styleName, styleQML) VALUES ('bergs', 'red', '<qgis/>')",
       "CREATE INDEX by_time ON bergs (observed)",
       "CREATE TRIGGER touched AFTER UPDATE ON bergs BEGIN UPDATE layer_styles SET styleName = 'blue'; "
       "END"}));
  EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
}

TEST_F(GeoPackages, AreReadWhenTheirWriterUsedALogOfChanges) {
  const IngestReport report = ingest(with({"PRAGMA journal_mode = WAL"}));
  EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
}

TEST_F(GeoPackages, AreRefusedWithWhatCouldRunCode) {
  expect_refused(with({"CREATE VIEW other AS SELECT * FROM bergs"}), "holds a view");
  expect_refused(with({"CREATE TABLE other (a TEXT, b TEXT AS (lower(a)))"}), "holds a computed column");
  expect_refused(with({"CREATE VIRTUAL TABLE other USING fts3(a)"}), "holds a virtual table");
}

}  // namespace
}  // namespace floeplan::ingest::geopackage_test
