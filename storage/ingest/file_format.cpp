#include "storage/ingest/file_format.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/core/utf8_text.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/formats/netcdf/netcdf3_length.hpp"
#include "storage/ingest/formats/slocum/slocum_bytes.hpp"
#include "storage/ingest/formats/slocum/slocum_header.hpp"
#include "storage/ingest/formats/slocum/slocum_log.hpp"
#include "storage/ingest/formats/zarr/zarr_store.hpp"
#include "storage/ingest/notation/delimited_text.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/bathymetry/ascii_grid_length.hpp"
#include "storage/ingest/readers/bathymetry/depth_table.hpp"
#include "storage/ingest/readers/icebergs/iceberg_csv_reader.hpp"
#include "storage/ingest/readers/icebergs/iceberg_own_table.hpp"
#include "storage/ingest/readers/icebergs/iceberg_table_reader.hpp"
#include "storage/ingest/readers/tides/tide_table.hpp"
#include "storage/xml/xml_document.hpp"

namespace floeplan::ingest {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t head_bytes = 65536;

bool is_zarr(const std::filesystem::path& folder) {
  return std::ranges::any_of(std::array{"zarr.json", ".zgroup", ".zmetadata", ".zarray"},
                             [&](const char* name) { return std::filesystem::exists(folder / name); });
}

Checked<FileFormat> format_of_folder(const std::filesystem::path& folder) {
  if (!is_zarr(folder)) return refuse("this is a folder, not a file; name the files in it one by one");
  if (const auto store = open_zarr(folder); !store) return refuse(store.error());
  return FileFormat::zarr;
}

std::uint32_t big_endian_at(std::string_view head, std::size_t offset) {
  std::uint32_t value = 0;
  for (const char byte : head.substr(offset, 4)) value = (value << 8) | static_cast<unsigned char>(byte);
  return value;
}

/// By the first record, whose length in bytes stands before it: of constituents nx, ny, their count, four limits and
/// their names of four letters; of a grid nx, ny, four limits, a time step, a count.
/// Source  as public readers of TPXO take the format apart; no file of it has been at hand
bool is_otis_binary(std::string_view head) {
  constexpr std::uint32_t most_nodes = 100'000;
  if (head.size() < 64) return false;
  const std::uint32_t length = big_endian_at(head, 0);
  const auto is_size = [](std::uint32_t nodes) { return nodes >= 2 && nodes <= most_nodes; };
  if (!is_size(big_endian_at(head, 4)) || !is_size(big_endian_at(head, 8))) return false;
  const std::uint32_t constituents = big_endian_at(head, 12);
  const bool is_grid = length == 32 && big_endian_at(head, 36) == length;
  return is_grid || (constituents >= 1 && constituents <= 100 && length == 28 + 4 * constituents);
}

/// What a file is that this program knows but does not read; empty when it may be readable.
std::string refusal_of_foreign(std::string_view head) {
  if (head.find("BSB/") < 4096 || head.find("KNP/") < 4096)
    return "this is a raster chart (KAP/BSB): a picture of a chart in colours, not depths; depths cannot be "
           "read from it; give a bathymetry grid of the area";
  if (is_sensor_cache(head))
    return "this is the list of the sensors of a Slocum glider's logs, which holds no data by itself; "
           "give it together with the logs that name it";
  if (is_otis_binary(head))
    return "this is a tide model in the binary format of OTIS (TPXO's h, u and grid files), which this "
           "program does not read; give what OTPS's extract_HC writes for your places, or the model as "
           "NetCDF (the TPXO atlas)";
  if (head.starts_with("PK\x03\x04") || head.starts_with("\x1f\x8b") || head.starts_with("BZh"))
    return "this is a compressed archive; unpack it and give the files in it";
  if (head.starts_with("%PDF") || head.starts_with("\x89PNG") || head.starts_with("\xff\xd8\xff"))
    return "this is a picture or a document, not data; give the data that it was made from";
  if (head.starts_with("SQLite format 3"))
    return "this is an SQLite database, but no GeoPackage; convert it to GeoJSON";
  if (head.starts_with("CDF") || head.starts_with("\x89HDF") || head.starts_with("\x0e\x03\x13\x01"))
    return "this is a variant of NetCDF or HDF that this program does not know; convert it to NetCDF-4";
  return {};
}

/// By the application's id in the head of an SQLite database, "GPKG" or, of version 1.1 and before, "GP10", "GP11".
/// Source  OGC 12-128, requirement 2; sqlite.org/fileformat.html, 1.3
bool is_geopackage(std::string_view head) {
  constexpr std::size_t id_offset = 68;
  return head.starts_with("SQLite format 3") && head.size() > id_offset + 4 &&
         head.substr(id_offset, 2) == "GP";
}

bool is_text(std::string_view head) {
  return std::none_of(head.begin(), head.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 9 || (byte > 13 && byte < 32 && byte != 27);
  });
}

std::string_view first_line(std::string_view head) { return head.substr(0, head.find('\n')); }

/// At least three numbers on each of the first lines, separated by blanks, commas, semicolons or tabs.
bool is_number_table(std::string_view head) {
  int lines = 0;
  while (lines < 5 && head.find('\n') != std::string_view::npos) {
    std::string line{first_line(head)};
    head.remove_prefix(line.size() + 1);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == ',' || c == ';' || c == '\t' || c == '\r'; }, ' ');
    int numbers = 0;
    std::string_view rest = line;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      if (end > 0 && !parse_number(rest.substr(0, end))) return false;
      numbers += end > 0 ? 1 : 0;
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (numbers < 3) return false;
    ++lines;
  }
  return lines > 0;
}

Checked<FileFormat> format_of_text(std::string_view head, const std::string& extension,
                                   bool icebergs_stated) {
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  const std::string start = lower(trimmed(head.substr(0, 64)));
  if (start.starts_with("{")) {
    if (contains_any(head, {"\"Feature\"", "\"FeatureCollection\""})) return FileFormat::geojson;
    if (is_iceberg_list_json(head)) return FileFormat::iceberg_json;
    if (is_tide_json(head)) return FileFormat::tide_json;
    return refuse(
        "this is JSON, but not GeoJSON; the places in it have no agreed meaning; convert it to a GeoJSON "
        "FeatureCollection in longitude and latitude");
  }
  if (xml::root_name(head) == "kml") return FileFormat::kml;
  if (start.starts_with("ncols") || start.starts_with("nrows")) return FileFormat::ascii_grid;
  if (is_ice_patrol_header(std::string{first_line(head)})) return FileFormat::ice_patrol_csv;
  if (is_iceberg_table_header(std::string{first_line(head)})) return FileFormat::iceberg_table;
  if (is_own_iceberg_table_header(first_line(head), icebergs_stated)) return FileFormat::own_iceberg_table;
  if (is_tide_table(head)) return FileFormat::tide_table;
  if (is_otps_extract(head)) return FileFormat::otps_extract;
  if (is_number_table(head)) return FileFormat::xyz;
  if (is_slocum_text(head)) return FileFormat::slocum_text;
  if (is_depth_table_header(first_line(head))) return FileFormat::depth_table;

  const std::string line = trimmed(first_line(head));
  if (!contains_any(line, {"[", "<"}) && csv_fields(line).size() >= 3)
    return refuse(
        "this is a table with the columns " + enumeration(csv_fields(line)) +
        ", which this program does not know; of icebergs it reads the tables of the International Ice "
        "Patrol, the US National Ice Center, Brigham Young University and the Canadian Ice Service's "
        "beacons, and others with the columns id, lat, lon and time (with --kind icebergs whatever else "
        "they hold); of depths those with lon, "
        "lat and depth or elevation; name the columns so, or convert the table to GeoJSON");
  if (extension == ".nc" || extension == ".cdf" || extension == ".nc4")
    return refuse(
        "the file is named like NetCDF but holds text (\"" + line.substr(0, 60) +
        "\"); probably the download returned a message instead of data; read it and download again");
  return refuse(
      "this is a text of a kind that this program does not know; give NetCDF, GeoTIFF, ESRI ASCII, XYZ, "
      "GeoJSON, KML or the sightings of the International Ice Patrol");
}

Checked<FileFormat> format_of_classic_netcdf(const std::filesystem::path& file) {
  const auto needed = netcdf3_length(file);
  if (!needed) return refuse(needed.error());
  const std::uint64_t size = std::filesystem::file_size(file);
  if (size < *needed)
    return refuse("the NetCDF file was cut short: its header announces " + std::to_string(*needed) +
                  " bytes, but it has " + std::to_string(size) +
                  "; the end would be read as zeros; copy or download it again");
  return FileFormat::netcdf_classic;
}

Checked<FileFormat> format_of_compressed_slocum(const std::filesystem::path& file) {
  const std::string head = slocum_bytes(file, head_bytes).bytes;
  if (is_slocum_binary(head)) return FileFormat::slocum_binary;
  if (auto foreign = refusal_of_foreign(head); !foreign.empty()) return refuse(std::move(foreign));
  return refuse(damaged_slocum_log("its first compressed block cannot be unpacked"));
}

}  // namespace

Checked<FileFormat> format_of(const std::filesystem::path& file, bool icebergs_stated) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (std::filesystem::is_directory(status)) return format_of_folder(file);
  if (!std::filesystem::is_regular_file(status))
    return refuse("there is no such file; check its name and its folder");
  const std::string head = first_bytes(file, head_bytes);
  if (head.empty())
    return refuse(
        "the file is empty or cannot be read; the download or copy failed; copy or download it again");

  const std::string_view bytes = head;
  if (bytes.starts_with("CDF\x01") || bytes.starts_with("CDF\x02") || bytes.starts_with("CDF\x05"))
    return format_of_classic_netcdf(file);
  if (bytes.starts_with("GRIB")) return FileFormat::grib;
  if (bytes.starts_with("\x89HDF\r\n\x1a\n"))
    return bytes.find("BAG_root") != std::string_view::npos ? FileFormat::bag : FileFormat::netcdf4;
  if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) || bytes.starts_with("II+\0"sv) ||
      bytes.starts_with("MM\0+"sv))
    return FileFormat::geotiff;
  if (is_geopackage(bytes)) return FileFormat::geopackage;
  if (bytes.starts_with("\x00\x00\x27\x0a"sv)) return FileFormat::shapefile;
  // The leader of ISO 8211 with interchange level 3, as S-57 has it.
  if (bytes.size() > 24 && bytes.substr(5, 3) == "3LE") return FileFormat::s57;
  if (is_slocum_binary(bytes)) return FileFormat::slocum_binary;
  if (is_compressed_slocum(bytes)) return format_of_compressed_slocum(file);
  if (auto foreign = refusal_of_foreign(bytes); !foreign.empty()) return refuse(std::move(foreign));
  const std::string text = core::utf8_text(bytes);
  if (text != bytes && !bytes.starts_with("\xEF\xBB\xBF")) {
    if (xml::root_name(text) == "kml") return FileFormat::kml;
    return refuse("this is a text in UTF-16, of which this program reads KML alone; save it in UTF-8");
  }
  if (is_text(bytes)) {
    auto format = format_of_text(bytes, lower(file.extension().string()), icebergs_stated);
    if (format && *format == FileFormat::ascii_grid)
      if (const auto length = ascii_grid_length(file); !length) return refuse(length.error());
    return format;
  }
  return refuse(
      "this program does not know what this file is; give NetCDF, GRIB, GeoTIFF, BAG, ESRI ASCII, XYZ, "
      "GeoJSON, "
      "KML, GeoPackage, a shapefile or the sightings of the International Ice Patrol");
}

}  // namespace floeplan::ingest
