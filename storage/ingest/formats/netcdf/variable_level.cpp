#include "storage/ingest/formats/netcdf/variable_level.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double ten_metres = 10.0;

bool is_decimal(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

/// A number in a text, the letters after it (its unit), and the words before and after.
struct Measure {
  double value{};
  std::string unit;
  std::string before;
  std::string behind;
};

std::string word_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && (is_letter(text[end]) || text[end] == '@')) ++end;
  return std::string{text.substr(at, end - at)};
}

/// All numbers with a unit in a text, in lower case; also "10-metre" and "2.5m".
std::vector<Measure> measures_in(const std::string& text) {
  std::vector<Measure> found;
  std::string before;
  for (std::size_t i = 0; i < text.size();) {
    if (!is_decimal(text[i])) {
      const std::string word = word_at(text, i);
      if (!word.empty()) before = word;
      i += std::max<std::size_t>(1, word.size());
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && (is_decimal(text[end]) || text[end] == '.')) ++end;
    Measure measure;
    measure.value = parse_number(text.substr(i, end - i)).value_or(NAN);
    measure.before = before;
    if (end < text.size() && (text[end] == ' ' || text[end] == '-')) ++end;
    measure.unit = word_at(text, end);
    end += measure.unit.size();
    while (end < text.size() && text[end] == ' ') ++end;
    measure.behind = word_at(text, end);
    before = measure.unit;
    i = end;
    found.push_back(std::move(measure));
  }
  return found;
}

bool is_metre(std::string_view unit) {
  return unit == "m" || unit == "metre" || unit == "metres" || unit == "meter" || unit == "meters";
}

bool is_pressure(std::string_view unit) {
  return unit == "hpa" || unit == "mb" || unit == "mbar" || unit == "millibar" || unit == "millibars" ||
         unit == "pa";
}

std::string words_for(const Measure& measure) {
  const std::string unit = is_metre(measure.unit)      ? " m"
                           : measure.unit == "pa"      ? " Pa"
                           : is_pressure(measure.unit) ? " hPa"
                                                       : "";
  return (unit.empty() ? "level " : "") + number(measure.value) + unit;
}

WindLevel wind_level(const Measure& measure) {
  return {!is_pressure(measure.unit) && measure.value == ten_metres, words_for(measure)};
}

/// Whether the name is only a component and a level: "u100", "100u", "ua850", "u100m".
bool is_component_at_level(std::string_view part) {
  const auto front = std::ranges::find_if(part, is_decimal);
  const auto back = std::find_if(front, part.end(), [](char c) { return !is_decimal(c); });
  const std::string_view head{part.begin(), front};
  const std::string_view tail{back, part.end()};
  const auto is_component = [](std::string_view letters) {
    return letters == "u" || letters == "v" || letters == "ua" || letters == "va";
  };
  return front != back &&
         ((is_component(head) && (tail.empty() || tail == "n")) || (head.empty() && is_component(tail)));
}

std::optional<WindLevel> wind_level_in_name(const std::string& name) {
  for (const std::string& part : parts_of_name(name)) {
    const std::vector<Measure> measures = measures_in(part);
    if (measures.size() != 1) continue;
    const Measure& measure = measures.front();
    const bool stated = is_metre(measure.unit) || is_pressure(measure.unit) || measure.unit == "maboveground";
    if (stated || is_component_at_level(part)) return wind_level(measure);
  }
  return std::nullopt;
}

/// The level in the attributes that cfgrib and other converters add; empty near the ground, where names tell
/// the level.
std::optional<WindLevel> wind_level_of_grib(const NetcdfVariable& variable) {
  const std::string type = lower(variable.attribute("GRIB_typeOfLevel"));
  if (type.empty() || type == "heightaboveground" || type == "heightabovesea" || type == "surface" ||
      type == "meansea" || type == "unknown")
    return std::nullopt;
  return WindLevel{false, "a level of the type " + variable.attribute("GRIB_typeOfLevel")};
}

}  // namespace

std::optional<double> depth_in_words(const NetcdfVariable& variable) {
  for (const std::string& part : parts_of_name(variable.name())) {
    const std::vector<Measure> measures = measures_in(part);
    const bool whole = !part.empty() && is_decimal(part.front()) && measures.size() == 1;
    if (whole && is_metre(measures.front().unit)) return measures.front().value;
  }
  for (const Measure& measure : measures_in(lower(variable.attribute("long_name"))))
    if (is_metre(measure.unit) && (measure.before == "at" || measure.before == "@" ||
                                   measure.behind == "depth" || measure.behind == "below"))
      return measure.value;
  return std::nullopt;
}

std::optional<WindLevel> wind_level_in_words(const NetcdfVariable& variable) {
  if (auto level = wind_level_of_grib(variable)) return level;
  if (auto level = wind_level_in_name(variable.name())) return level;
  std::optional<WindLevel> found;
  for (const Measure& measure : measures_in(lower(variable.attribute("long_name")))) {
    if (!is_metre(measure.unit) && !is_pressure(measure.unit)) continue;
    if (!found || !found->at_10_m) found = wind_level(measure);
  }
  return found;
}

}  // namespace floeplan::ingest
