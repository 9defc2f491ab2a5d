#include "storage/ingest/velocity_pair.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "storage/ingest/cf_units.hpp"
#include "storage/ingest/netcdf_layout.hpp"
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
    std::pair<std::string_view, std::string_view>{"u", "v"},
};

std::string description(const NetcdfVariable& variable) {
  return lower(variable.attribute("standard_name") + " " + variable.attribute("long_name"));
}

bool is_something_else(const NetcdfVariable& variable) {
  return !variable.is_numeric() ||
         contains_any(description(variable),
                      {"wind", "air_velocity", "ice_", "sea ice", "stokes_drift", "stokes drift", "wave",
                       "stress", "anomal", "assuming_sea_level_for_geoid", "barotropic"});
}

bool is_along_grid_axes(const NetcdfVariable& variable) {
  const std::string name = lower(variable.name());
  return contains_any(
             description(variable),
             {"x_sea_water_velocity", "y_sea_water_velocity", "sea_water_x_velocity", "sea_water_y_velocity",
              "surface_x_velocity", "surface_y_velocity", "i-current", "j-current", "i-axis", "j-axis"}) ||
         name == "vozocrtx" || name == "vomecrty" || name == "vxo" || name == "vyo";
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

VelocityPair find_either(const NetcdfFile& file) {
  VelocityPair incomplete;
  for (const auto& [east_name, north_name] : known_pairs) {
    const VelocityPair pair{find_named(file, east_name), find_named(file, north_name), {}};
    if (pair.east != nullptr && pair.north != nullptr) return pair;
    if (incomplete.east == nullptr && incomplete.north == nullptr) incomplete = pair;
  }
  const VelocityPair pair{find_standard(file, "eastward_sea_water_velocity"),
                          find_standard(file, "northward_sea_water_velocity"),
                          {}};
  if (pair.east != nullptr && pair.north != nullptr) return pair;
  return incomplete.east != nullptr || incomplete.north != nullptr ? incomplete : pair;
}

void warn_of_meaning(VelocityPair& pair) {
  const std::string name = lower(pair.east->name());
  const std::string text = description(*pair.east);
  if (contains_any(text, {"geostrophic"}) || name == "ugos")
    pair.warnings.push_back(
        "these are geostrophic currents from sea level: no tide, no wind drift, near the surface only");
  if (name == "utotal")
    pair.warnings.push_back("these currents already hold the tide and the drift by waves");
  if (text == " ")
    pair.warnings.push_back(
        "the variables \"" + pair.east->name() + "\" and \"" + pair.north->name() +
        "\" do not describe themselves; taken as currents towards east and north by their names");
}

}  // namespace

bool holds_velocity(const NetcdfFile& file) {
  const VelocityPair pair = find_either(file);
  return pair.east != nullptr || pair.north != nullptr;
}

Checked<VelocityPair> find_velocity_pair(const NetcdfFile& file) {
  VelocityPair pair = find_either(file);
  const NetcdfVariable* any = pair.east != nullptr ? pair.east : pair.north;
  if (any == nullptr)
    return refuse(
        "the file holds no velocity of sea water; there are no currents to store; give a file with, for "
        "example, the variables uo and vo");

  if (auto unsupported = unsupported_grid(file, *any)) return refuse(std::move(*unsupported));
  if (is_along_grid_axes(*any))
    return refuse("the velocity \"" + any->name() +
                  "\" points along the axes of the model's grid, not towards east and north; used as it is, "
                  "the drift would be turned by up to 180 degrees; this layout is not yet supported; rotate "
                  "the components to east and north first");
  if (pair.east == nullptr || pair.north == nullptr)
    return refuse("the file holds only one component of the current (\"" + any->name() + "\"); the " +
                  (pair.east == nullptr ? "eastward" : "northward") +
                  " one is missing; merge both components into one file");
  const auto same_name = [](const NetcdfDimension& a, const NetcdfDimension& b) { return a.name == b.name; };
  if (!std::ranges::equal(pair.east->dimensions(), pair.north->dimensions(), same_name))
    return refuse("the components \"" + pair.east->name() + "\" and \"" + pair.north->name() +
                  "\" lie on different points of a staggered grid; this layout is not yet supported; "
                  "interpolate both to the same points first");
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
