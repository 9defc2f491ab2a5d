#pragma once

#include <optional>
#include <string>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Whether larger numbers mean higher (elevation) or deeper (depth).
enum class VerticalSense { up, down };

/// What a file says of its depths or heights; empty where it says nothing.
struct VerticalDescription {
  std::string name;  // of the variable or band
  std::string standard_name;
  std::string long_name;
  std::string positive;
};

/// Extent of the values as the file has them, in metres, and of the grid.
struct VerticalEvidence {
  double lowest_m{};
  double highest_m{};
  bool covers_the_globe{false};
};

struct VerticalFinding {
  VerticalSense sense{};
  std::optional<messages::Message> warning;
};

/// Decides the sense from the user's word, then from the file's words, then from relief that only one sense
/// explains: a global grid that reaches below -9000 and above 5000 can only be elevation. Never guesses from
/// the values of a region.
/// Errors   nothing decides it, or the values contradict the file's words: the user is asked for --positive
[[nodiscard]] Checked<VerticalFinding> vertical_sense_of(const std::optional<std::string>& user_word,
                                                         const VerticalDescription& description,
                                                         const VerticalEvidence& evidence);

}  // namespace floeplan::ingest
