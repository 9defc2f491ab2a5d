#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "engine/messages/message.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/readers/velocity/velocity_kind.hpp"

namespace floeplan::ingest {

/// What a component of a velocity is.
struct VelocityMeaning {
  Component component{};
  VelocityAxes axes{VelocityAxes::unstated};
  CurrentContent content{CurrentContent::whole};
  WaterPart part{WaterPart::unstated};
  bool on_request{false};         // a part of the current, which is stored only where somebody asks for it
  std::optional<double> depth_m;  // of a current without an axis of depth, as its name or long name states it
  bool at_10_m{false};            // a wind that says so
  std::size_t rank{};             // of its name among those that are known; the least is taken first
  std::string instead;            // what the numbers are where they are no state of what moves: "a maximum"
  std::optional<messages::Message> contradiction;  // why its component is not known
  std::optional<messages::Message> remark;         // for the pilot: how the variable was interpreted
};

/// Decides what a variable is. Evidence in this order: the standard name with its modifier, cell_methods, the name, the
/// long name. A standard name that is known decides the quantity and the component; words of a long name never take a
/// variable away whose standard name and name are those of a current or of the wind, but they say what it holds.
/// `what`   the sea: currents; the air: wind near the sea
/// Outside  nullopt for anything that does not claim to be a component of that velocity
[[nodiscard]] std::optional<VelocityMeaning> velocity_meaning(const NetcdfVariable& variable, Moving what);

/// What a current holds by words in lower case, such as a long name, and by a name; whole: they do not say.
[[nodiscard]] CurrentContent content_in_words(const std::string& words);
[[nodiscard]] CurrentContent content_in_name(std::string_view name);
/// Which water a current is of by a name.
[[nodiscard]] WaterPart part_in_name(std::string_view name);
/// "the tide alone": what a pair holds, of pairs that are told apart by it.
[[nodiscard]] std::string content_words(CurrentContent content);

/// The component that the standard name, or failing that the long name, states; nullopt: neither, or both at once.
[[nodiscard]] std::optional<Component> stated_component(const NetcdfVariable& variable);

}  // namespace floeplan::ingest
