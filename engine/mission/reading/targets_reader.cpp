#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "engine/core/letter_case.hpp"
#include "engine/messages/mission_file_messages.hpp"
#include "engine/messages/seaglider_file_messages.hpp"
#include "engine/mission/document/line_words.hpp"
#include "engine/mission/document/list_rules.hpp"
#include "engine/mission/document/packed_degrees.hpp"
#include "engine/mission/reading/seaglider_lines.hpp"
#include "engine/mission/reading/seaglider_readers.hpp"

namespace floeplan::mission {
namespace {

constexpr std::size_t max_targets = 1000;  // the same limit as for rows of a goto list

struct Target {
  std::map<std::string, std::string_view, std::less<>> fields;
  std::optional<WaypointRow> place;
  int line{};
};
using Targets = std::map<std::string, Target, std::less<>>;

bool is_known(std::string_view field) {
  static constexpr std::array plain{"lat",   "lon",    "radius", "goto", "head",
                                    "depth", "finish", "dives",  "exec"};
  static constexpr std::array families{"timeout", "src", "escape", "slow-progress", "fence"};
  return std::ranges::find(plain, field) != plain.end() ||
         std::ranges::any_of(families, [&](std::string_view family) {
           return field == family ||
                  (field.starts_with(family) && field.substr(family.size()).starts_with('-'));
         });
}

bool is_number_field(std::string_view field) {
  static constexpr std::array numbers{"lat",    "lon",   "radius",    "head",      "depth",
                                      "finish", "dives", "fence-lat", "fence-lon", "fence-radius"};
  return std::ranges::find(numbers, field) != numbers.end();
}

bool names_target(std::string_view field) { return field == "goto" || field.ends_with("-goto"); }

void read_field(std::string_view word, Target& target, Document& document) {
  const auto fault = [&](const messages::Message& message) { report(document, target.line, message); };
  const auto parts = SeagliderLine::field(word);
  if (!parts) return fault(messages::seaglider_file_message<"malformed_field">());
  const std::string field = core::lower_case(parts->first);
  if (!target.fields.emplace(field, parts->second).second)
    return fault(messages::seaglider_file_message<"field_twice">(field));
  if (!is_known(field)) fault(messages::seaglider_file_message<"unknown_field/target">(field));
  if (is_number_field(field) && !parse_number(parts->second))
    fault(messages::seaglider_file_message<"value_not_a_number/target">(field));
}

double number_in(const Target& target, std::string_view field) {
  const auto found = target.fields.find(field);
  return found == target.fields.end() ? 0.0 : parse_number(found->second).value_or(0.0);
}

/// Reads the place of a target from lat and lon in packed degrees and minutes.
void read_place(Target& target, Document& document) {
  const UnpackedAngle lat = unpack_degrees(number_in(target, "lat"));
  const UnpackedAngle lon = unpack_degrees(number_in(target, "lon"));
  if (lat.sixty_minutes || lon.sixty_minutes)
    report(document, target.line, messages::mission_file_message<"minutes_60_or_more">());
  if (std::abs(lat.degrees) > 90.0 || std::abs(lon.degrees) > 180.0)
    report(document, target.line, messages::seaglider_file_message<"out_of_range/target">());
  target.place = WaypointRow{std::string{target.fields.find("lon")->second},
                             std::string{target.fields.find("lat")->second},
                             {lon.degrees, lat.degrees},
                             target.line};
}

void check_target(const std::string& name, Target& target, Document& document) {
  const auto has = [&](std::string_view field) { return target.fields.contains(field); };
  const bool by_place = has("lat") && has("lon") && has("radius");
  if (!has("goto") || !(by_place || has("head"))) {
    report(document, target.line, messages::seaglider_file_message<"fields_missing">(name));
  } else if (by_place) {
    read_place(target, document);
    if (!(number_in(target, "radius") > 0.0))
      report(document, target.line, messages::seaglider_file_message<"bad_radius">());
  }
  if (has("head") && !(number_in(target, "head") >= 0.0 && number_in(target, "head") <= 360.0))
    report(document, target.line, messages::seaglider_file_message<"out_of_range/heading">());
}

void check_names(const Targets& targets, Document& document) {
  for (const auto& [name, target] : targets) {
    for (const auto& [field, value] : target.fields) {
      if (names_target(field) && !targets.contains(value))
        report(document, target.line, messages::seaglider_file_message<"unknown_target">(field, value));
    }
  }
}

Targets::const_iterator next_of(const Targets& targets, Targets::const_iterator at) {
  return targets.find(at->second.fields.find("goto")->second);
}

/// Follows the targets from one to the next until one repeats.
void follow(const Targets& targets, std::string_view first, Document& document) {
  std::set<std::string_view> visited;
  std::string_view last;
  for (auto at = targets.find(first); at != targets.end(); last = at->first, at = next_of(targets, at)) {
    if (!visited.insert(at->first).second) {
      if (at->first != last)
        report(document, at->second.line,
               messages::seaglider_file_message<"targets_go_round">(last, at->first));
      break;
    }
    if (!at->second.place) {
      report(document, at->second.line, messages::seaglider_file_message<"target_without_place">(at->first));
      break;
    }
    document.waypoints.push_back(*at->second.place);
  }
  for (const auto& [name, target] : targets) {
    if (!visited.contains(name))
      report(document, target.line, messages::seaglider_file_message<"target_off_the_way">(name));
  }
}

}  // namespace

void read_targets(const FileText& text, Document& document) {
  Targets targets;
  std::string_view first;
  for (const SeagliderLine& line : seaglider_lines(text, document)) {
    if (targets.size() == max_targets) {
      report(document, line.number,
             messages::seaglider_file_message<"too_many_waypoints/targets">(max_targets));
      return;
    }
    Target target;
    target.line = line.number;
    for (std::size_t i = 1; i < line.words.size(); ++i) read_field(line.words[i], target, document);
    const std::string name{line.words.front()};
    if (name.find('=') != std::string::npos)
      report(document, line.number, messages::seaglider_file_message<"no_name">());
    check_target(name, target, document);
    if (!targets.emplace(name, target).second)
      report(document, line.number, messages::seaglider_file_message<"target_twice">(name));
    if (first.empty()) first = line.words.front();
  }
  if (targets.empty()) report(document, 0, messages::seaglider_file_message<"no_target">());
  check_names(targets, document);
  if (document.verdict() == Verdict::reject) return;
  follow(targets, first, document);
  check_decimal_look(document.waypoints, document.messages);
}

}  // namespace floeplan::mission
