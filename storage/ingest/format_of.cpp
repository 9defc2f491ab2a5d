#include "storage/ingest/format_of.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/core/utf8_text.hpp"
#include "engine/messages/ingest_file_messages.hpp"
#include "engine/messages/ingest_track_messages.hpp"
#include "engine/messages/message.hpp"
#include "storage/ingest/data_formats.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/formats/slocum/slocum_bytes.hpp"
#include "storage/ingest/formats/slocum/slocum_header.hpp"
#include "storage/ingest/notation/delimited_text.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/xml/xml_document.hpp"

namespace floeplan::ingest {
namespace {

std::uint32_t big_endian_at(std::string_view head, std::size_t offset) {
  std::uint32_t value = 0;
  for (const char byte : head.substr(offset, 4)) value = (value << 8) | static_cast<unsigned char>(byte);
  return value;
}

/// Recognises OTIS binary files by their first record, which begins with its length in bytes. A file of
/// constituents has nx, ny, the number of constituents, four limits and names of four letters; a grid file
/// nx, ny, four limits, a time step and a count.
/// Source  public readers of TPXO; not checked against a file of this format
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

/// Why a file is refused whose format this program knows but does not read; empty when it may be readable.
std::optional<messages::Message> refusal_of_foreign(std::string_view head) {
  if (head.find("BSB/") < 4096 || head.find("KNP/") < 4096)
    return messages::ingest_file_message<"raster-chart">();
  if (head.find("INT.IHO.S-101") != std::string_view::npos)
    return messages::ingest_file_message<"electronic-chart-not-read">();
  if (is_sensor_cache(head)) return messages::ingest_file_message<"lone-sensor-list">();
  if (is_otis_binary(head)) return messages::ingest_file_message<"tide-model-of-otis">();
  if (head.starts_with("PK\x03\x04") || head.starts_with("\x1f\x8b") || head.starts_with("BZh"))
    return messages::ingest_file_message<"archive-not-readable">();
  if (head.starts_with("%PDF") || head.starts_with("\x89PNG") || head.starts_with("\xff\xd8\xff"))
    return messages::ingest_file_message<"picture-or-document">();
  if (head.starts_with("SQLite format 3")) return messages::ingest_file_message<"other-database">();
  if (head.starts_with("CDF") || head.starts_with("\x89HDF") || head.starts_with("\x0e\x03\x13\x01"))
    return messages::ingest_file_message<"other-hdf">();
  return std::nullopt;
}

constexpr std::size_t head_bytes = 65536;

/// The format of a file that starts like this; null if no format recognises it.
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

/// The message for a text file that has no known format.
messages::Message unknown_text(const FileStart& start, const std::string& extension) {
  const std::string line = trimmed(start.first_line());
  if (names_water_properties(line) && DelimitedText{line}.columns().size() >= 2)
    return messages::ingest_file_message<"table-of-measurements">(enumeration(DelimitedText{line}.headers()));
  if (!contains_any(line, {"[", "<"}) && csv_fields(line).size() >= 3)
    return messages::ingest_file_message<"table-not-recognised">(enumeration(csv_fields(line)));
  if (extension == ".nc" || extension == ".cdf" || extension == ".nc4")
    return messages::ingest_file_message<"text-named-as-netcdf">(line.substr(0, 60));
  return messages::ingest_file_message<"text-not-recognised">();
}

Checked<const DataFormat*> format_of_text(FileStart start, const std::string& extension) {
  if (start.bytes.starts_with("\xEF\xBB\xBF")) start.bytes.remove_prefix(3);
  if (trimmed(start.bytes.substr(0, 64)).starts_with("{")) {
    if (const DataFormat* const format = find_format(Writing::json, start)) return format;
    return refuse(messages::ingest_file_message<"json-without-agreed-meaning">());
  }
  for (const Writing writing : {Writing::xml, Writing::text})
    if (const DataFormat* const format = find_format(writing, start)) return format;
  return refuse(unknown_text(start, extension));
}

Checked<const DataFormat*> format_of_compressed_slocum(const std::filesystem::path& file) {
  const std::string head = slocum_bytes(file, head_bytes).bytes;
  const DataFormat* const format = find_format(Writing::binary, {.bytes = head});
  if (format != nullptr && format->together == Together::glider_log) return format;
  if (auto foreign = refusal_of_foreign(head)) return refuse(std::move(*foreign));
  return refuse(
      messages::ingest_track_message<"binary-log-damaged">("its first compressed block cannot be unpacked"));
}

Checked<const DataFormat*> format_of_bytes(const std::filesystem::path& file, bool icebergs_stated) {
  const std::string head = first_bytes(file, head_bytes);
  if (head.empty()) return refuse(messages::ingest_file_message<"file-empty">());
  const std::string_view bytes = head;
  const FileStart start{.bytes = bytes, .icebergs_stated = icebergs_stated};
  if (const DataFormat* const format = find_format(Writing::binary, start)) return format;
  if (is_compressed_slocum(bytes)) return format_of_compressed_slocum(file);
  if (auto foreign = refusal_of_foreign(bytes)) return refuse(std::move(*foreign));
  const std::string text = core::utf8_text(bytes);
  if (text != bytes && !bytes.starts_with("\xEF\xBB\xBF")) {
    if (const DataFormat* const format = find_format(Writing::xml, {.bytes = text})) return format;
    return refuse(messages::ingest_file_message<"text-in-wide-characters">());
  }
  if (is_text(bytes)) return format_of_text(start, lower(file.extension().string()));
  return refuse(messages::ingest_file_message<"file-not-recognised">());
}

Checked<const DataFormat*> format_of_folder(const std::filesystem::path& folder) {
  if (const DataFormat* const format = find_format(Writing::folder, {.folder = folder})) return format;
  return refuse(messages::ingest_file_message<"folder-given">());
}

}  // namespace

Checked<const DataFormat*> format_of(const std::filesystem::path& file, bool icebergs_stated) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  const bool is_folder = std::filesystem::is_directory(status);
  if (!is_folder && !std::filesystem::is_regular_file(status))
    return refuse(messages::ingest_file_message<"file-missing">());
  auto format = is_folder ? format_of_folder(file) : format_of_bytes(file, icebergs_stated);
  if (format && (*format)->check != nullptr)
    if (const auto checked = (*format)->check(file); !checked) return refuse(checked.error());
  return format;
}

}  // namespace floeplan::ingest
