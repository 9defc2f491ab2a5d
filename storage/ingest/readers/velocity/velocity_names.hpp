#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "storage/ingest/readers/velocity/velocity_kind.hpp"

namespace floeplan::ingest {

/// What the customs of producers say of a name.
struct KnownName {
  Component component{};
  CurrentContent content{CurrentContent::whole};
  WaterPart part{WaterPart::unstated};
  bool generic{false};  // used of water, air and ice alike
  bool needs_words{
      false};  // used of much else, too: means this where the long name speaks of the same part of the water
  std::size_t rank{};  // in the order in which pairs are taken
};

/// Meaning of a whole name in any case: one that producers are known to use, one spelt as a standard name, or, for a
/// current, one put together of a component and words of currents ("curr_east", "ucurr").
[[nodiscard]] std::optional<KnownName> known_name(std::string_view name, Moving what);
/// Behind the last rank.
[[nodiscard]] std::size_t unknown_rank(Moving what);

/// Whether two names differ only by what tells components apart: "uo_glor" and "vo_glor", "curr_east" and "curr_north",
/// in whichever order.
[[nodiscard]] bool name_one_pair(std::string_view a, std::string_view b);

/// The component that parts of a name tell; nullopt: none, or both.
[[nodiscard]] std::optional<Component> component_in_name(std::string_view name);

/// What a velocity of water says of itself by its standard name.
struct StandardVelocity {
  Moving what{Moving::sea};
  Component component{};
  CurrentContent content{CurrentContent::whole};
  WaterPart part{WaterPart::unstated};
};

/// Meaning of a standard name without modifier, in lower case: those of CF for currents and wind with what may stand
/// before and behind them, and some that producers use beside them (x_sea_water_velocity, eastward_water_velocity).
/// Source  CF standard name table, version 85
[[nodiscard]] std::optional<StandardVelocity> standard_velocity(std::string_view standard_name);

/// Whether it names something that is no horizontal velocity of what moves, so that no other words count.
[[nodiscard]] bool names_another_quantity(std::string_view standard_name, Moving what);

}  // namespace floeplan::ingest
