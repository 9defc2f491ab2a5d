#include "engine/mission/document/setting_line.hpp"

#include <algorithm>
#include <cmath>

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

/// A setting cut into its parts, none of them judged yet.
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
    messages.push_back({line, Severity::warning, "blank_before_unit",
                        "a blank between name and unit; write " + std::string{names.front()} + "(...)"});
  }
  return Parts{names.front(), units.empty() ? std::string_view{} : units.front(),
               words_of(text.substr(close + 1))};
}

/// `name value` without a unit: readable, but not what the grammar has.
std::optional<Parts> cut_without_unit(std::string_view text, int line, Messages& messages) {
  auto words = words_of(text);
  if (words.empty()) return std::nullopt;
  messages.push_back(
      {line, Severity::warning, "unit_missing",
       std::string{words.front().substr(0, max_quote_length)} + " has no unit in parentheses"});
  const std::string_view name = words.front();
  words.erase(words.begin());
  return Parts{name, {}, std::move(words)};
}

}  // namespace

std::optional<Argument> read_setting(std::string_view text, int line, Messages& messages) {
  const auto fail = [&](const char* code, const std::string& reason) {
    messages.push_back({line, Severity::error, code, reason});
    return std::nullopt;
  };
  const std::size_t open = text.find('(');
  const auto parts = open == std::string_view::npos ? cut_without_unit(text, line, messages)
                                                    : cut_with_unit(text, open, line, messages);
  if (!parts || !is_name(parts->name) || parts->unit.size() > max_unit_length) {
    return fail("malformed_setting", quoted(text) + " is not name(unit) value");
  }
  const std::string name{parts->name};
  if (parts->values.empty()) return fail("value_missing", name + " has no value");
  const auto value = parse_number(parts->values.front());
  if (!value) {
    return fail("value_not_a_number",
                "the value of " + name + " is " + quoted(parts->values.front()) + ", which is not a number");
  }
  if (parts->values.size() > 1) {
    messages.push_back({line, Severity::warning, "extra_tokens",
                        "words after the value of " + name + "; a comment begins with #"});
  }
  return Argument{name, name, std::string{parts->unit}, std::string{parts->values.front()}, *value, line};
}

geo::LonLat read_packed_place(double lon_packed, double lat_packed, int line, Messages& messages) {
  const UnpackedAngle lon = unpack_degrees(lon_packed);
  const UnpackedAngle lat = unpack_degrees(lat_packed);
  if (lon.sixty_minutes || lat.sixty_minutes) {
    messages.push_back({line, Severity::warning, "minutes_60_or_more",
                        "minutes of 60 or more; the value is defined, but a writer went wrong"});
  }
  if (std::abs(lat.degrees) > 90.0) {
    messages.push_back({line, Severity::error, "out_of_range",
                        "the latitude lies beyond 90 degrees; the longitude comes first, are the columns "
                        "swapped?"});
  } else if (std::abs(lon.degrees) > 180.0) {
    messages.push_back({line, Severity::error, "out_of_range",
                        "the longitude lies beyond 180 degrees; it is written as degrees and minutes, "
                        "DDDMM.MMMM, east positive"});
  }
  return {lon.degrees, lat.degrees};
}

std::optional<WaypointRow> read_waypoint_row(std::string_view text, int line, Messages& messages) {
  const auto words = words_of(text);
  const auto lon = words.empty() ? std::nullopt : parse_number(words[0]);
  const auto lat = words.size() < 2 ? std::nullopt : parse_number(words[1]);
  if (!lon || !lat) {
    messages.push_back(
        {line, Severity::error, "bad_waypoint_row",
         quoted(text) + " is not two numbers; a row is longitude and latitude as DDDMM.MMMM and DDMM.MMMM "
                        "between blanks, without commas and letters"});
    return std::nullopt;
  }
  if (words.size() > 2) {
    messages.push_back({line, Severity::warning, "extra_tokens_in_waypoint_row",
                        "words after the coordinates; a comment begins with #"});
  }
  return WaypointRow{std::string{words[0]}, std::string{words[1]},
                     read_packed_place(*lon, *lat, line, messages), line};
}

}  // namespace floeplan::mission
