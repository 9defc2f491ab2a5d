#pragma once

#include <optional>
#include <string>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Whether larger numbers mean higher (elevation) or deeper (depth).
enum class VerticalSense { up, down };

/// What a file states about the direction of its depths or heights; texts are empty where it states nothing.
struct VerticalDescription {
  std::string name;  // of the variable or band
  std::string standard_name;
  std::string long_name;
  std::string positive;
};

/// Range of the values in the file, in metres, and whether the grid is global.
struct VerticalEvidence {
  double lowest_m{};
  double highest_m{};
  bool covers_the_globe{false};
};

struct VerticalFinding {
  VerticalSense sense{};
  std::optional<messages::Message> warning;
};

/// Decides the direction: by the user's statement, or else by the file's statements, or else by a relief that
/// makes sense in one direction only. A global grid that reaches below -9000 and above 5000 can only hold
/// elevations. The values of a regional grid are never used.
/// Errors   nothing decides, or the values contradict the file's statements; the user has to give --positive
[[nodiscard]] Checked<VerticalFinding> vertical_sense_of(const std::optional<std::string>& user_word,
                                                         const VerticalDescription& description,
                                                         const VerticalEvidence& evidence);

}  // namespace floeplan::ingest
