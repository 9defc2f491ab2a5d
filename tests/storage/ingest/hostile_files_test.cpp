#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "storage/ingest/gdal_guard.hpp"
#include "storage/ingest/guarded_ingest.hpp"
#include "storage/repository/dataset_repository.hpp"
#include "tests/storage/ingest/archive_writer.hpp"
#include "tests/storage/ingest/grib_writer.hpp"
#include "tests/storage/ingest/netcdf_writer.hpp"
#include "tests/storage/ingest/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest {
namespace {

using testing::HasSubstr;

/// How many damaged variants of each format are tried: few in every run, as many as FLOEPLAN_DAMAGED_FILES says in a
/// long one.
std::uint64_t variants(std::uint64_t in_every_run) {
  const char* wanted = std::getenv("FLOEPLAN_DAMAGED_FILES");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : in_every_run;
}

/// Small good files of the formats that others write by the thousand.
class HostileFiles : public StoreFixture {
 protected:
  std::vector<std::filesystem::path> good_files() {
    std::vector<std::filesystem::path> files = real_files();
    for (auto& file : written_files()) files.push_back(std::move(file));
    return files;
  }

  /// Of formats that nothing here writes; none where the samples are not on this machine.
  std::vector<std::filesystem::path> real_files() const {
    const std::filesystem::path samples = sample_folder();
    if (samples.empty()) return {};
    const std::string sensors = "1f35be3b.cac";  // beside the log
    const auto replace = std::filesystem::copy_options::overwrite_existing;
    std::filesystem::copy_file(samples / "glider" / sensors, path(sensors), replace);
    return {samples / "bathymetry/s57/US4MD81M.000", samples / "glider/gutils_profile.nc",
            samples / "glider/comet-2019-222-02-154.dbd"};
  }

  std::vector<std::filesystem::path> written_files() {
    CurrentFile{}.write(path("currents.nc"));
    write_geotiff(path("bed.tif"));
    write_points("GPKG", path("bergs.gpkg"));
    write_points("ESRI Shapefile", path("bergs.shp"));
    write_archive(path("bergs.zip"), Packing::zip, members_of({path("bergs.gpkg")}));
    return {
        path("currents.nc"),
        path("bed.tif"),
        path("bergs.gpkg"),
        path("bergs.shp"),
        path("bergs.zip"),
        write_file("currents.grb", grib_currents()),
        write_file("log.csv", slocum_log()),
        write_file("bed.asc",
                   "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 50\ncellsize 0.5\n-900 -800 70\n-600 -5 4\n"),
        write_file(
            "bergs.kml",
            "<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Placemark>"
            "<name>A99</name><TimeStamp><when>2026-11-20T06:30:00Z</when></TimeStamp><Point>"
            "<coordinates>-49.5,-60.25,0</coordinates></Point></Placemark></Document></kml>"),
        write_file("bergs.geojson",
                   R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties":
                          {"id": "a", "observed": "2026-11-20T06:00:00Z", "length_m": 120},
                          "geometry": {"type": "Point", "coordinates": [-52.0, 69.0]}}]})")};
  }

  static std::string slocum_log() {
    std::string text = "m_present_time,m_gps_lat,m_gps_lon,m_depth\ntimestamp,lat,lon,m\n";
    for (int i = 0; i < 40; ++i)
      text += std::to_string(1566395646 + 60 * i) + ",5418.9" + std::to_string(10 + i) + ",724.3016,1.5\n";
    return text;
  }

  static std::string grib_currents() {
    GribMessage u;
    u.value = [](double column, double row) { return 0.01 * (column + row); };
    GribMessage v;
    v.number = 3;
    v.value = [](double, double) { return 0.1; };
    return u.octets() + v.octets();
  }

  static void write_geotiff(const std::filesystem::path& file) {
    register_drivers();
    auto* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    GDALDatasetUniquePtr tiff{driver->Create(file.c_str(), 8, 8, 1, GDT_Float32, nullptr)};
    double transform[6] = {0.0, 0.5, 0.0, 54.0, 0.0, -0.5};
    tiff->SetGeoTransform(transform);
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    tiff->SetSpatialRef(&wgs84);
    std::vector<float> depths(64, -100.0F);
    ASSERT_EQ(tiff->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 8, 8, depths.data(), 8, 8, GDT_Float32, 0, 0),
              CE_None);
  }

  static void write_points(const char* driver, const std::filesystem::path& file,
                           const std::vector<std::string>& statements = {}) {
    register_drivers();
    GDALDatasetUniquePtr vector{
        GetGDALDriverManager()->GetDriverByName(driver)->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr)};
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer* layer = vector->CreateLayer("bergs", &wgs84, wkbPoint, nullptr);
    OGRFieldDefn id{"id", OFTString};
    OGRFieldDefn observed{"observed", OFTString};
    ASSERT_EQ(layer->CreateField(&id), OGRERR_NONE);
    ASSERT_EQ(layer->CreateField(&observed), OGRERR_NONE);
    for (int i = 0; i < 5; ++i) {
      OGRFeature feature{layer->GetLayerDefn()};
      feature.SetField("id", std::to_string(i).c_str());
      feature.SetField("observed", "2026-11-20T06:30:00Z");
      OGRPoint place{-50.0 - i, 60.0};
      feature.SetGeometry(&place);
      ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    }
    vector->FlushCache();
    for (const std::string& statement : statements) vector->ExecuteSQL(statement.c_str(), nullptr, nullptr);
  }

  static std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
  }

  /// Beside its other parts, where it has some.
  std::filesystem::path damaged_name(const std::filesystem::path& file) const {
    if (file.extension() == ".shp")
      for (const char* part : {".shx", ".dbf", ".prj"}) {
        std::filesystem::path beside = file;
        std::filesystem::copy_file(beside.replace_extension(part), path("damaged" + std::string{part}),
                                   std::filesystem::copy_options::overwrite_existing);
      }
    return path("damaged" + file.extension().string());
  }

  /// Reads a damaged file in the process that is made for it. Whatever comes of it lies in the store whole or not at all.
  std::vector<IngestReport> guarded(const std::filesystem::path& file) {
    auto reports =
        guarded_ingest(db_, guard_, {file}, {.positive = "up"}, core::from_unix_seconds(1.8e9), {}, {}, {});
    EXPECT_FALSE(reports.empty());
    for (const IngestReport& report : reports) {
      EXPECT_EQ(report.dataset.has_value(), report.status != IngestStatus::refused);
      EXPECT_EQ(report.errors.empty(), report.dataset.has_value());
      if (report.dataset) repository::DatasetRepository{db_}.remove(report.dataset->id);
    }
    EXPECT_EQ(stored_datasets(), 0U);
    return reports;
  }

  Guard guard_{.program = FLOEPLAN_BINARY_DIR "/ingest_reader", .staging = path("incoming")};
};

TEST_F(HostileFiles, AreReadWhileTheyAreGood) {
  for (const auto& file : good_files()) {
    const auto reports = guarded(file);
    EXPECT_EQ(reports.front().status, IngestStatus::stored) << file << words(reports.front());
  }
}

TEST_F(HostileFiles, ThatWereCutShortLeaveNothingHalfInTheStore) {
  const auto cuts = variants(2);
  for (const auto& file : good_files()) {
    const std::string whole = bytes_of(file);
    support::for_each_seed(std::min<std::uint64_t>(cuts, 20), [&](std::mt19937_64& rng) {
      const int part = support::uniform_int(rng, 0, 19);
      write_file(damaged_name(file).filename(),
                 whole.substr(0, whole.size() * static_cast<std::size_t>(part) / 20));
      const auto reports = guarded(damaged_name(file));
      const bool says_its_length = file.extension() != ".shp" && file.extension() != ".tif" &&
                                   file.extension() != ".zip" &&  // whole before its table of contents
                                   file.extension() != ".dbd" &&
                                   file.extension() != ".csv";  // a log ends where the glider was lost
      if (says_its_length) {
        EXPECT_EQ(reports.front().status, IngestStatus::refused) << file << " " << part;
      }
    });
  }
}

TEST_F(HostileFiles, WithBytesChangedLeaveNothingHalfInTheStore) {
  for (const auto& file : good_files()) {
    const std::string whole = bytes_of(file);
    support::for_each_seed(variants(2), [&](std::mt19937_64& rng) {
      std::string bytes = whole;
      for (int flips = support::uniform_int(rng, 1, 8); flips > 0; --flips)
        bytes[std::uniform_int_distribution<std::size_t>{0, bytes.size() - 1}(rng)] =
            static_cast<char>(support::uniform_int(rng, 0, 255));
      write_file(damaged_name(file).filename(), bytes);
      static_cast<void>(guarded(damaged_name(file)));
    });
  }
}

TEST_F(HostileFiles, ThatNeverEndAreRefusedWhenTheirTimeIsUp) {
  write_points("GPKG", path("endless.gpkg"),
               {"ALTER TABLE bergs RENAME TO hidden",
                "CREATE VIEW bergs AS WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT "
                "x AS fid, "
                "geom, id, observed FROM n, hidden"});
  guard_.most_cpu_s = 1;  // in every test run: the usual eight would be waited for

  const auto reports = guarded(path("endless.gpkg"));

  EXPECT_THAT(words(reports.front()), HasSubstr("reading took more than"));
}

TEST_F(HostileFiles, ThatUnpackToMoreThanTheMemoryAreRefused) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "memory has no limit under the sanitizers";
#endif
  write_points("GPKG", path("bomb.gpkg"),
               {"ALTER TABLE bergs RENAME TO hidden",
                "CREATE VIEW bergs AS SELECT fid, geom, replace(hex(zeroblob(200000000)), '00', 'berg') AS "
                "id, observed "
                "FROM hidden"});

  const auto reports = guarded(path("bomb.gpkg"));

  EXPECT_EQ(reports.front().status, IngestStatus::refused) << words(reports.front());
}

}  // namespace
}  // namespace floeplan::ingest
