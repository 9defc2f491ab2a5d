#include "storage/ingest/format_of.hpp"

#include <algorithm>

#include "engine/core/utf8_text.hpp"
#include "engine/messages/ingest_file_messages.hpp"
#include "engine/messages/ingest_track_messages.hpp"
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
messages::Message unknown_text(const FileStart& start, const std::string& extension) {
  const std::string line = trimmed(start.first_line());
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
