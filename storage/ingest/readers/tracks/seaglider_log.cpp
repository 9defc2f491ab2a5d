#include "storage/ingest/readers/tracks/seaglider_log.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/geo/bearing.hpp"
#include "engine/messages/ingest_track_messages.hpp"
#include "engine/mission/document/packed_degrees.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double no_fix = 99.0;  // a dilution of precision that means no fix
/// The fixes of a dive are within hours of it. A receiver whose week counter has overflowed is wrong by
/// years.
constexpr core::Seconds longest_from_dive{86'400.0 * 30.0};
constexpr double metres_in_centimetre = 0.01;

/// The line without the percent sign that begins lines in the head of a record.
std::string_view plain(std::string_view line) { return line.starts_with('%') ? line.substr(1) : line; }

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return lines;
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

/// The time of a date and a time of day; empty if they are out of range.
std::optional<core::UtcTime> dive_moment(int year, double month, double day, double hour, double minute,
                                         double second) {
  const std::chrono::year_month_day date{std::chrono::year{year},
                                         std::chrono::month{static_cast<unsigned>(month)},
                                         std::chrono::day{static_cast<unsigned>(day)}};
  const bool is_time =
      hour >= 0.0 && hour < 24.0 && minute >= 0.0 && minute < 60.0 && second >= 0.0 && second < 61.0;
  if (!(month >= 1.0 && month <= 12.0 && day >= 1.0 && day <= 31.0) || !date.ok() || !is_time)
    return std::nullopt;
  return core::UtcTime{std::chrono::sys_days{date}.time_since_epoch()} +
         core::Seconds{3600.0 * hour + 60.0 * minute + second};
}

/// Start time from "5 4 116 20 33 7": month, day, years since 1900, hour, minute, second.
std::optional<core::UtcTime> start_of(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : words_between_blanks(text))
    if (const auto value = parse_number(word)) numbers.push_back(*value);
  constexpr double last_year = 200.0;  // 2100
  if (numbers.size() != 6 || !(numbers[2] >= 90.0 && numbers[2] <= last_year)) return std::nullopt;
  return dive_moment(1900 + static_cast<int>(numbers[2]), numbers[0], numbers[1], numbers[3], numbers[4],
                     numbers[5]);
}

/// Time from "040516" and "203244"; the seconds may be missing.
std::optional<core::UtcTime> time_of_fix(const std::string& date, const std::string& time) {
  const auto part = [](const std::string& digits, std::size_t at) {
    return parse_number(std::string_view{digits}.substr(at, 2)).value_or(-1.0);
  };
  const bool are_digits = std::ranges::all_of(date, is_digit) && std::ranges::all_of(time, is_digit);
  if (!are_digits || date.size() != 6 || (time.size() != 4 && time.size() != 6)) return std::nullopt;
  return dive_moment(2000 + static_cast<int>(part(date, 4)), part(date, 2), part(date, 0), part(time, 0),
                     part(time, 2), time.size() == 6 ? part(time, 4) : 0.0);
}

/// The fix in a line such as "$GPS2,040516,203244,7017.119,838.198,20,1.3,20,1.1".
std::optional<SeagliderFix> fix_in(const std::vector<std::string>& fields, core::UtcTime start) {
  constexpr std::size_t dilution_field = 6;
  if (fields.size() <= dilution_field) return std::nullopt;
  const auto time = time_of_fix(fields[1], fields[2]);
  const auto lat = parse_number(fields[3]);
  const auto lon = parse_number(fields[4]);
  const auto dilution = parse_number(fields[dilution_field]);
  if (!time || !lat || !lon || !dilution || *dilution >= no_fix) return std::nullopt;
  if (std::chrono::abs(*time - start) > longest_from_dive) return std::nullopt;
  const auto place = mission::unpack_place(*lon, *lat);
  if (!place || *place == geo::LonLat{0.0, 0.0}) return std::nullopt;
  return SeagliderFix{*time, *place};
}

/// The current in a line such as "$CURRENT,0.138, 12.9,1".
std::optional<geo::VelocityEn> current_in(const std::vector<std::string>& fields) {
  if (fields.size() < 4 || parse_number(fields[3]) != 1.0) return std::nullopt;
  const auto speed_m_s = parse_number(fields[1]);
  const auto towards_deg = parse_number(fields[2]);
  if (!speed_m_s || !towards_deg || *speed_m_s < 0.0) return std::nullopt;
  const geo::Bearing towards = geo::Bearing::degrees(*towards_deg);
  return geo::VelocityEn{{*speed_m_s * towards.east()}, {*speed_m_s * towards.north()}};
}

}  // namespace

bool is_seaglider_log(std::string_view head) {
  return head.starts_with("version:") && contains_any(head, {"\nglider:"}) && contains_any(head, {"\ndive:"});
}

bool is_seaglider_record(std::string_view head) {
  return head.starts_with("%version:") && contains_any(head, {"\n%glider:"}) &&
         contains_any(head, {"\n%columns:"});
}

Checked<SeagliderDive> seaglider_dive_of(std::string_view text) {
  std::map<std::string, std::string> head;
  for (const std::string& line : lines_of(text.substr(0, 4096))) {
    const std::string_view words = plain(line);
    if (words.starts_with("data:")) break;
    const std::size_t colon = words.find(':');
    if (colon != std::string_view::npos)
      head[std::string{words.substr(0, colon)}] = trimmed(words.substr(colon + 1));
  }
  const auto dive = parse_number(head["dive"]);
  const auto start = start_of(head["start"]);
  if (head["glider"].empty() || !dive || !start || !(*dive >= 0.0 && *dive < 1e6))
    return refuse(messages::ingest_track_message<"seaglider-head-incomplete">());
  return SeagliderDive{.glider = "sg" + head["glider"],
                       .mission = "sg" + head["glider"] + " mission " + head["mission"],
                       .dive = static_cast<int>(*dive),
                       .start = *start};
}

Checked<SeagliderLog> read_seaglider_log(std::string_view text) {
  auto dive = seaglider_dive_of(text);
  if (!dive) return refuse(dive.error());
  SeagliderLog log{.dive = std::move(*dive)};
  for (const std::string& line : lines_of(text)) {
    const std::vector<std::string> fields = fields_of(line);
    const auto take = [&](std::optional<SeagliderFix>& fix) {
      fix = fix_in(fields, log.dive.start);
      if (!fix) ++log.fixes_left_out;
    };
    if (fields[0] == "$GPS1") take(log.before);
    if (fields[0] == "$GPS2") take(log.dived);
    if (fields[0] == "$GPS") take(log.surfaced);
    if (fields[0] == "$CURRENT") log.current = current_in(fields);
  }
  return log;
}

Checked<std::vector<SeagliderDepth>> read_seaglider_record(std::string_view text) {
  const auto dive = seaglider_dive_of(text);
  if (!dive) return refuse(dive.error());
  std::vector<SeagliderDepth> depths;
  std::vector<std::string> columns;
  bool data = false;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("%columns:")) columns = fields_of(std::string_view{line}.substr(9));
    if (line.starts_with('%')) {
      data = data || line.starts_with("%data:");
      continue;
    }
    const auto time_at = static_cast<std::size_t>(std::ranges::find(columns, "elaps_t") - columns.begin());
    const auto depth_at = static_cast<std::size_t>(std::ranges::find(columns, "depth") - columns.begin());
    if (!data || time_at == columns.size() || depth_at == columns.size())
      return refuse(messages::ingest_track_message<"seaglider-columns-missing">());
    const std::vector<std::string> words = words_between_blanks(line);
    if (words.size() != columns.size()) continue;
    const auto elapsed_s = parse_number(words[time_at]);
    const auto depth_cm = parse_number(words[depth_at]);
    if (elapsed_s && depth_cm)
      depths.push_back({dive->start + core::Seconds{*elapsed_s}, {metres_in_centimetre * *depth_cm}});
  }
  if (columns.empty()) return refuse(messages::ingest_track_message<"seaglider-columns-missing">());
  return depths;
}

}  // namespace floeplan::ingest
