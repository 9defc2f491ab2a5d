#include "storage/ingest/format_of.hpp"

#include <algorithm>

#include "engine/core/utf8_text.hpp"
#include "storage/ingest/data_formats.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/foreign_formats.hpp"
#include "storage/ingest/formats/slocum/slocum_bytes.hpp"
#include "storage/ingest/formats/slocum/slocum_header.hpp"
#include "storage/ingest/notation/delimited_text.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/xml/xml_document.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t head_bytes = 65536;

/// Null where no format is.
const DataFormat* find_format(Writing writing, const FileStart& start) {
  const auto found = std::ranges::find_if(data_formats(), [&](const DataFormat& format) {
    return format.writing == writing && format.is_it(start);
  });
  return found == data_formats().end() ? nullptr : &*found;
}

bool is_text(std::string_view head) {
  return std::none_of(head.begin(), head.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 9 || (byte > 13 && byte < 32 && byte != 27);
  });
}

/// Why a text is refused that is of no format of this program.
std::string unknown_text(const FileStart& start, const std::string& extension) {
  const std::string line = trimmed(start.first_line());
  if (!contains_any(line, {"[", "<"}) && csv_fields(line).size() >= 3)
    return "this is a table with the columns " + enumeration(csv_fields(line)) +
           ", which this program does not know; of icebergs it reads the tables of the International Ice "
           "Patrol, the US National Ice Center, Brigham Young University and the Canadian Ice Service's "
           "beacons, and others with the columns id, lat, lon and time (with --kind icebergs whatever else "
           "they hold); of depths those with lon, "
           "lat and depth or elevation; name the columns so, or convert the table to GeoJSON";
  if (extension == ".nc" || extension == ".cdf" || extension == ".nc4")
    return "the file is named like NetCDF but holds text (\"" + line.substr(0, 60) +
           "\"); probably the download returned a message instead of data; read it and download again";
  return "this is a text of a kind that this program does not know; give NetCDF, GeoTIFF, ESRI ASCII, XYZ, "
         "GeoJSON, KML or the sightings of the International Ice Patrol";
}

Checked<const DataFormat*> format_of_text(FileStart start, const std::string& extension) {
  if (start.bytes.starts_with("\xEF\xBB\xBF")) start.bytes.remove_prefix(3);
  if (trimmed(start.bytes.substr(0, 64)).starts_with("{")) {
    if (const DataFormat* const format = find_format(Writing::json, start)) return format;
    return refuse(
        "this is JSON, but not GeoJSON; the places in it have no agreed meaning; convert it to a GeoJSON "
        "FeatureCollection in longitude and latitude");
  }
  for (const Writing writing : {Writing::xml, Writing::text})
    if (const DataFormat* const format = find_format(writing, start)) return format;
  return refuse(unknown_text(start, extension));
}

Checked<const DataFormat*> format_of_compressed_slocum(const std::filesystem::path& file) {
  const std::string head = slocum_bytes(file, head_bytes).bytes;
  const DataFormat* const format = find_format(Writing::binary, {.bytes = head});
  if (format != nullptr && format->together == Together::glider_log) return format;
  if (auto foreign = refusal_of_foreign(head); !foreign.empty()) return refuse(std::move(foreign));
  return refuse(damaged_slocum_log("its first compressed block cannot be unpacked"));
}

Checked<const DataFormat*> format_of_bytes(const std::filesystem::path& file, bool icebergs_stated) {
  const std::string head = first_bytes(file, head_bytes);
  if (head.empty())
    return refuse(
        "the file is empty or cannot be read; the download or copy failed; copy or download it again");
  const std::string_view bytes = head;
  const FileStart start{.bytes = bytes, .icebergs_stated = icebergs_stated};
  if (const DataFormat* const format = find_format(Writing::binary, start)) return format;
  if (is_compressed_slocum(bytes)) return format_of_compressed_slocum(file);
  if (auto foreign = refusal_of_foreign(bytes); !foreign.empty()) return refuse(std::move(foreign));
  const std::string text = core::utf8_text(bytes);
  if (text != bytes && !bytes.starts_with("\xEF\xBB\xBF")) {
    if (const DataFormat* const format = find_format(Writing::xml, {.bytes = text})) return format;
    return refuse("this is a text in UTF-16, of which this program reads KML alone; save it in UTF-8");
  }
  if (is_text(bytes)) return format_of_text(start, lower(file.extension().string()));
  return refuse(
      "this program does not know what this file is; give NetCDF, GRIB, GeoTIFF, BAG, ESRI ASCII, XYZ, "
      "GeoJSON, "
      "KML, GeoPackage, a shapefile or the sightings of the International Ice Patrol");
}

Checked<const DataFormat*> format_of_folder(const std::filesystem::path& folder) {
  if (const DataFormat* const format = find_format(Writing::folder, {.folder = folder})) return format;
  return refuse("this is a folder, not a file; name the files in it one by one");
}

}  // namespace

Checked<const DataFormat*> format_of(const std::filesystem::path& file, bool icebergs_stated) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  const bool is_folder = std::filesystem::is_directory(status);
  if (!is_folder && !std::filesystem::is_regular_file(status))
    return refuse("there is no such file; check its name and its folder");
  auto format = is_folder ? format_of_folder(file) : format_of_bytes(file, icebergs_stated);
  if (format && (*format)->check != nullptr)
    if (const auto checked = (*format)->check(file); !checked) return refuse(checked.error());
  return format;
}

}  // namespace floeplan::ingest
