#include <algorithm>
#include <map>

#include "engine/core/letter_case.hpp"
#include "engine/messages/seaglider_file_messages.hpp"
#include "engine/mission/document/line_words.hpp"
#include "engine/mission/reading/seaglider_lines.hpp"
#include "engine/mission/reading/seaglider_readers.hpp"

namespace floeplan::mission {
namespace {

using Fields = std::map<std::string, std::string_view, std::less<>>;

/// The fields of a band by name, from either form of line.
Fields fields_of(const SeagliderLine& line, Document& document) {
  Fields fields;
  const bool named = std::ranges::any_of(
      line.words, [](std::string_view word) { return word.find('=') != std::string_view::npos; });
  if (!named) {
    static constexpr std::array columns{"", "seconds", "sensors", "gc"};
    if (line.words.size() != columns.size())
      report(document, line.number, messages::seaglider_file_message<"malformed_band">());
    for (std::size_t i = 1; i < std::min(line.words.size(), columns.size()); ++i)
      fields.emplace(columns[i], line.words[i]);
    return fields;
  }
  for (std::size_t i = 1; i < line.words.size(); ++i) {
    const auto parts = SeagliderLine::field(line.words[i]);
    if (!parts) {
      report(document, line.number, messages::seaglider_file_message<"malformed_field">());
      continue;
    }
    const std::string name = core::lower_case(parts->first);
    if (!fields.emplace(name, parts->second).second)
      report(document, line.number, messages::seaglider_file_message<"field_twice">(name));
    if (name != "seconds" && name != "sensors" && name != "gc")
      report(document, line.number, messages::seaglider_file_message<"unknown_field/band">(name));
  }
  return fields;
}

double positive(const Fields& fields, const std::string& name, int line, Document& document) {
  const auto found = fields.find(name);
  const auto value = found == fields.end() ? std::nullopt : parse_number(found->second);
  if (!value || !(*value > 0.0)) report(document, line, messages::seaglider_file_message<"bad_band">(name));
  return value.value_or(0.0);
}

ScienceBand read_band(const SeagliderLine& line, Document& document) {
  ScienceBand band;
  band.line = line.number;
  if (core::lower_case(line.words.front()) != "loiter") {
    const auto depth = parse_number(line.words.front());
    if (!depth || !(*depth > 0.0))
      report(document, line.number, messages::seaglider_file_message<"bad_depth">());
    band.depth = core::Metres{depth.value_or(0.0)};
  }
  const Fields fields = fields_of(line, document);
  band.seconds = positive(fields, "seconds", line.number, document);
  band.guidance_seconds = positive(fields, "gc", line.number, document);
  const auto sensors = fields.find("sensors");
  if (sensors == fields.end() || !std::ranges::all_of(sensors->second, is_digit)) {
    report(document, line.number, messages::seaglider_file_message<"bad_sensors">());
  } else {
    band.sensors = sensors->second;
  }
  return band;
}

}  // namespace

void read_science(const FileText& text, Document& document) {
  for (const SeagliderLine& line : seaglider_lines(text, document))
    document.bands.push_back(read_band(line, document));
  if (document.bands.empty()) report(document, 0, messages::seaglider_file_message<"no_band">());

  std::optional<core::Metres> above;
  for (const ScienceBand& band : document.bands) {
    const ScienceBand& first = document.bands.front();
    if (band.sensors.size() != first.sensors.size())
      report(document, band.line, messages::seaglider_file_message<"sensor_count_differs">());
    if (!band.depth) continue;
    if (above && *band.depth <= *above)
      report(document, band.line, messages::seaglider_file_message<"depths_not_increasing">());
    above = band.depth;
  }
}

}  // namespace floeplan::mission
