#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <numeric>
#include <random>
#include <ranges>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/process/guarded_ingest.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/glider_track_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/fields/water_level_repository.hpp"
#include "tests/storage/ingest/support/adcirc_writer.hpp"
#include "tests/storage/ingest/support/archive_writer.hpp"
#include "tests/storage/ingest/support/foreign_files.hpp"
#include "tests/storage/ingest/support/grib_writer.hpp"
#include "tests/storage/ingest/support/model_grid_writer.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/s100_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/storage/ingest/support/tcd_writer.hpp"
#include "tests/support/places.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::hostile_files_test {
namespace {

using testing::HasSubstr;

/// The results for the damaged files of one format. A long run prints them on standard output.
struct Tally {
  std::uint64_t stored{};
  std::uint64_t refused{};
  std::uint64_t broken_readers{};  // of the refused: their reader died
  std::uint64_t out_of_bounds{};   // of the refused: their reader took too long or too much memory
  double longest_s{};
};

std::ostream& operator<<(std::ostream& out, const Tally& tally) {
  return out << tally.stored << " stored, " << tally.refused << " refused (of these " << tally.broken_readers
             << " broke their reader, " << tally.out_of_bounds << " went beyond its bounds), longest "
             << tally.longest_s << " s";
}

/// Small good files of formats that other programs write in great numbers.
class HostileFiles : public StoreFixture {
 protected:
  std::filesystem::path good_file(const std::string& name) {
    static const std::map<std::string, std::string> folders_of_samples{
        {"US4MD81M.000", "bathymetry/s57"},
        {"sample-2.0.1.bag", "bathymetry"},
        {"nw_atlantic_etopo1_4min.xyz", "bathymetry"},
        {"gnome_gridded_current.nc", "currents"},
        {"gutils_profile.nc", "glider"},
        {"seaglider_p1800001.nc", "glider"},
        {"comet-2019-222-02-154.dbd", "glider"},
        {"cis_beacon_1997_12995.csv", "icebergs"},
        {"byu_latest_20260818.json", "icebergs"},
        {"noaa_anchorage-knik-arm.json", "tides"},
        {"otps_tpxo9v2a_extract_HC_sample_out.txt", "tides"}};
    if (const auto sample = folders_of_samples.find(name); sample != folders_of_samples.end()) {
      const std::filesystem::path file = sample_folder() / sample->second / name;
      const std::filesystem::path sensors = file.parent_path() / "1f35be3b.cac";  // that the log names
      if (file.extension() == ".dbd" && std::filesystem::exists(sensors))
        std::filesystem::copy_file(sensors, path(sensors.filename().string()),
                                   std::filesystem::copy_options::overwrite_existing);
      return file;
    }
    if (name == "currents.nc") CurrentFile{}.write(path(name));
    if (name == "mesh.nc") write_fvcom({.origin = {15.0, 70.0}}, path(name));
    if (name == "roms.nc") write_roms({.columns = 12, .rows = 10}, path(name), {});
    if (name == "fort.64") {
      write_file("fort.14", AdcircBay::mesh());
      write_file(name, AdcircBay::currents(false));
    }
    if (name == "bed.tif") write_geotiff(path(name), 4326, {0.0, 0.5, 0.0, 54.0, 0.0, -0.5});
    if (name == "plane.tif") write_geotiff(path(name), 3035, {4.0e6, 100.0, 0.0, 3.2e6, 0.0, -100.0});
    if (name == "bergs.gpkg") write_points("GPKG", path(name));
    if (name == "bergs.shp") write_points("ESRI Shapefile", path(name));
    if (name == "bergs.zip") {
      write_points("GPKG", path("bergs.gpkg"));
      write_archive(path(name), Packing::zip, members_of({path("bergs.gpkg")}));
    }
    if (name == "currents.grb") write_file(name, grib_currents());
    if (name == "currents.h5")
      s111_sample([](std::size_t column, std::size_t row, std::size_t /*time*/) {
        return std::pair{0.5F + 0.1F * static_cast<float>(column), 60.0F * static_cast<float>(row)};
      }).write(path(name));
    if (name == "places.h5") {
      S100Sample sample =
          s111_sample([](std::size_t, std::size_t, std::size_t) { return std::pair{0.5F, 60.0F}; });
      sample.feature_numbers["dataCodingFormat"] = 3.0;
      for (int node = 0; node < 64; ++node)
        sample.places.emplace_back(-50.0 + 0.1 * (node % 8), 60.0 + 0.05 * (node / 8));
      sample.rows = 1;
      sample.columns = sample.places.size();
      for (S100Sample::Record& record : sample.records)
        record.values = {std::vector<float>(64, 0.5F), std::vector<float>(64, 60.0F)};
      sample.write(path(name));
    }
    if (name == "ice.nc") write_bent_ice(path(name));
    if (name == "levels.h5")
      s104_sample([](std::size_t column, std::size_t row, std::size_t time) {
        return 0.5F + 0.1F * static_cast<float>(column + row + time);
      }).write(path(name));
    if (name == "stations.h5") s104_stations().write(path(name));
    if (name == "bed.h5") s102_sample({10.0F, 20.0F, 30.0F, 40.0F, 50.0F, 60.0F}, 2.0F).write(path(name));
    if (name == "plane.h5") {
      S100Sample sample = s102_sample({10.0F, 20.0F, 30.0F, 40.0F, 50.0F, 60.0F}, 2.0F);
      sample.file_numbers["horizontalCRS"] = 32622.0;
      sample.west = 4.0e5;
      sample.south = 7.6e6;
      sample.step = 50.0;
      sample.write(path(name));
    }
    if (name == "tides.tcd")
      write_tcd(
          path(name),
          {{.name = "Nuuk", .place = {-51.7, 64.2}, .zone = -300, .constants = {{"M2", {1.5, 120.0}}}}});
    if (name == "p5610005.log")
      write_file(name,
                 "version: 67.01\nglider: 561\nmission: 6\ndive: 5\nstart: 5 4 116 20 33 7\ndata:\n"
                 "$GPS1,040516,203002,7017.131,838.117,29,1.3,29,1.1\n"
                 "$GPS2,040516,203244,7017.119,838.198,20,1.3,20,1.1\n$CURRENT,0.138, 12.9,1\n"
                 "$GPS,040516,215253,7016.197,839.033,41,1.2,41,1.1\n");
    if (name == "sea035.6.gli.sub.1")
      write_file(name,
                 "Timestamp;NavState;Heading;Depth;Lat;Lon;\n17/05/2019 "
                 "22:28:05;116;330.3;0.1;4839.016;-12327.045;\n"
                 "17/05/2019 22:29:05;110;330.3;5.9;4839.016;-12327.045;\n"
                 "17/05/2019 22:38:05;116;330.3;0.2;4839.100;-12327.000;\n");
    if (name == "detections.csv")
      write_file(name,
                 "lat,lon,acquired,length_m,confidence\n69.1,-52.5,2026-11-20T06:00:00Z,120,0.87\n"
                 "69.2,-52.6,2026-11-20T06:00:00Z,60,0.31\n");
    if (name == "log.csv") write_file(name, slocum_log());
    if (name == "bed.asc")
      write_file(name,
                 "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 50\ncellsize 0.5\n-900 -800 70\n-600 -5 4\n");
    if (name == "bergs.kml")
      write_file(name,
                 "<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Placemark>"
                 "<name>A99</name><TimeStamp><when>2026-11-20T06:30:00Z</when></TimeStamp><Point>"
                 "<coordinates>-49.5,-60.25,0</coordinates></Point></Placemark></Document></kml>");
    if (name == "chart_20261120.gml")
      write_file(
          name,
          "<?xml version=\"1.0\"?><ice:IceDataSet xmlns:gml=\"http://www.opengis.net/gml/3.2\" "
          "xmlns:ice=\"http://www.jcomm.info/ice\"><ice:IceFeatureMember><ice:seaice gml:id=\"a\">"
          "<ice:iceact>91</ice:iceact><ice:icesod>[87, 85]</ice:icesod>"
          "<gml:Polygon srsName=\"http://www.opengis.net/def/crs/EPSG/0/4326\"><gml:exterior>"
          "<gml:LinearRing><gml:posList>66 -60 66 -59 67 -59 67 -60 66 -60</gml:posList></gml:LinearRing>"
          "</gml:exterior></gml:Polygon></ice:seaice></ice:IceFeatureMember></ice:IceDataSet>\n");
    if (name == "bergs.geojson")
      write_file(name, R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties":
                          {"id": "a", "observed": "2026-11-20T06:00:00Z", "length_m": 120},
                          "geometry": {"type": "Point", "coordinates": [-52.0, 69.0]}}]})");
    return path(name);
  }

  /// Sea ice at a model's own points, whose places are tables.
  static void write_bent_ice(const std::filesystem::path& file) {
    const ModelGrid grid{.columns = 12, .rows = 10};
    NetcdfWriter ice{file};
    ice.dimension("time", 1);
    ice.dimension("y", grid.rows);
    ice.dimension("x", grid.columns);
    const auto add = [&](const std::string& name, const std::map<std::string, std::string>& texts,
                         const std::vector<std::string>& dimensions, const auto& value_at) {
      std::vector<double> values;
      for (std::size_t j = 0; j < grid.rows; ++j)
        for (std::size_t i = 0; i < grid.columns; ++i)
          values.push_back(value_at(grid.place(static_cast<double>(i), static_cast<double>(j))));
      ice.variable({.name = name,
                    .dimensions = dimensions,
                    .values = values,
                    .texts = texts,
                    .numbers = {},
                    .fill = {},
                    .type = NetcdfWriter::Type::float64});
    };
    add("nav_lon", {{"units", "degrees_east"}}, {"y", "x"}, [](geo::LonLat place) { return place.lon_deg; });
    add("nav_lat", {{"units", "degrees_north"}}, {"y", "x"}, [](geo::LonLat place) { return place.lat_deg; });
    add("siconc",
        {{"units", "1"}, {"standard_name", "sea_ice_area_fraction"}, {"coordinates", "nav_lon nav_lat"}},
        {"time", "y", "x"}, [](geo::LonLat place) { return 0.5 + 0.1 * (place.lat_deg - 70.0); });
    ice.variable({.name = "time",
                  .dimensions = {"time"},
                  .values = {0.0},
                  .texts = {{"units", "hours since 2026-11-20 00:00:00"}},
                  .numbers = {},
                  .fill = {},
                  .type = NetcdfWriter::Type::float64});
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

  static void write_geotiff(const std::filesystem::path& file, int epsg, std::array<double, 6> transform) {
    register_drivers();
    auto* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    GDALDatasetUniquePtr tiff{driver->Create(file.c_str(), 8, 8, 1, GDT_Float32, nullptr)};
    tiff->SetGeoTransform(transform.data());
    OGRSpatialReference crs;
    crs.importFromEPSG(epsg);
    tiff->SetSpatialRef(&crs);
    std::vector<float> depths(64, -100.0F);
    ASSERT_EQ(tiff->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 8, 8, depths.data(), 8, 8, GDT_Float32, 0, 0),
              CE_None);
  }

  static std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
  }

  /// Where a damaged copy of the file is written: beside the other parts of the file, if it has some.
  std::filesystem::path damaged_name(const std::filesystem::path& file) const {
    if (file.extension() == ".shp")
      for (const char* part : {".shx", ".dbf", ".prj"}) {
        std::filesystem::path beside = file;
        std::filesystem::copy_file(beside.replace_extension(part), path("damaged" + std::string{part}),
                                   std::filesystem::copy_options::overwrite_existing);
      }
    return path("damaged" + file.extension().string());
  }

  /// Reads a damaged file in a reader process. Expects that its data are stored as a whole or not at all, and
  /// that they are possible.
  std::vector<IngestReport> guarded(const std::filesystem::path& file) {
    const auto began = std::chrono::steady_clock::now();
    IngestOptions options{.positive = "up"};
    std::vector<std::filesystem::path> files{file};
    if (file.extension() == ".64") {  // says neither where its nodes lie nor when it began
      files.push_back(path("fort.14"));
      options.time = core::from_unix_seconds(1.79e9);
    }
    auto reports = guarded_ingest(db_, guard_, files, options, core::from_unix_seconds(1.8e9), {}, {}, {});
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - began;
    tally_.longest_s = std::max(tally_.longest_s, taken.count());
    EXPECT_FALSE(reports.empty());
    for (const IngestReport& report : reports) {
      EXPECT_EQ(report.dataset.has_value(), report.status != IngestStatus::refused);
      EXPECT_EQ(report.errors.empty(), report.dataset.has_value());
      ++(report.dataset ? tally_.stored : tally_.refused);
      if (words(report).find("stopped the program that reads it") != std::string::npos)
        ++tally_.broken_readers;
      if (words(report).find("reading the file took more than") != std::string::npos ||
          words(report).find("reading the file needs more than") != std::string::npos)
        ++tally_.out_of_bounds;
      if (!report.dataset) continue;
      expect_possible(*report.dataset);
      repository::DatasetRepository{db_}.remove(report.dataset->id);
    }
    EXPECT_EQ(stored_datasets(), 0U);
    return reports;
  }

  /// Expects that every number of the dataset is possible.
  void expect_possible(const repository::Dataset& dataset) {
    const repository::FieldRepository fields{db_};
    constexpr geo::BoundingBox world{-180.0, -90.0, 180.0, 90.0};
    const auto expect_within = [&](const std::vector<float>& values, float least, float greatest) {
      for (const float value : values)
        ASSERT_TRUE(std::isnan(value) || (value >= least && value <= greatest)) << value;
    };
    const auto expect_place = [](geo::LonLat place) {
      ASSERT_TRUE(std::abs(place.lat_deg) <= 90.0 && std::abs(place.lon_deg) <= 360.0)
          << place.lon_deg << " " << place.lat_deg;
    };
    expect_place({dataset.bounds.west_deg, dataset.bounds.south_deg});
    expect_place({dataset.bounds.east_deg, dataset.bounds.north_deg});
    if (dataset.kind == repository::DatasetKind::currents || dataset.kind == repository::DatasetKind::wind) {
      const auto field = fields.load_currents(dataset.id, world, std::nullopt, std::nullopt);
      const float fastest_m_s = dataset.kind == repository::DatasetKind::wind ? 100.01F : 10.01F;
      for (std::size_t i = 0; field && i < field->samples().u.size(); ++i)
        expect_within({std::hypot(field->samples().u[i], field->samples().v[i])}, 0.0F, fastest_m_s);
    }
    if (dataset.kind == repository::DatasetKind::bathymetry)
      for (const std::string& variable : fields.variables(dataset.id))
        if (const auto planes = fields.load_planes(dataset.id, world, std::array{variable}))
          expect_within(planes->values.front(), -9000.0F, 12'000.0F);  // Everest is 8,849 m high
    if (dataset.kind == repository::DatasetKind::ice)
      if (const auto ice = fields.load_ice(dataset.id, world, std::nullopt))
        expect_within(ice->samples().concentration, 0.0F, 1.0F);
    if (dataset.kind == repository::DatasetKind::water_levels)
      for (const auto& station : repository::WaterLevelRepository{db_}.stations(dataset.id)) {
        expect_place(station.place);
        expect_within(station.heights_m, -99.99F, 99.99F);
      }
    if (dataset.kind == repository::DatasetKind::icebergs)
      for (const auto& sighting : repository::IcebergRepository{db_}.list({}, 0, 10'000))
        expect_place(sighting.iceberg.place);
    if (dataset.kind == repository::DatasetKind::glider_tracks)
      for (const auto& stored : repository::GliderTrackRepository{db_}.list({}, 0, 100).tracks) {
        for (const auto& point : stored.track.points) expect_place(point.place);
        for (const auto& drift : stored.track.currents)
          EXPECT_LE(std::hypot(drift.current.east.value, drift.current.north.value), 10.01);
      }
  }

  Tally tally_;
  Guard guard_{.program = support::program_folder() + "/ingest_reader", .staging = path("incoming")};
};

/// One format.
class HostileFormat : public HostileFiles, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    file_ = good_file(GetParam());
    if (!std::filesystem::exists(file_)) GTEST_SKIP() << "the sample data are not on this machine";
  }

  std::filesystem::path file_;
};

TEST_P(HostileFormat, IsReadWhileItIsGood) {
  const auto reports = guarded(file_);
  EXPECT_EQ(reports.front().status, IngestStatus::stored) << words(reports.front());
}

TEST_P(HostileFormat, ThatWasCutShortLeavesNothingHalfInTheStore) {
  const std::string whole = bytes_of(file_);
  // Cut at each twentieth of its length, in random order; short runs try only the first of them.
  std::array<std::size_t, 20> parts{};
  std::iota(parts.begin(), parts.end(), std::size_t{0});
  std::ranges::shuffle(parts, std::mt19937_64{1});
  for (const std::size_t part : parts | std::views::take(static_cast<std::ptrdiff_t>(damaged_variants(2)))) {
    write_file(damaged_name(file_).filename(), whole.substr(0, whole.size() * part / 20));
    const auto reports = guarded(damaged_name(file_));
    const bool says_its_length = file_.extension() != ".shp" && file_.extension() != ".tif" &&
                                 file_.extension() != ".zip" &&  // whole before its table of contents
                                 file_.extension() != ".dbd" && file_.extension() != ".xyz" &&
                                 file_.extension() != ".txt" && file_.extension() != ".csv" &&
                                 file_.extension() != ".log" &&
                                 file_.extension() != ".1";  // a log ends where the glider was lost
    if (says_its_length) {
      EXPECT_EQ(reports.front().status, IngestStatus::refused) << part;
    }
  }
}

TEST_P(HostileFormat, WithBytesChangedLeavesNothingHalfInTheStore) {
  const std::string whole = bytes_of(file_);
  tally_ = {};
  support::for_each_seed(damaged_variants(2), [&](std::mt19937_64& rng) {
    std::string bytes = whole;
    for (int flips = support::uniform_int(rng, 1, 8); flips > 0; --flips)
      bytes[std::uniform_int_distribution<std::size_t>{0, bytes.size() - 1}(rng)] =
          static_cast<char>(support::uniform_int(rng, 0, 255));
    write_file(damaged_name(file_).filename(), bytes);
    static_cast<void>(guarded(damaged_name(file_)));
  });
  if (damaged_variants(0) > 0) std::cout << GetParam() << ": " << tally_ << std::endl;
}

INSTANTIATE_TEST_SUITE_P(
    Of, HostileFormat,
    testing::Values("US4MD81M.000", "gutils_profile.nc", "gnome_gridded_current.nc", "sample-2.0.1.bag",
                    "comet-2019-222-02-154.dbd", "currents.nc", "mesh.nc", "roms.nc", "ice.nc", "fort.64",
                    "bed.tif", "plane.tif", "bergs.gpkg", "bergs.shp", "bergs.zip", "currents.grb",
                    "currents.h5", "places.h5", "levels.h5", "stations.h5", "bed.h5", "plane.h5", "tides.tcd",
                    "detections.csv", "log.csv", "p5610005.log", "sea035.6.gli.sub.1",
                    "seaglider_p1800001.nc", "bed.asc", "bergs.kml", "chart_20261120.gml", "bergs.geojson",
                    "nw_atlantic_etopo1_4min.xyz", "cis_beacon_1997_12995.csv", "byu_latest_20260818.json",
                    "noaa_anchorage-knik-arm.json", "otps_tpxo9v2a_extract_HC_sample_out.txt"),
    [](const testing::TestParamInfo<const char*>& format) {
      std::string name = format.param;
      std::ranges::replace_if(
          name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
      return name;
    });

TEST_F(HostileFiles, ThatTakeLongerThanTheirSizeAllowsAreRefused) {
  std::string table = "id,lat,lon,time\n";
  for (int i = 0; i < 1'000'000; ++i) table += std::to_string(i) + ",60,-50,2026-11-20T06:00:00Z\n";
  guard_.most_cpu_s = 1;  // in every test run: the usual eight would be waited for

  const auto reports = guarded(write_file("endless.csv", table));

  EXPECT_THAT(words(reports.front()), HasSubstr("reading the file took more than"));
}

TEST_F(HostileFiles, ThatUnpackToMoreThanTheMemoryAreRefused) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "memory has no limit under the sanitizers";
#endif
  std::string kml = "<kml>";
  for (int i = 0; i < 8'000'000; ++i) kml += "<Folder/>";

  const auto reports = guarded(write_file("bomb.kml", kml + "</kml>"));

  EXPECT_THAT(words(reports.front()), HasSubstr("reading the file needs more than"));
}

}  // namespace
}  // namespace floeplan::ingest::hostile_files_test
