#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/codec/exports/ice_section.hpp"
#include "api/codec/exports/map_picture.hpp"
#include "engine/messages/message.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// Content of a printed page in addition to the plan.
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
  std::optional<IceSection> ice{};  // set if the plan has ice above it
};

/// A page for the pilot's desk: pictures, times, waypoints in degrees and minutes, data with their hashes,
/// messages. A single HTML file without scripts and without other files, made for printing. UTF-8.
[[nodiscard]] std::string plan_brief_html(const planning::Plan& plan, const BriefPictures& pictures,
                                          const BriefNotes& notes);

/// The same page as PDF in A4. A long table continues on further pages. The machine needs a font: DejaVu
/// Sans, or another one that fontconfig finds.
/// Errors   std::runtime_error when the drawing library fails
[[nodiscard]] std::string plan_brief_pdf(const planning::Plan& plan, const BriefPictures& pictures,
                                         const BriefNotes& notes);

/// The rows of the brief's table, as text: number, latitude, longitude, ETA, leg, course, speed, depth.
[[nodiscard]] std::vector<std::vector<std::string>> brief_rows(const planning::Plan& plan);
/// The line that names the plan and says when the page was made.
[[nodiscard]] std::string brief_origin(const BriefNotes& notes);
/// The caption of the map, which explains its signs.
[[nodiscard]] std::string brief_caption(const MapPicture& picture);
/// The sentences above the table: vehicle, times, distance, clearances.
[[nodiscard]] std::vector<std::string> brief_facts(const planning::Plan& plan, const BriefNotes& notes);
/// The line below the section that explains its curves.
inline constexpr const char* section_caption =
    "Ice above the route, by waypoint: draft of level ice (thick), its deepest keels (dotted), and how deep "
    "the dives of "
    "each leg turn (steps).";

/// The messages of one rank.
struct BriefMessages {
  std::string title;  // "Dangers"
  std::vector<std::string> sentences;
};
/// The messages of the export and of the plan as sentences with their positions, each once, the gravest rank
/// first. Ranks without messages are omitted.
[[nodiscard]] std::vector<BriefMessages> brief_messages(const planning::Plan& plan, const BriefNotes& notes);

}  // namespace floeplan::codec
