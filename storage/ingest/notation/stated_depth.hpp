#pragma once

#include <optional>
#include <string_view>

#include "engine/core/units.hpp"

namespace floeplan::ingest {

/// A depth as people write it: "20", "20 m", "66 ft".
/// `unit`   for a number without a unit; empty: metres
/// Outside  nullopt for a text that is not a number with a known unit, above the surface or deeper than 11000
///          m
[[nodiscard]] std::optional<core::Metres> stated_depth(std::string_view text, std::string_view unit);

/// A layer between two depths.
struct StatedDepths {
  core::Metres top;
  core::Metres bottom;
};

/// Two depths with a dash or "to" between them: "20-100", "0 m to 200 m"; a unit after the second applies to
/// both.
[[nodiscard]] std::optional<StatedDepths> stated_depths(std::string_view text, std::string_view unit);

}  // namespace floeplan::ingest
