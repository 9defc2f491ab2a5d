#include "engine/mission/writing/seaglider_files.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "engine/core/letter_case.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/mission/document/line_words.hpp"
#include "engine/mission/document/packed_degrees.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/argument_lines.hpp"
#include "engine/mission/writing/below_ice.hpp"
#include "engine/mission/writing/goto_lists.hpp"
#include "engine/mission/writing/hold_lists.hpp"

namespace floeplan::mission {
namespace {

constexpr double deepest_dive_m = 1100.0;  // $D_TGT
constexpr double shortest_dive_min = 5.0;  // $T_DIVE
constexpr double longest_dive_min = 2880.0;

std::string target_name(std::size_t index) { return "WP" + std::to_string(index); }

/// Changes comment lines to begin with '/', as in files of a Seaglider.
std::string comments(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '#' && (i == 0 || text[i - 1] == '\n')) text[i] = '/';
  }
  return text;
}

double dive_depth_m(const vehicle::GliderProfile& vehicle) { return std::ceil(vehicle.dive_depth.value); }

/// Duration of a dive and climb in minutes.
double dive_minutes(const vehicle::GliderProfile& vehicle) {
  const double rate_m_s = vehicle.vertical_speed(vehicle.speed_through_water).value;
  return std::ceil(2.0 * dive_depth_m(vehicle) / rate_m_s / 60.0);
}

/// Seconds without needless decimals.
std::string seconds_text(double seconds) {
  return seconds == std::floor(seconds) ? whole(seconds) : decimal(seconds, 1);
}

std::string science_text(const SeagliderOptions& options, const std::string& header) {
  std::string text = header;
  for (const ScienceBand& band : options.bands) {
    text += (band.depth ? seconds_text(band.depth->value) : "loiter") +
            " seconds=" + seconds_text(band.seconds) + " sensors=" + band.sensors +
            " gc=" + seconds_text(band.guidance_seconds) + "\n";
  }
  return text;
}

/// Writes the bands as text, reads this text with the strict reader of `check`, and adds its faults.
void check_bands(const SeagliderOptions& options, core::Violations& found) {
  if (options.bands.empty()) return;
  const Document science = read_document("science", science_text(options, ""));
  for (const Message& message : science.messages) {
    if (message.severity == Severity::note) continue;
    found.push_back(messages::mission_fault<"science-band-refused">(
        "/science/" + std::to_string(message.line - 1), message.text));
  }
}

core::Violations violations_of(const planning::Plan& plan, const SeagliderOptions& options) {
  core::Violations found;
  if (plan.waypoints.size() < 2) found.push_back(messages::mission_fault<"no-start-and-goal">("/waypoints"));
  if (dive_depth_m(options.vehicle) > deepest_dive_m)
    found.push_back(messages::mission_fault<"too-deep-for-seaglider">("/dive_depth_m"));
  const double minutes = dive_minutes(options.vehicle);
  if (!(minutes >= shortest_dive_min && minutes <= longest_dive_min))
    found.push_back(messages::mission_fault<"dives-of-wrong-length">("/dive_depth_m", minutes));
  if (const auto closed = closed_to_seagliders(plan)) found.push_back(*closed);
  check_bands(options, found);
  return found;
}

/// The warning if the sea bed lies above $D_TGT, the depth at which the vehicle turns by itself.
std::optional<messages::Message> shoal_warning(const planning::Plan& plan, const SeagliderOptions& options) {
  const auto shoal = shoalest_of(plan, options.shoals);
  const core::Metres margin = options.vehicle.altimeter_margin;
  const double dive_m = dive_depth_m(options.vehicle);
  if (!shoal || shoal->bed >= core::Metres{dive_m} + margin) return std::nullopt;
  return messages::export_message<"seaglider-over-shoal">(
             dive_m, std::floor(shoal->bed.value), place_text(shoal->place), shoal->waypoint,
             std::floor(std::max(0.0, (shoal->bed - margin).value)))
      .at(shoal->place);
}

}  // namespace

std::optional<core::Violation> closed_to_seagliders(const planning::Plan& plan) {
  if (least_upper_turn(plan).value <= 0.0 && tells_upper_turns(plan)) return std::nullopt;
  return messages::mission_fault<"seaglider-below-ice">("/format");
}

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

tl::expected<MissionFiles, core::Violations> write_seaglider_set(const planning::Plan& plan,
                                                                 const SeagliderOptions& options) {
  if (core::Violations found = violations_of(plan, options); !found.empty())
    return tl::unexpected(std::move(found));

  const std::string header = comments(origin_comments(plan, options.origin));
  MissionFiles set;
  set.files.push_back(write_targets(plan, default_waypoint_radius(plan), options.origin));
  if (!options.bands.empty()) set.files.push_back({"science", science_text(options, header)});
  set.files.push_back({"cmdfile", header + "$D_TGT," + whole(dive_depth_m(options.vehicle)) + "\n$T_DIVE," +
                                      whole(dive_minutes(options.vehicle)) + "\n$GO\n"});
  set.messages.push_back(messages::export_message<"seaglider-limits-on-board">(plan.vehicle));
  if (auto shoal = shoal_warning(plan, options)) set.messages.push_back(std::move(*shoal));
  if (options.bands.empty()) set.messages.push_back(messages::export_message<"no-science-file">());
  std::ranges::move(messages_without_holds(plan, "seaglider"), std::back_inserter(set.messages));
  return set;
}

std::optional<ScienceBand> parse_science_band(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(':'); end != std::string_view::npos; end = text.find(':')) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  if (parts.size() != 4) return std::nullopt;
  const auto depth = parse_number(parts[0]);
  const auto seconds = parse_number(parts[1]);
  const auto guidance = parse_number(parts[3]);
  const bool loiter = core::lower_case(parts[0]) == "loiter";
  const bool digits =
      !parts[2].empty() && std::ranges::all_of(parts[2], [](char c) { return c >= '0' && c <= '9'; });
  if ((!depth && !loiter) || !seconds || !guidance || !digits || parts[2].size() > 32) return std::nullopt;
  ScienceBand band;
  if (depth) band.depth = core::Metres{*depth};
  band.seconds = *seconds;
  band.sensors = parts[2];
  band.guidance_seconds = *guidance;
  return band;
}

}  // namespace floeplan::mission
