#include "storage/ingest/formats/slocum/slocum_log.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "engine/messages/ingest_track_messages.hpp"
#include "engine/simulation/logs/logged_positions.hpp"
#include "storage/ingest/common/fault_report.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/formats/slocum/slocum_bytes.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uintmax_t most_text_bytes = 128'000'000;
constexpr std::size_t most_tag_bytes = 16'384;

std::string tag(std::string_view head, std::string_view key) {
  while (!head.empty()) {
    const std::string_view line = head.substr(0, head.find('\n'));
    head.remove_prefix(std::min(line.size() + 1, head.size()));
    if (line.starts_with(key) && line.substr(key.size()).starts_with(':'))
      return trimmed(line.substr(key.size() + 1));
  }
  return {};
}

/// Removes the last hyphen and the part after it from `text`, and returns the part; without a hyphen, the
/// whole text.
std::string_view cut_last_part(std::string_view& text) {
  const std::size_t hyphen = text.rfind('-');
  const std::string_view part = hyphen == std::string_view::npos ? text : text.substr(hyphen + 1);
  text = hyphen == std::string_view::npos ? std::string_view{} : text.substr(0, hyphen);
  return part;
}

bool is_number(std::string_view text, std::size_t least_digits, std::size_t most_digits) {
  return text.size() >= least_digits && text.size() <= most_digits &&
         std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// The parts of "unit-7-2026-330-1-12": glider, year, day, mission of the day, segment. The glider's name may
/// contain hyphens. Empty for any other text.
SlocumName name_in(const std::string& full, const std::string& kind) {
  std::string_view glider = full;
  const std::string_view segment = cut_last_part(glider);
  const std::string_view mission{full.data(), glider.size()};
  const std::string_view of_day = cut_last_part(glider);
  const std::string_view day = cut_last_part(glider);
  const std::string_view year = cut_last_part(glider);
  if (glider.empty() || !is_number(year, 4, 4) || !is_number(day, 1, 3) || !is_number(of_day, 1, 4) ||
      !is_number(segment, 1, 5))
    return {};
  return {.glider = std::string{glider},
          .mission = std::string{mission} + "." + kind,
          .segment = std::stoi(std::string{segment})};
}

Messages reasons_of(const core::Violations& violations) {
  Messages faults;
  for (const auto& violation : violations)
    faults.push_back(
        messages::ingest_track_message<"log-unreadable">(trimmed(violation.field.substr(1)), violation.rule));
  return report_of(std::move(faults));
}

}  // namespace

SlocumName slocum_name_of(const std::filesystem::path& file) {
  const std::string head = slocum_bytes(file, most_tag_bytes).bytes;
  const SlocumName by_tags = name_in(tag(head, "full_filename"), tag(head, "filename_extension"));
  if (!by_tags.glider.empty()) return by_tags;
  const std::string name = file.filename().string();
  const std::size_t stop = std::min(name.find('.'), name.size());
  return name_in(name.substr(0, stop), name.substr(std::min(stop + 1, name.size())));
}

bool is_slocum_text(std::string_view head) {
  const std::string_view first = head.substr(0, head.find('\n'));
  if (first.starts_with("dbd_label:")) return contains_any(first, {"DBD_ASC"});
  return contains_any(head.substr(0, most_tag_bytes), {"m_present_time", "m_gps_lat"});
}

std::vector<std::string_view> slocum_columns() {
  std::vector<std::string_view> wanted = simulation::columns_that_tell_of_positions();
  wanted.insert(wanted.end(), slocum_sensors.begin(), slocum_sensors.end());
  return wanted;
}

Checked<SlocumLog> take_slocum_table(SlocumLog log, simulation::LogTable table,
                                     const std::function<void(const SlocumRow&)>& take) {
  const auto positions = simulation::settle_positions(table);
  if (!positions)
    return refuse(messages::ingest_track_message<"log-position-unreadable">(positions.error().field.substr(1),
                                                                            positions.error().rule));
  if (*positions)
    log.warnings.push_back(messages::ingest_track_message<"log-positions-settled">(**positions));
  std::array<const simulation::LogTable::Column*, slocum_sensors.size()> columns{};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    log.has[i] = table.has(std::string{slocum_sensors[i]});
    if (log.has[i]) columns[i] = &table[std::string{slocum_sensors[i]}];
  }
  for (std::size_t row = 0; row < table.rows(); ++row) {
    SlocumRow values;
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i] != nullptr) values.values[i] = (*columns[i])[row];
    take(values);
  }
  return log;
}

Checked<SlocumLog> read_slocum_text(const std::filesystem::path& file,
                                    const std::function<void(const SlocumRow&)>& take) {
  if (std::filesystem::file_size(file) > most_text_bytes)
    return refuse(messages::ingest_track_message<"log-too-long">());
  std::string text = first_bytes(file, most_text_bytes);
  SlocumLog log{.name = slocum_name_of(file)};
  if (!text.ends_with('\n')) {
    text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
    ++log.rows_refused;
    log.warnings.push_back(messages::ingest_track_message<"log-row-left-out">());
  }
  const auto wanted = slocum_columns();
  auto table = simulation::LogTable::read(text, wanted);
  if (!table) return refuse(reasons_of(table.error()));
  return take_slocum_table(std::move(log), std::move(*table), take);
}

}  // namespace floeplan::ingest
