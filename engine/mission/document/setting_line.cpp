#include "engine/mission/document/setting_line.hpp"

#include <algorithm>
#include <cmath>

#include "engine/messages/mission_file_messages.hpp"
#include "engine/mission/document/line_words.hpp"
#include "engine/mission/document/packed_degrees.hpp"

namespace floeplan::mission {
namespace {

constexpr std::size_t max_unit_length = 32;
constexpr std::size_t max_quote_length = 40;

std::string quoted(std::string_view text) {
  const bool cut = text.size() > max_quote_length;
  return '"' + std::string{text.substr(0, max_quote_length)} + (cut ? "...\"" : "\"");
}

/// The parts of a setting, not checked yet.
struct Parts {
  std::string_view name;
  std::string_view unit;
  std::vector<std::string_view> values;
};

std::optional<Parts> cut_with_unit(std::string_view text, std::size_t open, int line, Messages& messages) {
  const std::size_t close = text.find(')', open);
  if (close == std::string_view::npos) return std::nullopt;
  const auto names = words_of(text.substr(0, open));
  const auto units = words_of(text.substr(open + 1, close - open - 1));
  if (names.size() != 1 || units.size() > 1) return std::nullopt;
  if (!text.substr(0, open).ends_with(names.front())) {
    messages.push_back(finding(line, messages::mission_file_message<"blank_before_unit">(names.front())));
  }
  return Parts{names.front(), units.empty() ? std::string_view{} : units.front(),
               words_of(text.substr(close + 1))};
}

/// Splits `name value` without a unit: accepted, but against the grammar.
std::optional<Parts> cut_without_unit(std::string_view text, int line, Messages& messages) {
  auto words = words_of(text);
  if (words.empty()) return std::nullopt;
  messages.push_back(finding(
      line, messages::mission_file_message<"unit_missing">(words.front().substr(0, max_quote_length))));
  const std::string_view name = words.front();
  words.erase(words.begin());
  return Parts{name, {}, std::move(words)};
}

}  // namespace

std::optional<Argument> read_setting(std::string_view text, int line, Messages& messages) {
  const auto fail = [&](const messages::Message& fault) {
    messages.push_back(finding(line, fault));
    return std::nullopt;
  };
  const std::size_t open = text.find('(');
  const auto parts = open == std::string_view::npos ? cut_without_unit(text, line, messages)
                                                    : cut_with_unit(text, open, line, messages);
  if (!parts || !is_name(parts->name) || parts->unit.size() > max_unit_length) {
    return fail(messages::mission_file_message<"malformed_setting">(quoted(text)));
  }
  const std::string name{parts->name};
  if (parts->values.empty()) return fail(messages::mission_file_message<"value_missing">(name));
  const auto value = parse_number(parts->values.front());
  if (!value) {
    return fail(messages::mission_file_message<"value_not_a_number">(name, quoted(parts->values.front())));
  }
  if (parts->values.size() > 1) {
    messages.push_back(finding(line, messages::mission_file_message<"extra_tokens/value">(name)));
  }
  return Argument{name, name, std::string{parts->unit}, std::string{parts->values.front()}, *value, line};
}

geo::LonLat read_packed_place(double lon_packed, double lat_packed, int line, Messages& messages) {
  const UnpackedAngle lon = unpack_degrees(lon_packed);
  const UnpackedAngle lat = unpack_degrees(lat_packed);
  if (lon.sixty_minutes || lat.sixty_minutes) {
    messages.push_back(finding(line, messages::mission_file_message<"minutes_60_or_more">()));
  }
  if (std::abs(lat.degrees) > 90.0) {
    messages.push_back(finding(line, messages::mission_file_message<"out_of_range/latitude">()));
  } else if (std::abs(lon.degrees) > 180.0) {
    messages.push_back(finding(line, messages::mission_file_message<"out_of_range/longitude">()));
  }
  return {lon.degrees, lat.degrees};
}

std::optional<WaypointRow> read_waypoint_row(std::string_view text, int line, Messages& messages) {
  const auto words = words_of(text);
  const auto lon = words.empty() ? std::nullopt : parse_number(words[0]);
  const auto lat = words.size() < 2 ? std::nullopt : parse_number(words[1]);
  if (!lon || !lat) {
    messages.push_back(finding(line, messages::mission_file_message<"bad_waypoint_row">(quoted(text))));
    return std::nullopt;
  }
  if (words.size() > 2) {
    messages.push_back(finding(line, messages::mission_file_message<"extra_tokens_in_waypoint_row">()));
  }
  return WaypointRow{std::string{words[0]}, std::string{words[1]},
                     read_packed_place(*lon, *lat, line, messages), line};
}

}  // namespace floeplan::mission
