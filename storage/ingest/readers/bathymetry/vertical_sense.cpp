#include "storage/ingest/readers/bathymetry/vertical_sense.hpp"

#include "engine/messages/ingest_depth_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

std::optional<VerticalSense> sense_of_standard_name(const std::string& name) {
  if (contains_any(name, {"depth_below", "sea_floor_depth"}) || name == "depth") return VerticalSense::down;
  if (contains_any(name, {"altitude", "height"})) return VerticalSense::up;
  return std::nullopt;
}

std::optional<VerticalSense> sense_of_words(const std::string& words) {
  const bool up = contains_any(words, {"elevation", "altitude", "relief", "topograph", "height"});
  const bool down = contains_any(words, {"depth", "sounding", "hdept"});
  if (up == down) return std::nullopt;
  return up ? VerticalSense::up : VerticalSense::down;
}

std::optional<VerticalSense> stated_sense(const VerticalDescription& description) {
  const std::string positive = lower(description.positive);
  if (positive == "up") return VerticalSense::up;
  if (positive == "down") return VerticalSense::down;
  if (const auto sense = sense_of_standard_name(lower(description.standard_name))) return sense;
  return sense_of_words(lower(description.name + " " + description.long_name));
}

/// The direction in which a global relief makes sense: the ocean is deeper than 9000 m, and no mountain is
/// higher than 9000 m.
std::optional<VerticalSense> unmistakable_relief(const VerticalEvidence& evidence) {
  if (!evidence.covers_the_globe) return std::nullopt;
  if (evidence.lowest_m < -9000.0 && evidence.highest_m > 5000.0 && evidence.highest_m < 9000.0)
    return VerticalSense::up;
  if (evidence.highest_m > 9000.0 && evidence.lowest_m < -5000.0 && evidence.lowest_m > -9000.0)
    return VerticalSense::down;
  return std::nullopt;
}

}  // namespace

Checked<VerticalFinding> vertical_sense_of(const std::optional<std::string>& user_word,
                                           const VerticalDescription& description,
                                           const VerticalEvidence& evidence) {
  const std::string extent = number(evidence.lowest_m) + " to " + number(evidence.highest_m) + " m";
  if (user_word) {
    if (*user_word == "up") return VerticalFinding{VerticalSense::up, std::nullopt};
    if (*user_word == "down") return VerticalFinding{VerticalSense::down, std::nullopt};
    return refuse(messages::ingest_depth_message<"positive-flag-unknown">(*user_word));
  }

  if (const auto stated = stated_sense(description)) {
    const bool explicit_word = !description.positive.empty();
    if (!explicit_word && *stated == VerticalSense::down && evidence.highest_m <= 0.0 &&
        evidence.lowest_m < 0.0)
      return refuse(messages::ingest_depth_message<"depth-looks-like-elevation">(description.name, extent));
    return VerticalFinding{*stated, std::nullopt};
  }

  if (const auto relief = unmistakable_relief(evidence)) {
    const bool up = *relief == VerticalSense::up;
    return VerticalFinding{*relief, messages::ingest_depth_message<"vertical-sense-of-the-globe">(
                                        description.name, extent, up ? "elevation" : "depth")};
  }
  if (evidence.lowest_m >= 0.0 && evidence.highest_m <= 100.0)  // percent of sea ice has this range, too
    return refuse(messages::ingest_depth_message<"depths-or-ice">(
        description.name, number(evidence.lowest_m) + " to " + number(evidence.highest_m)));
  return refuse(messages::ingest_depth_message<"vertical-sense-unknown">(description.name, extent));
}

}  // namespace floeplan::ingest
