#include "engine/mission/seaglider_targets.hpp"

#include <cmath>
#include <map>
#include <stdexcept>

#include "engine/mission/argument_lines.hpp"
#include "engine/mission/file_text.hpp"
#include "engine/mission/line_words.hpp"
#include "engine/mission/packed_degrees.hpp"

namespace floeplan::mission {
namespace {

struct Target {
  std::optional<double> lat_deg;
  std::optional<double> lon_deg;
  std::string next;
  int line{};
};

std::string at_line(int line) { return "line " + std::to_string(line); }

std::string target_name(std::size_t index) { return "WP" + std::to_string(index); }

/// A targets file begins its comments with '/'.
std::string comments(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '#' && (i == 0 || text[i - 1] == '\n')) text[i] = '/';
  }
  return text;
}

/// `lat=4807.50` and so on; unknown fields are passed over.
void read_field(std::string_view word, Target& target, core::Violations& faults) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos) {
    faults.push_back({at_line(target.line), "\"" + std::string{word} + "\" is not FIELD=VALUE"});
    return;
  }
  const std::string field = lower_case(word.substr(0, equals));
  const std::string_view value = word.substr(equals + 1);
  if (field == "goto") target.next = value;
  if (field != "lat" && field != "lon") return;
  const auto packed = parse_number(value);
  const double degrees = packed ? unpack_degrees(*packed).degrees : 0.0;
  if (!packed || std::abs(degrees) > (field == "lat" ? 90.0 : 180.0)) {
    faults.push_back(
        {at_line(target.line), field + " is no angle as DDMM.MMMM: \"" + std::string{value} + "\""});
    return;
  }
  (field == "lat" ? target.lat_deg : target.lon_deg) = degrees;
}

}  // namespace

MissionFile write_targets(const planning::Plan& plan, core::Metres radius, const FileOrigin& origin) {
  if (plan.waypoints.size() < 2) throw std::invalid_argument{"write_targets: a plan has a start and a goal"};
  std::string text = comments(origin_comments(plan, origin));
  const std::size_t last = plan.waypoints.size() - 1;
  for (std::size_t i = 1; i <= last; ++i) {
    const geo::LonLat place = plan.waypoints[i].place;
    text += target_name(i) + " lat=" + packed_degrees(place.lat_deg) +
            " lon=" + packed_degrees(geo::wrap_longitude(place.lon_deg)) + " radius=" + whole(radius.value) +
            " goto=" + target_name(std::min(i + 1, last)) + "\n";
  }
  return {"targets", text};
}

tl::expected<std::vector<geo::LonLat>, core::Violations> read_targets(std::string_view text) {
  const auto decoded = decode_file(text);
  if (!decoded)
    return tl::unexpected(core::Violations{{at_line(decoded.error().line), decoded.error().text}});

  core::Violations faults;
  std::map<std::string, Target, std::less<>> targets;
  std::string first;
  for (std::size_t i = 0; i < decoded->lines.size(); ++i) {
    const auto words = words_of(decoded->lines[i]);
    if (words.empty() || words.front().starts_with('/')) continue;
    Target target;
    target.line = static_cast<int>(i) + 1;
    for (std::size_t k = 1; k < words.size(); ++k) read_field(words[k], target, faults);
    const auto [there, fresh] = targets.emplace(words.front(), target);
    if (!fresh) faults.push_back({at_line(target.line), "target " + there->first + " is there twice"});
    if (first.empty()) first = words.front();
  }
  if (targets.empty()) faults.push_back({"file", "holds no target"});

  std::vector<geo::LonLat> places;
  std::map<std::string, bool> visited;
  for (std::string name = first; faults.empty() && !visited[name];) {
    visited[name] = true;
    const auto target = targets.find(name);
    if (target == targets.end()) {
      faults.push_back({"file", "goto=" + name + " names no target"});
    } else if (!target->second.lat_deg || !target->second.lon_deg) {
      faults.push_back({at_line(target->second.line), "target " + name + " has no lat and lon"});
    } else {
      places.push_back({*target->second.lon_deg, *target->second.lat_deg});
      if (!target->second.next.empty()) name = target->second.next;
    }
  }
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  return places;
}

}  // namespace floeplan::mission
