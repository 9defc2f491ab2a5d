#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "storage/ingest/readers/velocity/velocity_kind.hpp"

namespace floeplan::ingest {

/// The usual meaning of a variable's name.
struct KnownName {
  Component component{};
  CurrentContent content{CurrentContent::whole};
  WaterPart part{WaterPart::unstated};
  bool generic{false};  // used for water, air and ice
  bool needs_words{
      false};  // used for other quantities too: counts only if the long name names the same part of the water
  std::size_t rank{};  // pairs with a smaller rank are preferred
};

/// Meaning of a name, in upper or lower case: a name that producers are known to use, one spelt like a
/// standard name, or, for a current, a component joined with words for currents ("curr_east", "ucurr").
[[nodiscard]] std::optional<KnownName> known_name(std::string_view name, Moving what);
/// The rank of unknown names, after all known ones.
[[nodiscard]] std::size_t unknown_rank(Moving what);

/// Whether two names, in any order, differ only in the part that names the component: "uo_glor" and
/// "vo_glor", "curr_east" and "curr_north".
[[nodiscard]] bool name_one_pair(std::string_view a, std::string_view b);

/// The component in the parts of a name; nullopt: none, or both.
[[nodiscard]] std::optional<Component> component_in_name(std::string_view name);

/// The meaning of a standard name of a velocity.
struct StandardVelocity {
  Moving what{Moving::sea};
  Component component{};
  CurrentContent content{CurrentContent::whole};
  WaterPart part{WaterPart::unstated};
};

/// Meaning of a standard name in lower case without its modifier: the CF names of currents and wind with
/// their usual prefixes and suffixes, and some others that producers use (x_sea_water_velocity,
/// eastward_water_velocity).
/// Source  CF standard name table, version 85
[[nodiscard]] std::optional<StandardVelocity> standard_velocity(std::string_view standard_name);

/// Whether a standard name is another quantity than the horizontal velocity of `what`; other words then do
/// not count.
[[nodiscard]] bool names_another_quantity(std::string_view standard_name, Moving what);

}  // namespace floeplan::ingest
