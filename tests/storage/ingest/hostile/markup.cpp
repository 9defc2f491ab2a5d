#include "tests/storage/ingest/hostile/makers.hpp"
#include "tests/storage/ingest/support/foreign_files.hpp"

namespace floeplan::ingest {
namespace {

std::string point_with(const std::string& members, const std::string& coordinates = "[-52.0, 69.0]") {
  return R"({"type": "FeatureCollection", )" + members +
         R"("features": [{"type": "Feature", "properties": {"id": "a", "observed": "2026-11-20T06:00:00Z"},)"
         R"("geometry": {"type": "Point", "coordinates": )" +
         coordinates + "}}]}";
}

void add_geojson(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const std::string text = json_escaped(picked(rng, hostile_crs_texts(aims.secret, aims.port)));
  const std::string kind = picked(rng, std::vector<std::string>{"name", "link", "url", "EPSG"});
  gallery.push_back(
      hostile_text("GeoJSON", "a reference system from elsewhere", "bergs.geojson",
                   point_with(R"("crs": {"type": ")" + kind + R"(", "properties": {"href": ")" + text +
                              R"(", "name": ")" + text + R"(", "url": ")" + text + R"("}}, )")));
  const auto deep = number_in(rng, 10'000, 100'000);
  gallery.push_back(hostile_text("GeoJSON", "depth of tens of thousands", "bergs.geojson",
                                 point_with("", repeated("[", deep) + "1" + repeated("]", deep))));
  gallery.push_back(hostile_text("GeoJSON", "collections in collections", "zones.geojson",
                                 R"({"type": "Feature", "properties": {}, "geometry": )" +
                                     repeated(R"({"type": "GeometryCollection", "geometries": [)", 20'000)));
  gallery.push_back(hostile_text("GeoJSON", "places that are none", "bergs.geojson",
                                 point_with("", "[1e999, -1e308, 1e308]")));
}

std::string kml_of(const std::string& content, const std::string& before = "") {
  return "<?xml version=\"1.0\"?>" + before + R"(<kml xmlns="http://www.opengis.net/kml/2.2"><Document>)" +
         content + "</Document></kml>";
}

std::string placemark(const std::string& name) {
  return "<Placemark><name>" + name +
         "</name><TimeStamp><when>2026-11-20T06:30:00Z</when></TimeStamp><Point><coordinates>-49.5,-60.25,0"
         "</coordinates></Point></Placemark>";
}

/// Each entity is ten of the one before.
std::string laughs(std::int64_t generations) {
  std::string text = "<!DOCTYPE kml [<!ENTITY e0 \"ha\">";
  for (std::int64_t i = 1; i <= generations; ++i) {
    const std::string before = "&e" + std::to_string(i - 1) + ";";
    text += "<!ENTITY e" + std::to_string(i) + " \"" + repeated(before, 10) + "\">";
  }
  return text + "]>";
}

void add_kml(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const std::string place = picked(rng, places_to_open(aims));
  gallery.push_back(hostile_text("KML", "a text of a gigabyte out of a few lines", "bergs.kml",
                                 kml_of(placemark("&e9;"), laughs(9))));
  gallery.push_back(
      hostile_text("KML", "a file by an entity", "bergs.kml",
                   kml_of(placemark("&x;"), "<!DOCTYPE kml [<!ENTITY x SYSTEM \"" + place + "\">]>")));
  gallery.push_back(
      hostile_text("KML", "a file by a parameter entity", "bergs.kml",
                   kml_of(placemark("&x;"), "<!DOCTYPE kml [<!ENTITY % d SYSTEM \"" + place + "\"> %d;]>")));
  gallery.push_back(hostile_text("KML", "a document type from elsewhere", "bergs.kml",
                                 kml_of(placemark("a"), "<!DOCTYPE kml SYSTEM \"" + place + "\">")));
  gallery.push_back(hostile_text(
      "KML", "links and pictures", "bergs.kml",
      kml_of("<NetworkLink><Link><href>" + place + "</href></Link></NetworkLink><GroundOverlay><Icon><href>" +
             place + "</href></Icon></GroundOverlay><styleUrl>" + place + "#a</styleUrl>" + placemark("a"))));
  gallery.push_back(hostile_text("KML", "folders in folders", "bergs.kml",
                                 kml_of(repeated("<Folder>", number_in(rng, 50'000, 200'000)))));
}

/// Files that other drivers of GDAL would open.
void add_foreign(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  const std::string place = picked(rng, places_to_open(aims));
  const std::string raster =
      "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><SRS>EPSG:4326</SRS><VRTRasterBand dataType=\"Byte\" "
      "band=\"1\">"
      "<SimpleSource><SourceFilename>" +
      place + "</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>";
  for (const char* const name : {"bed.vrt", "bed.tif", "bed.nc", "bed.gpkg"})
    gallery.push_back(hostile_text("foreign", "what a virtual raster is made of", name, raster));
  gallery.push_back(hostile_text(
      "foreign", "Python in a virtual raster", "bed.vrt",
      "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><VRTRasterBand dataType=\"Byte\" "
      "band=\"1\" subClass=\"VRTDerivedRasterBand\"><PixelFunctionLanguage>Python"
      "</PixelFunctionLanguage><PixelFunctionCode>import os; os.system('touch " +
          (aims.store / "run").string() + "')</PixelFunctionCode></VRTRasterBand></VRTDataset>"));
  gallery.push_back(hostile_text("foreign", "what a virtual layer is made of", "bergs.vrt",
                                 "<OGRVRTDataSource><OGRVRTLayer name=\"a\"><SrcDataSource>" + place +
                                     "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>"));
  gallery.push_back(hostile_text("foreign", "tiles of a server", "map.xml",
                                 "<GDAL_WMS><Service name=\"TMS\"><ServerUrl>" + place +
                                     "/${z}/${x}/${y}</ServerUrl></Service></GDAL_WMS>"));
  for (const char* const prefix :
       {"NETCDF:\"", "HDF5:\"", "ZARR:\"", "GTIFF_DIR:1:", "WFS:", "PG:host=127.0.0.1 "})
    gallery.push_back(hostile_text("foreign", "what its name is taken for", "name.txt", prefix + place));
}

}  // namespace

void add_hostile_markup(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng) {
  add_geojson(gallery, aims, rng);
  add_kml(gallery, aims, rng);
  add_foreign(gallery, aims, rng);
}

}  // namespace floeplan::ingest
