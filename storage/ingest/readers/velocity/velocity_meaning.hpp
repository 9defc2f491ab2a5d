#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "engine/messages/message.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/readers/velocity/velocity_kind.hpp"

namespace floeplan::ingest {

/// The interpretation of a variable as a component of a velocity.
struct VelocityMeaning {
  Component component{};
  VelocityAxes axes{VelocityAxes::unstated};
  CurrentContent content{CurrentContent::whole};
  WaterPart part{WaterPart::unstated};
  bool on_request{false};         // a part of the current that is stored only if the user names it
  std::optional<double> depth_m;  // depth in the name or long name of a current without a depth axis
  bool at_10_m{false};            // a wind whose attributes say 10 m
  std::size_t rank{};             // rank of its name among the known ones; the smallest is preferred
  std::string instead;            // what the values are instead of the velocity: "a maximum"; otherwise empty
  std::optional<messages::Message> contradiction;  // set if its component is unclear
  std::optional<messages::Message> remark;         // for the pilot: how the variable was interpreted
};

/// Interprets a variable. Evidence in this order: the standard name with its modifier, cell_methods, the
/// name, the long name. A known standard name decides the quantity and the component. If standard name and
/// name are those of a current or wind, words of the long name never exclude the variable, but they tell what
/// it contains.
/// `what`   sea: currents; air: wind near the sea
/// Outside  nullopt for a variable that does not seem to be a component of such a velocity
[[nodiscard]] std::optional<VelocityMeaning> velocity_meaning(const NetcdfVariable& variable, Moving what);

/// The part of the current that words in lower case, or a name, state; `whole` if they state none.
[[nodiscard]] CurrentContent content_in_words(const std::string& words);
[[nodiscard]] CurrentContent content_in_name(std::string_view name);
/// The part of the water column that a name states.
[[nodiscard]] WaterPart part_in_name(std::string_view name);
/// The part in words, to distinguish pairs in messages: "the tide alone".
[[nodiscard]] std::string content_words(CurrentContent content);

/// The component in the standard name, or else in the long name; nullopt: neither, or both at once.
[[nodiscard]] std::optional<Component> stated_component(const NetcdfVariable& variable);

}  // namespace floeplan::ingest
