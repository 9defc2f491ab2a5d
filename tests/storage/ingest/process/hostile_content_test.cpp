#include <gmock/gmock.h>
#include <hdf5.h>

#include <fstream>
#include <iterator>
#include <map>

#include "storage/ingest/process/guarded_ingest.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/sql/statement.hpp"
#include "tests/storage/ingest/support/archive_writer.hpp"
#include "tests/storage/ingest/support/foreign_files.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/loopback_listener.hpp"
#include "tests/support/places.hpp"

namespace floeplan::ingest::hostile_content_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* secret_word = "xylophone";

/// Surroundings that hostile files try to reach: a store in use, a secret, and a server that counts its
/// connections. Nothing in them may be read, changed, removed or contacted.
class HostileContent : public StoreFixture {
 protected:
  HostileContent() {
    fs::create_directories(store_);
    for (const char* const name : {"floeplan.sqlite", "floeplan.sqlite-wal", "floeplan.sqlite-shm"})
      std::ofstream{store_ / name} << name;
    std::ofstream{secret_} << secret_word << "\n2026-11-20T06:00:00Z,60,-50," << secret_word << '\n';
    fs::create_directories(path("given"));
  }

  [[nodiscard]] fs::path given(const std::string& name) const {
    fs::create_directories(path("given/" + name).parent_path());
    return path("given/" + name);
  }
  fs::path write(const std::string& name, const std::string& content) const {
    std::ofstream{given(name), std::ios::binary} << content;
    return given(name);
  }
  [[nodiscard]] std::string url() const {
    return "http://127.0.0.1:" + std::to_string(server_.port()) + "/data";
  }

  /// Reads the file, and expects no effect on anything else, whether the file is refused or not.
  std::vector<IngestReport> read(const fs::path& file, const IngestOptions& options = {}) {
    SCOPED_TRACE(file.filename().string() + " " + options.crs.value_or(""));
    auto reports = guarded_ingest(db_, guard_, {file}, options, core::from_unix_seconds(1.8e9), {}, {}, {});
    EXPECT_FALSE(reports.empty());
    for (const IngestReport& report : reports) {
      EXPECT_THAT(words(report), Not(HasSubstr(secret_word)));
      if (!report.dataset) continue;
      EXPECT_EQ(rows_with_the_secret(), 0);
      repository::DatasetRepository{db_}.remove(report.dataset->id);
    }
    EXPECT_FALSE(server_.somebody_came());
    for (const char* const name : {"floeplan.sqlite", "floeplan.sqlite-wal", "floeplan.sqlite-shm"})
      EXPECT_EQ(content_of(store_ / name), name);
    EXPECT_THAT(content_of(secret_), HasSubstr(secret_word));
    EXPECT_EQ(std::distance(fs::directory_iterator{store_}, {}), 3);
    return reports;
  }

  void expect_no_data(const fs::path& file, const IngestOptions& options = {}) {
    for (const IngestReport& report : read(file, options))
      EXPECT_EQ(report.status, IngestStatus::refused) << file << ' ' << options.crs.value_or("");
  }

  std::int64_t rows_with_the_secret() {
    std::int64_t rows = 0;
    for (const char* const column : {"dataset_text.text", "sighting.berg_id", "sighting.shape", "zone.name",
                                     "glider_track.glider", "tide_station.name", "dataset.name"}) {
      const std::string name = column;
      sql::Statement query{
          db_, "SELECT count(*) FROM " + name.substr(0, name.find('.')) + " WHERE instr(" + name + ", ?1)"};
      query.bind(1, std::string{secret_word});
      if (query.step()) rows += query.integer(0);
    }
    return rows;
  }

  static std::string content_of(const fs::path& file) {
    std::ifstream in{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
  }

  /// Currents on a plane whose projection only the mapping says.
  fs::path projected_currents(const std::string& attribute, const std::string& text) const {
    NetcdfWriter writer{given("plane.nc")};
    writer.axis("time", {0.0, 6.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
    writer.axis("y", {0.0, 1000.0, 2000.0}, {{"units", "m"}, {"standard_name", "projection_y_coordinate"}});
    writer.axis("x", {0.0, 1000.0, 2000.0}, {{"units", "m"}, {"standard_name", "projection_x_coordinate"}});
    writer.variable({.name = "crs",
                     .dimensions = {"time"},
                     .values = {0.0, 0.0},
                     .texts = {{attribute, text}},
                     .numbers = {},
                     .fill = {}});
    for (const char* const name : {"eastward", "northward"})
      writer.variable({.name = name,
                       .dimensions = {"time", "y", "x"},
                       .values = std::vector<double>(18, 0.1),
                       .texts = {{"units", "m s-1"},
                                 {"standard_name", std::string{name} + "_sea_water_velocity"},
                                 {"grid_mapping", "crs"}},
                       .numbers = {},
                       .fill = {}});
    return given("plane.nc");
  }

  static std::string feature(const std::string& more) {
    return R"({"type": "FeatureCollection", )" + more +
           R"("features": [{"type": "Feature", "properties": {"id": "a",
              "observed": "2026-11-20T06:00:00Z"}, "geometry": {"type": "Point", "coordinates": [-52.0, 69.0]}}]})";
  }
  static std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
    return result;
  }

  const support::LoopbackListener server_;
  const fs::path store_{path("live")};
  const fs::path secret_{path("secret.csv")};
  const Guard guard_{.program = support::program_folder() + "/ingest_reader", .staging = path("incoming")};
};

TEST_F(HostileContent, InTheSchemaOfAGeoPackageRunsNothing) {
  const std::string live = (store_ / "floeplan.sqlite").string();
  const std::string expose =
      "INSERT INTO gpkg_contents(table_name, data_type, identifier, srs_id) VALUES ('evil', 'attributes', "
      "'evil', 0)";
  const auto view = [](const std::string& call) {
    return "CREATE VIEW evil AS SELECT fid, id, observed || coalesce(" + call +
           ", '') AS observed FROM bergs";
  };
  int number = 0;
  for (const std::vector<std::string>& statements : std::vector<std::vector<std::string>>{
           {view("PROJ_SetDatabasePath('" + live + "')"), expose},
           {view("BlobFromFile('" + secret_.string() + "')"), expose},
           {view("BlobToFile('gone', '" + live + "')"), expose},
           {view("load_extension('" + secret_.string() + "')"), expose},
           {view("ogr_datasource_load_layers('/vsicurl/" + url() + "')"), expose},
           {view("ST_Transform(geom, -1)"), expose},
           {"CREATE VIRTUAL TABLE evil USING VirtualText('" + secret_.string() + "', 'UTF-8', 0)", expose},
           {"CREATE VIRTUAL TABLE evil USING fts3(x)", expose},
           {view("1"), expose, "PRAGMA writable_schema = ON",
            "UPDATE sqlite_master SET type = 'table' WHERE name = 'evil'"}}) {
    const fs::path file = given("schema" + std::to_string(++number) + ".gpkg");
    write_points("GPKG", file, statements);
    read(file);
  }
  write_points("GPKG", given("c1.gpkg"), {view("PROJ_SetDatabasePath('" + live + "')"), expose});
  expect_no_data(given("c1.gpkg"));
}

TEST_F(HostileContent, InReferencesOfHdf5ReadsNoOtherFile) {
  const std::map<std::string, std::function<void(hid_t)>> references{
      {"link",
       [&](hid_t file) { H5Lcreate_external(secret_.c_str(), "/", file, "out", H5P_DEFAULT, H5P_DEFAULT); }},
      {"deep link",
       [&](hid_t file) {
         for (int i = 0; i < 20; ++i) file = H5Gcreate2(file, "g", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
         H5Lcreate_external(secret_.c_str(), "/", file, "out", H5P_DEFAULT, H5P_DEFAULT);
       }},
      {"values elsewhere",
       [&](hid_t file) {
         const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
         H5Pset_external(creation, secret_.c_str(), 0, 40);
         const hsize_t size = 40;
         H5Dcreate2(file, "elevation", H5T_NATIVE_UCHAR, H5Screate_simple(1, &size, nullptr), H5P_DEFAULT,
                    creation, H5P_DEFAULT);
       }},
      {"as a BAG", [&](hid_t file) {
         const hid_t root = H5Gcreate2(file, "BAG_root", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
         H5Lcreate_external(secret_.c_str(), "/", root, "elevation", H5P_DEFAULT, H5P_DEFAULT);
       }}};
  for (const auto& [name, refer] : references) {
    CurrentFile{}.write(given(name + ".nc"));
    const hid_t file = H5Fopen(given(name + ".nc").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    refer(file);
    H5Fclose(file);
    expect_no_data(given(name + ".nc"));
  }
}

TEST_F(HostileContent, InTextsOfReferenceSystemsOpensNothing) {
  const fs::path grid =
      write("bed.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 50\ncellsize 9000\n-9 -8 -7\n-6 -5 -4\n");
  for (const std::string& text : hostile_crs_texts(secret_, server_.port())) {
    expect_no_data(grid, {.crs = text, .positive = "up"});
    for (const char* const attribute : {"crs_wkt", "spatial_ref", "proj4"})
      expect_no_data(projected_currents(attribute, text));
    expect_no_data(projected_currents("note", ""), {.crs = text});
  }
}

TEST_F(HostileContent, InReferenceSystemsThatGdalReadsOpensNothing) {
  write_points("ESRI Shapefile", given("bergs.shp"));
  for (const std::string& text : hostile_crs_texts(secret_, server_.port())) {
    write("bergs.prj", text);
    read(given("bergs.shp"));
    for (const char* const type : {"name", "link", "url", "EPSG"})
      read(write("crs.geojson", feature(R"("crs": {"type": ")" + std::string{type} +
                                        R"(", "properties": {"href": ")" + escaped(text) + R"(", "name": ")" +
                                        escaped(text) + R"(", "url": ")" + escaped(text) + R"("}}, )")));
  }
}

TEST_F(HostileContent, ThatPointsToOtherPlacesIsNotFollowed) {
  const std::string kml = R"(<kml xmlns="http://www.opengis.net/kml/2.2"><Document>)";
  expect_no_data(write("link.kml", kml + "<NetworkLink><Link><href>" + url() +
                                       "</href></Link></NetworkLink>" + "</Document></kml>"));
  expect_no_data(write("entity.kml", "<!DOCTYPE kml [<!ENTITY x SYSTEM \"file://" + secret_.string() +
                                         "\">]>" + kml +
                                         "<Placemark><name>&x;</name></Placemark></Document></kml>"));
  expect_no_data(write("dtd.kml", "<!DOCTYPE kml SYSTEM \"" + url() + "\">" + kml +
                                      "<Placemark><name>&x;</name></Placemark></Document></kml>"));
  const std::string raster =
      "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><SRS>EPSG:4326</SRS><VRTRasterBand "
      "dataType=\"Byte\" band=\"1\"><SimpleSource><SourceFilename>" +
      secret_.string() + "</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>";
  for (const char* const name : {"bed.vrt", "bed.tif", "bed.nc", "bed.gpkg"})
    expect_no_data(write(name, raster));
  expect_no_data(write("layer.vrt", "<OGRVRTDataSource><OGRVRTLayer name=\"secret\"><SrcDataSource>" +
                                        secret_.string() +
                                        "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>"));
  expect_no_data(write("map.xml", "<GDAL_WMS><Service name=\"WMS\"><ServerUrl>" + url() +
                                      "</ServerUrl></Service></GDAL_WMS>"));
  expect_no_data(write("name.txt", "/vsicurl/" + url()));
  expect_no_data(write("name.nc", "NETCDF:\"" + url() + "\""));
}

TEST_F(HostileContent, BesideAFileIsNotFollowed) {
  const fs::path grid =
      write("bed.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 50\ncellsize 0.5\n-9 -8 -7\n-6 -5 -4\n");
  const std::string other = "<PAMDataset><SRS>/vsicurl/" + url() +
                            "</SRS><Metadata domain=\"OVERVIEWS\"><MDI key="
                            "\"OVERVIEW_FILE\">/vsicurl/" +
                            url() + "</MDI></Metadata></PAMDataset>";
  for (const char* const ending : {"asc.aux.xml", "aux.xml", "asc.ovr", "asc.msk"}) {
    write(std::string{"bed."} + ending, other);
    read(grid, {.positive = "up"});
  }
  fs::create_symlink(store_ / "floeplan.sqlite", given("bed.prj"));
  read(grid, {.positive = "up"});
}

TEST_F(HostileContent, InZarrLeadsOutOfNoStore) {
  const std::string array =
      R"({"zarr_format": 2, "shape": [2, 2], "chunks": [2, 2], "dtype": "<f4", "order": "C",
      "compressor": null, "filters": null, "fill_value": 0})";
  write("ice.zarr/.zgroup", R"({"zarr_format": 2})");
  write("ice.zarr/siconc/.zarray", array);
  write("ice.zarr/siconc/.zattrs",
        R"({"standard_name": "sea_ice_area_fraction", "_ARRAY_DIMENSIONS": ["y", "x"],
      "_CRS": {"url": ")" +
            url() + R"("}, "units": "1"})");
  fs::create_symlink(secret_, given("ice.zarr/siconc/0.0"));
  expect_no_data(path("given/ice.zarr"));
  fs::remove(given("ice.zarr/siconc/0.0"));
  fs::create_symlink(store_, given("ice.zarr/live"));
  expect_no_data(path("given/ice.zarr"));
  write("ice.zarr/.zmetadata",
        R"({"zarr_consolidated_format": 1, "metadata": {"../../live/.zarray": )" + array + "}}");
  expect_no_data(path("given/ice.zarr"));
}

TEST_F(HostileContent, InArchivesLandsNowhereElseAndIsBounded) {
  const std::string bergs = feature("");
  for (const char* const name :
       {"../live/floeplan.sqlite", "/tmp/floeplan-escaped.geojson", "a/../../live/x.geojson",
        "..\\live\\x.geojson", "request.json/../../x.geojson"}) {
    write_archive(given("out.zip"), Packing::zip, {{name, bergs}});
    expect_no_data(given("out.zip"));
  }
  EXPECT_FALSE(fs::exists("/tmp/floeplan-escaped.geojson"));
  write_archive(given("bomb.zip"), Packing::zip, {{"bed.xyz", std::string(200'000'000, '0')}});
  expect_no_data(given("bomb.zip"));
  write_archive(given("inner.zip"), Packing::zip, {{"bergs.geojson", bergs}});
  write_archive(given("nested.zip"), Packing::zip, {{"inner.zip", content_of(given("inner.zip"))}});
  expect_no_data(given("nested.zip"));
  std::string deep;
  for (int i = 0; i < 40; ++i) deep += "d/";
  write_archive(given("deep.zip"), Packing::zip, {{deep + "bergs.geojson", bergs}});
  expect_no_data(given("deep.zip"));
}

}  // namespace
}  // namespace floeplan::ingest::hostile_content_test
