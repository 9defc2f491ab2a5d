#include "storage/ingest/data_formats.hpp"

#include "engine/messages/ingest_file_messages.hpp"
#include "storage/ingest/files/file_digest.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/formats/hdf5/hdf5_references.hpp"
#include "storage/ingest/formats/netcdf/netcdf3_length.hpp"
#include "storage/ingest/formats/s100/s100_coverage.hpp"
#include "storage/ingest/formats/slocum/slocum_header.hpp"
#include "storage/ingest/formats/slocum/slocum_log.hpp"
#include "storage/ingest/formats/tcd/tcd_file.hpp"
#include "storage/ingest/formats/vector/vector_files.hpp"
#include "storage/ingest/formats/zarr/zarr_store.hpp"
#include "storage/ingest/netcdf_contents.hpp"
#include "storage/ingest/notation/delimited_text.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/bathymetry/bathymetry_readers.hpp"
#include "storage/ingest/readers/bathymetry/depth_table.hpp"
#include "storage/ingest/readers/bathymetry/s57_cell.hpp"
#include "storage/ingest/readers/coastline/coastline_readers.hpp"
#include "storage/ingest/readers/currents/adcirc_file.hpp"
#include "storage/ingest/readers/currents/current_readers.hpp"
#include "storage/ingest/readers/currents/grib_contents.hpp"
#include "storage/ingest/readers/ice/ice_readers.hpp"
#include "storage/ingest/readers/icebergs/iceberg_readers.hpp"
#include "storage/ingest/readers/tides/tide_readers.hpp"
#include "storage/ingest/readers/tracks/seaglider_log.hpp"
#include "storage/ingest/readers/tracks/track_readers.hpp"
#include "storage/ingest/readers/zones/feature_kind.hpp"
#include "storage/ingest/readers/zones/zone_reader.hpp"
#include "storage/xml/xml_document.hpp"

namespace floeplan::ingest {
namespace {

using namespace std::string_view_literals;

bool is_classic_netcdf(std::string_view bytes) {
  return bytes.starts_with("CDF\x01") || bytes.starts_with("CDF\x02") || bytes.starts_with("CDF\x05");
}

bool is_hdf5(std::string_view bytes) { return bytes.starts_with("\x89HDF\r\n\x1a\n"); }

bool is_bag(std::string_view bytes) {
  return is_hdf5(bytes) && bytes.find("BAG_root") != std::string_view::npos;
}

bool is_tiff(std::string_view bytes) {
  return bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) || bytes.starts_with("II+\0"sv) ||
         bytes.starts_with("MM\0+"sv);
}

/// True for the leader of ISO 8211 at interchange level 3, which S-57 uses. S-101 uses it as well, but names
/// itself.
bool is_s57(std::string_view bytes) {
  return bytes.size() > 24 && bytes.substr(5, 3) == "3LE" &&
         bytes.find("INT.IHO.S-101") == std::string_view::npos;
}

bool is_ascii_grid(std::string_view text) {
  const std::string start = lower(trimmed(text.substr(0, 64)));
  return start.starts_with("ncols") || start.starts_with("nrows");
}

Checked<bool> is_whole_netcdf(const std::filesystem::path& file) {
  if (!is_classic_netcdf(first_bytes(file, 4))) return true;
  const auto needed = netcdf3_length(file);
  if (!needed) return refuse(needed.error());
  const std::uint64_t size = std::filesystem::file_size(file);
  if (size < *needed)
    return refuse(messages::ingest_file_message<"file-cut-short">("NetCDF file", *needed, "bytes", size));
  return true;
}

template <class Value>
Checked<bool> whether(const Checked<Value>& checked) {
  if (!checked) return refuse(checked.error());
  return true;
}

Checked<bool> look_into_features(RecognisedFile& file, Checked<std::shared_ptr<GDALDataset>> features,
                                 const Expectation& expected) {
  if (!features) return refuse(features.error());
  const auto kind = kind_of_features(**features, expected.kind, expected.zone_kind_stated);
  if (!kind) return refuse(kind.error());
  file.features = std::move(*features);
  file.kinds = {*kind};
  return true;
}

Checked<PreparedDataset> read_features(const Reading& reading) {
  using enum repository::DatasetKind;
  GDALDataset& features = *reading.file.features;
  if (reading.kind == icebergs) return read_geojson_icebergs(features);
  if (reading.kind == coastline) return read_coastline(features, reading.options);
  if (reading.kind == ice) return read_ice_polygons(features, reading.file.path, reading.options);
  return read_zones(features, reading.options);
}

Checked<bool> look_into_grib(RecognisedFile& file, const Expectation& /*expected*/) {
  auto kinds = kinds_of_grib(file.path);
  if (!kinds) return refuse(kinds.error());
  file.kinds = std::move(*kinds);
  return true;
}

Checked<PreparedDataset> read_slocum(const Reading& reading) {
  return read_slocum_tracks(reading.files, reading.progress);
}

std::vector<DataFormat> all_formats() {
  using enum repository::DatasetKind;
  return {
      {.name = "Zarr",
       .reads = "the same as from NetCDF; stores of version 2, and of version 3 without shards",
       .tested_with = "sea ice of GLORYS (version 2); version 3: files made for the tests",
       .kinds = {currents, wind, bathymetry, ice, tides, glider_tracks},
       .writing = Writing::folder,
       .is_it = [](const FileStart& start) { return is_zarr(start.folder); },
       .read = read_netcdf,
       .check = [](const std::filesystem::path& folder) { return whether(open_zarr(folder)); },
       .look_into = look_into_netcdf,
       .digest = [](const FileGroup& files) { return sha256_of_zarr(files.front()); }},

      {.name = "BAG",
       .reads = "depths of a survey, also of variable resolution",
       .tested_with = "two samples of the Open Navigation Surface, one of variable resolution",
       .kinds = {bathymetry},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return is_bag(start.bytes); },
       .read = [](const Reading& r) { return read_raster_bathymetry(r.file.path, "BAG", r.options); },
       .check = check_hdf5_references},

      {.name = "S-102",
       .reads = "depths of a hydrographic office on a regular grid, with their uncertainty",
       .tested_with = "a test file of the IHO (a survey off Florida)",
       .kinds = {bathymetry},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return is_s100(start.bytes, "S-102"); },
       .read = [](const Reading& r) { return read_s102_bathymetry(r.file.path); },
       .check = check_hdf5_references},

      {.name = "S-104",
       .reads =
           "water levels over time of a hydrographic office, on a regular grid, at separate places, on a "
           "triangulated mesh or at stations (data coding formats 1, 2, 3, 7 and 8)",
       .tested_with =
           "a test file of the IHO (format 2, off Florida); the other formats: files made for the tests",
       .kinds = {water_levels},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return is_s100(start.bytes, "S-104"); },
       .read = [](const Reading& r) { return read_s104_levels(r.file.path, r.progress); },
       .check = check_hdf5_references},

      {.name = "S-111",
       .reads = "surface currents of a hydrographic office, on a regular grid, at separate places or on a "
                "triangulated mesh (data coding formats 2, 3 and 7)",
       .tested_with =
           "a test file of the IHO (format 2, off Florida); formats 3 and 7: files made for the tests",
       .kinds = {currents},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return is_s100(start.bytes, "S-111"); },
       .read = [](const Reading& r) { return read_s111_currents(r.file.path, r.progress); },
       .check = check_hdf5_references},

      {.name = "NetCDF",
       .reads = "model output on regular, curvilinear and staggered grids and meshes; GEBCO, ETOPO, IBCAO "
                "and EMODnet; "
                "TPXO, TMD, FES and HAMTIDE; GSHHG as GMT has it; tracks of the IOOS DAC and OG1, "
                "dbd2netcdf, dives of a Seaglider",
       .tested_with = "CMEMS, HYCOM, DUACS, NEMO (ORCA025), ROMS (two models), FVCOM, ACCESS-OM2, MET "
                      "Norway's Arctic model, EMODnet, ETOPO, NERSC's sea ice, a Seaglider, the IOOS DAC; "
                      "SCHISM, ADCIRC, MITgcm, Delft3D FM, GEBCO, IBCAO, OSI SAF, AMSR2 sea ice of Bremen, "
                      "tide models: files made for "
                      "the tests",
       .kinds = {currents, wind, bathymetry, ice, tides, coastline, glider_tracks},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return is_classic_netcdf(start.bytes) || is_hdf5(start.bytes); },
       .read = read_netcdf,
       .check = is_whole_netcdf,
       .look_into = look_into_netcdf,
       .together = Together::model_output},

      {.name = "GRIB2",
       .reads = "currents, and wind 10 m above the sea",
       .tested_with = "currents of CMEMS that were encoded anew; wind: files made for the tests",
       .kinds = {currents, wind},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return start.bytes.starts_with("GRIB"); },
       .read =
           [](const Reading& r) {
             return r.kind == wind ? read_grib_wind(r.file.path, r.progress)
                                   : read_grib_currents(r.file.path, r.progress);
           },
       .look_into = look_into_grib},

      {.name = "GeoTIFF",
       .reads = "depths or elevations",
       .tested_with = "a survey of NOAA; ETOPO in a polar projection; twelve other reference systems: files "
                      "made for the tests",
       .kinds = {bathymetry},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return is_tiff(start.bytes); },
       .read = [](const Reading& r) { return read_raster_bathymetry(r.file.path, "GTiff", r.options); },
       .is_plain_raster = true},

      {.name = "GeoPackage",
       .reads = "points that are icebergs; polygons that are zones, land, ice shelves or sea ice (SIGRID-3)",
       .tested_with = "files made for the tests",
       .kinds = {icebergs, zones, coastline, ice},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return is_geopackage(start.bytes); },
       .read = read_features,
       .look_into =
           [](RecognisedFile& file, const Expectation& expected) {
             return look_into_features(file, open_vector_file(file.path, "GPKG"), expected);
           }},

      {.name = "shapefile",
       .reads = "the same as from a GeoPackage; needs the other files of the shapefile beside it",
       .tested_with = "files made for the tests",
       .kinds = {icebergs, zones, coastline, ice},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return start.bytes.starts_with("\x00\x00\x27\x0a"sv); },
       .read = read_features,
       .look_into =
           [](RecognisedFile& file, const Expectation& expected) {
             return look_into_features(file, open_vector_file(file.path, "ESRI Shapefile"), expected);
           },
       .digest = [](const FileGroup& files) { return sha256_of_files(parts_of_shapefile(files.front())); }},

      {.name = "S-57",
       .reads = "depths of a cell of an electronic chart, with the updates .001, ... beside it",
       .tested_with = "a cell of NOAA (Chesapeake Bay) with three updates",
       .kinds = {bathymetry},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return is_s57(start.bytes); },
       .read = [](const Reading& r) { return read_s57_bathymetry(r.file.path); },
       .digest = [](const FileGroup& files) { return sha256_of_files(parts_of_s57(files.front())); },
       .together = Together::chart_updates},

      {.name = "Slocum binary",
       .reads =
           "logs of a glider, .dbd, .sbd and the like, also compressed (.dcd, .scd), with their .cac or .ccc",
       .tested_with = "a log of the glider Comet",
       .kinds = {glider_tracks},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return is_slocum_binary(start.bytes); },
       .read = read_slocum,
       .digest = [](const FileGroup& files) { return sha256_of_files(without_sensor_caches(files)); },
       .together = Together::glider_log},

      {.name = "TCD",
       .reads = "harmonic constants of stations, as XTide and TICON have them",
       .tested_with = "XTide's harmonics of January 2021",
       .kinds = {tides},
       .writing = Writing::binary,
       .is_it = [](const FileStart& start) { return is_tcd(start.bytes); },
       .read = [](const Reading& r) { return read_tcd_stations(r.file.path); },
       .check = is_whole_tcd},

      {.name = "GeoJSON",
       .reads = "points that are icebergs; polygons that are zones, land, ice shelves or sea ice (SIGRID-3)",
       .tested_with = "files made for the tests",
       .kinds = {icebergs, zones, coastline, ice},
       .writing = Writing::json,
       .is_it =
           [](const FileStart& start) {
             return contains_any(start.bytes, {"\"Feature\"", "\"FeatureCollection\""});
           },
       .read = read_features,
       .look_into =
           [](RecognisedFile& file, const Expectation& expected) {
             return look_into_features(file, open_geojson(file.path), expected);
           }},

      {.name = "Brigham Young University",
       .reads = "its list of present iceberg positions, JSON",
       .tested_with = "its list of 18 August 2026",
       .kinds = {icebergs},
       .writing = Writing::json,
       .is_it = [](const FileStart& start) { return is_iceberg_list_json(start.bytes); },
       .read = [](const Reading& r) { return read_iceberg_list_json(r.file.path); }},

      {.name = "NOAA's JSON",
       .reads = "harmonic constants of stations",
       .tested_with = "Honolulu, San Francisco and Anchorage",
       .kinds = {tides},
       .writing = Writing::json,
       .is_it = [](const FileStart& start) { return is_tide_json(start.bytes); },
       .read = [](const Reading& r) { return read_tide_json(r.file.path, r.options); }},

      {.name = "KML",
       .reads = "the same as from GeoJSON; KMZ too",
       .tested_with = "files made for the tests",
       .kinds = {icebergs, zones, coastline, ice},
       .writing = Writing::xml,
       .is_it = [](const FileStart& start) { return xml::root_name(start.bytes) == "kml"; },
       .read = read_features,
       .look_into =
           [](RecognisedFile& file, const Expectation& expected) {
             return look_into_features(file, open_kml(file.path), expected);
           }},

      {.name = "S-411",
       .reads =
           "sea ice of an ice service: concentration and thickest stage of each area, GML of edition 1.1",
       .tested_with = "files made for the tests",
       .kinds = {ice},
       .writing = Writing::xml,
       .is_it = [](const FileStart& start) { return is_s411(start.bytes); },
       .read = read_features,
       .look_into =
           [](RecognisedFile& file, const Expectation& expected) {
             return look_into_features(file, open_s411(file.path, file.warnings), expected);
           }},

      {.name = "ESRI ASCII",
       .reads = "depths or elevations on a grid",
       .tested_with = "a window of ETOPO that GDAL wrote",
       .kinds = {bathymetry},
       .writing = Writing::text,
       .is_it = [](const FileStart& start) { return is_ascii_grid(start.bytes); },
       .read = [](const Reading& r) { return read_raster_bathymetry(r.file.path, "AAIGrid", r.options); },
       .check = [](const std::filesystem::path& file) { return whether(ascii_grid_length(file)); },
       .has_lines = true,
       .is_plain_raster = true},

      {.name = "International Ice Patrol",
       .reads = "its sightings of icebergs (NSIDC G00807), CSV",
       .tested_with = "the season of 2014",
       .kinds = {icebergs},
       .writing = Writing::text,
       .is_it = [](const FileStart& start) { return is_ice_patrol_header(std::string{start.first_line()}); },
       .read = [](const Reading& r) { return read_ice_patrol_csv(r.file.path); },
       .has_lines = true},

      {.name = "US National Ice Center",
       .reads = "its list of icebergs, CSV; also tracks of Brigham Young University and of the Canadian Ice "
                "Service's beacons",
       .tested_with = "rows of its list in two layouts; tracks of eight icebergs; a beacon of 1997",
       .kinds = {icebergs},
       .writing = Writing::text,
       .is_it =
           [](const FileStart& start) { return is_iceberg_table_header(std::string{start.first_line()}); },
       .read = [](const Reading& r) { return read_iceberg_table(r.file.path); },
       .has_lines = true},

      {.name = "table of your own",
       .reads =
           "columns id, lat, lon and time, and others that are known; satellite detections with a confidence "
           "in place of the id",
       .tested_with = "files made for the tests",
       .kinds = {icebergs},
       .writing = Writing::text,
       .is_it =
           [](const FileStart& start) {
             return is_own_iceberg_table_header(start.first_line(), start.icebergs_stated);
           },
       .read = [](const Reading& r) { return read_own_iceberg_table(r.file.path); },
       .has_lines = true},

      {.name = "tide table",
       .reads = "harmonic constants of a station: columns of names, amplitudes and phases",
       .tested_with = "constants of Honolulu by UTide; a table of NOAA",
       .kinds = {tides},
       .writing = Writing::text,
       .is_it = [](const FileStart& start) { return is_tide_table(start.bytes); },
       .read = [](const Reading& r) { return read_tide_table(r.file.path, r.options); },
       .has_lines = true},

      {.name = "OTPS",
       .reads = "harmonic constants that its extract_HC writes for places",
       .tested_with = "its own sample for three places",
       .kinds = {tides},
       .writing = Writing::text,
       .is_it = [](const FileStart& start) { return is_otps_extract(start.bytes); },
       .read = [](const Reading& r) { return read_otps_extract(r.file.path); },
       .has_lines = true},

      {.name = "ADCIRC",
       .reads =
           "currents averaged over depth at the nodes of its mesh: fort.64 with fort.14, and fort.63 for "
           "what is dry",
       .tested_with = "files made for the tests after its manual",
       .kinds = {currents},
       .writing = Writing::text,
       .is_it = [](const FileStart& start) { return adcirc_head(start.bytes).has_value(); },
       .read = [](const Reading& r) { return read_adcirc_currents(r.files, r.options, r.progress); },
       .together = Together::adcirc_run},

      {.name = "XYZ",
       .reads = "depths or elevations on a grid: longitude or easting, latitude or northing, value",
       .tested_with = "ETOPO1 of the north-western Atlantic",
       .kinds = {bathymetry},
       .writing = Writing::text,
       .is_it = [](const FileStart& start) { return is_number_table(start.bytes); },
       .read = [](const Reading& r) { return read_raster_bathymetry(r.file.path, "XYZ", r.options); },
       .has_lines = true,
       .is_plain_raster = true},

      {.name = "Slocum text",
       .reads = "logs of a glider, comma-separated or as dbd2asc writes them",
       .tested_with = "logs of the gliders Comet and Amadeus",
       .kinds = {glider_tracks},
       .writing = Writing::text,
       .is_it = [](const FileStart& start) { return is_slocum_text(start.bytes); },
       .read = read_slocum,
       .together = Together::glider_log},

      {.name = "Seaglider",
       .reads = "the log of each dive, .log, with its engineering record, .eng",
       .tested_with = "the engineering record of a dive of 2016; logs: files made for the tests",
       .kinds = {glider_tracks},
       .writing = Writing::text,
       .is_it =
           [](const FileStart& start) {
             return is_seaglider_log(start.bytes) || is_seaglider_record(start.bytes);
           },
       .read = [](const Reading& r) { return read_seaglider_logs(r.files, r.progress); },
       .together = Together::seaglider_dives},

      {.name = "SeaExplorer",
       .reads = "navigation and payload of each dive, gli and pld1, text with semicolons",
       .tested_with = "a dive of glider SEA035",
       .kinds = {glider_tracks},
       .writing = Writing::text,
       .is_it = [](const FileStart& start) { return is_seaexplorer_text(start.bytes); },
       .read = [](const Reading& r) { return read_seaexplorer_texts(r.files, r.progress); },
       .together = Together::seaexplorer_dives},

      {.name = "grid of depths",
       .reads = "a table with the columns lon, lat and depth or elevation",
       .tested_with = "files made for the tests",
       .kinds = {bathymetry},
       .writing = Writing::text,
       .is_it = [](const FileStart& start) { return is_depth_table_header(start.first_line()); },
       .read = [](const Reading& r) { return read_depth_table(r.file.path, r.options); },
       .has_lines = true},
  };
}

}  // namespace

const std::vector<DataFormat>& data_formats() {
  static const std::vector<DataFormat> formats = all_formats();
  return formats;
}

}  // namespace floeplan::ingest
