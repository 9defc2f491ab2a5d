#include "storage/ingest/velocity_pair.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "storage/ingest/cf_units.hpp"
#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::array known_pairs{
    std::pair<std::string_view, std::string_view>{"uo", "vo"},
    std::pair<std::string_view, std::string_view>{"water_u", "water_v"},
    std::pair<std::string_view, std::string_view>{"utotal", "vtotal"},
    std::pair<std::string_view, std::string_view>{"ugos", "vgos"},
    std::pair<std::string_view, std::string_view>{"u_eastward", "v_northward"},
    std::pair<std::string_view, std::string_view>{"eastward_eulerian_current_velocity",
                                                  "northward_eulerian_current_velocity"},
    std::pair<std::string_view, std::string_view>{"vozocrtx", "vomecrty"},
    std::pair<std::string_view, std::string_view>{"vxo", "vyo"},
    std::pair<std::string_view, std::string_view>{"uvel", "vvel"},
    std::pair<std::string_view, std::string_view>{"u_velocity", "v_velocity"},
    std::pair<std::string_view, std::string_view>{"ssu", "ssv"},
    std::pair<std::string_view, std::string_view>{"hvel[0]", "hvel[1]"},
    std::pair<std::string_view, std::string_view>{"u", "v"},
};

/// Endings of standard names.
constexpr std::array standard_pairs{
    std::pair<std::string_view, std::string_view>{"eastward_sea_water_velocity",
                                                  "northward_sea_water_velocity"},
    std::pair<std::string_view, std::string_view>{"sea_water_x_velocity", "sea_water_y_velocity"},
    std::pair<std::string_view, std::string_view>{"x_sea_water_velocity", "y_sea_water_velocity"},
};

std::string description(const NetcdfVariable& variable) {
  return lower(variable.attribute("standard_name") + " " + variable.attribute("long_name"));
}

bool is_something_else(const NetcdfVariable& variable) {
  return !variable.is_numeric() ||
         contains_any(
             description(variable),
             {"wind", "air_velocity", "ice_", "sea ice", "stokes_drift", "stokes drift", "wave", "stress",
              "anomal", "assuming_sea_level_for_geoid", "barotropic", "vertically integrated",
              "vertically averaged", "depth average", "depth-average", "transport"});
}

/// What the words of one component say; the names alone tell only where a convention stands behind them.
VelocityAxes stated_axes(const NetcdfVariable& variable) {
  const std::string name = lower(variable.name());
  const std::string words = description(variable);
  if (contains_any(words, {"x_sea_water_velocity", "y_sea_water_velocity", "sea_water_x_velocity",
                           "sea_water_y_velocity", "surface_x_velocity", "surface_y_velocity", "i-current",
                           "j-current", "i-axis", "j-axis", "u-momentum", "v-momentum", "grid-x", "grid-y",
                           "along the grid", "xi-direction", "eta-direction"}))
    return VelocityAxes::grid;
  if (contains_any(words, {"eastward", "northward"})) return VelocityAxes::east_north;
  if (name == "u_eastward" || name == "v_northward") return VelocityAxes::east_north;
  if (name == "vozocrtx" || name == "vomecrty" || name == "vxo" || name == "vyo") return VelocityAxes::grid;
  return VelocityAxes::unstated;
}

const NetcdfVariable* find_named(const NetcdfFile& file, std::string_view name) {
  for (const NetcdfVariable& variable : file.variables())
    if (lower(variable.name()) == name && !is_something_else(variable)) return &variable;
  return nullptr;
}

const NetcdfVariable* find_standard(const NetcdfFile& file, std::string_view ending) {
  for (const NetcdfVariable& variable : file.variables())
    if (lower(variable.attribute("standard_name")).ends_with(ending) && !is_something_else(variable))
      return &variable;
  return nullptr;
}

template <class Find>
VelocityPair pair_by(const NetcdfFiles& files, const Find& find, std::string_view first,
                     std::string_view second) {
  VelocityPair pair;
  for (const auto& file : files) {
    if (pair.first == nullptr) {
      pair.first = find(*file, first);
      if (pair.first != nullptr) pair.first_file = file.get();
    }
    if (pair.second == nullptr) {
      pair.second = find(*file, second);
      if (pair.second != nullptr) pair.second_file = file.get();
    }
  }
  return pair;
}

bool is_whole(const VelocityPair& pair) { return pair.first != nullptr && pair.second != nullptr; }
bool is_empty(const VelocityPair& pair) { return pair.first == nullptr && pair.second == nullptr; }

/// A whole pair if there is any, else whatever was found first.
VelocityPair find_either(const NetcdfFiles& files) {
  VelocityPair incomplete;
  const auto take = [&](VelocityPair pair) {
    if (is_whole(pair) || is_empty(incomplete)) incomplete = std::move(pair);
    return is_whole(incomplete);
  };
  for (const auto& [first, second] : known_pairs)
    if (take(pair_by(files, find_named, first, second))) return incomplete;
  for (const auto& [first, second] : standard_pairs)
    if (take(pair_by(files, find_standard, first, second))) return incomplete;
  return incomplete;
}

VelocityPair find_either(const NetcdfFile& file) {
  return find_either(NetcdfFiles{{std::shared_ptr<const NetcdfFile>{}, &file}});  // borrowed
}

void warn_of_meaning(VelocityPair& pair) {
  const std::string name = lower(pair.first->name());
  const std::string text = description(*pair.first);
  if (contains_any(text, {"geostrophic"}) || name == "ugos")
    pair.warnings.push_back(
        "these are geostrophic currents from sea level: no tide, no wind drift, near the surface only");
  if (name == "utotal")
    pair.warnings.push_back("these currents already hold the tide and the drift by waves");
  if (text == " ")
    pair.warnings.push_back("the variables \"" + pair.first->name() + "\" and \"" + pair.second->name() +
                            "\" do not describe themselves; taken as currents by their names");
}

}  // namespace

bool holds_velocity(const NetcdfFile& file) { return velocity_parts(file) != VelocityParts::none; }

VelocityParts velocity_parts(const NetcdfFile& file) {
  const VelocityPair pair = find_either(file);
  if (is_whole(pair)) return VelocityParts::both;
  if (is_empty(pair)) return VelocityParts::none;
  return pair.first != nullptr ? VelocityParts::first_alone : VelocityParts::second_alone;
}

const NetcdfVariable* find_some_velocity(const NetcdfFile& file) {
  const VelocityPair pair = find_either(file);
  return pair.first != nullptr ? pair.first : pair.second;
}

Checked<VelocityPair> find_velocity_pair(const NetcdfFiles& files) {
  VelocityPair pair = find_either(files);
  if (is_empty(pair))
    return refuse(
        "the file holds no velocity of sea water; there are no currents to store; give a file with, for "
        "example, the variables uo and vo");
  if (!is_whole(pair)) {
    const NetcdfVariable& alone = pair.first != nullptr ? *pair.first : *pair.second;
    return refuse("the file holds only one component of the current (\"" + alone.name() + "\"); the " +
                  (pair.first == nullptr ? "eastward" : "northward") +
                  " one is missing; give the file of the other component in the same command");
  }
  const VelocityAxes first = stated_axes(*pair.first);
  const VelocityAxes second = stated_axes(*pair.second);
  if (first != second)
    return refuse(
        "the components \"" + pair.first->name() + "\" and \"" + pair.second->name() +
        "\" are described differently: one along the model's grid, the other not; used together, the "
        "drift would be turned; ask the producer for a file that describes both");
  pair.axes = first;
  warn_of_meaning(pair);
  return pair;
}

Checked<double> speed_factor_of(const NetcdfVariable& variable, std::vector<std::string>& warnings) {
  const std::string unit = variable.attribute("units");
  if (unit.empty()) {
    warnings.push_back("the variable \"" + variable.name() +
                       "\" states no unit; taken as m/s, which its size allows");
    return 1.0;
  }
  if (const auto factor = speed_factor(unit)) return *factor;
  return refuse("the variable \"" + variable.name() + "\" has the unit \"" + unit +
                "\", which is no speed that this program knows; a wrong guess would put the glider off "
                "course; ask for data in m/s");
}

}  // namespace floeplan::ingest
