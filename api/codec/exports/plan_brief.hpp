#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/codec/exports/ice_section.hpp"
#include "api/codec/exports/map_picture.hpp"
#include "engine/messages/message.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// What a printed page says besides the plan.
struct BriefNotes {
  std::string plan_id;
  std::string name;
  core::UtcTime generated{};
  std::vector<messages::Message> messages;  // of the export; the plan's own are added
  std::vector<std::string> alternatives{};  // a line for each, the best first
  std::vector<geo::LonLat> safe_places{};   // to recover to in an emergency, as the pilot named them
};

struct BriefPictures {
  MapPicture map;
  std::optional<IceSection> ice{};  // of a plan with ice above it
};

/// A page for the pilot's desk: pictures, times, waypoints in degrees and minutes, data with their hashes, messages.
/// One HTML file that needs nothing else, made to be printed. UTF-8; no script.
[[nodiscard]] std::string plan_brief_html(const planning::Plan& plan, const BriefPictures& pictures,
                                          const BriefNotes& notes);

/// The same page as PDF in A4. A long table continues on further pages. Needs a font on the machine: DejaVu Sans, or any
/// other that fontconfig finds.
/// Errors   std::runtime_error when the drawing library fails
[[nodiscard]] std::string plan_brief_pdf(const planning::Plan& plan, const BriefPictures& pictures,
                                         const BriefNotes& notes);

/// The rows of the brief's table, as text: number, latitude, longitude, ETA, leg, course, speed, depth.
[[nodiscard]] std::vector<std::vector<std::string>> brief_rows(const planning::Plan& plan);
/// Which plan the page is of, and when it was made.
[[nodiscard]] std::string brief_origin(const BriefNotes& notes);
/// What the map shows, as a line below it.
[[nodiscard]] std::string brief_caption(const MapPicture& picture);
/// The sentences above the table: vehicle, times, distance, clearances.
[[nodiscard]] std::vector<std::string> brief_facts(const planning::Plan& plan, const BriefNotes& notes);
/// What the lines of the section are, as a line below it.
inline constexpr const char* section_caption =
    "Ice above the route, by waypoint: draft of level ice (thick), its deepest keels (dotted), and how deep "
    "the dives of "
    "each leg turn (steps).";

/// What the pilot is told of one rank.
struct BriefMessages {
  std::string title;  // "Dangers"
  std::vector<std::string> sentences;
};
/// The messages of the export and of the plan as sentences with their places, each once, the gravest rank first; ranks
/// without a message are left out.
[[nodiscard]] std::vector<BriefMessages> brief_messages(const planning::Plan& plan, const BriefNotes& notes);

}  // namespace floeplan::codec
