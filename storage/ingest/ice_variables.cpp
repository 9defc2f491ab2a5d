#include "storage/ingest/ice_variables.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "storage/ingest/netcdf_layout.hpp"
#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

std::string description(const NetcdfVariable& variable) {
  return lower(variable.name() + " " + variable.attribute("standard_name") + " " +
               variable.attribute("long_name"));
}

/// Statements about an estimate, other stages of it, other ice.
bool is_something_else(const NetcdfVariable& variable) {
  return !variable.is_numeric() || variable.dimensions().size() < 2 ||
         contains_any(description(variable), {"error",
                                              "uncertain",
                                              "stdev",
                                              "standard deviation",
                                              "standard_deviation",
                                              "status",
                                              "flag",
                                              "quality",
                                              "confidence",
                                              "anomal",
                                              "raw",
                                              "unfiltered",
                                              "climatolog",
                                              "background",
                                              "lake",
                                              "velocity",
                                              "drift",
                                              "number_of_observations",
                                              "threshold",
                                              "spatial_interp"});
}

bool has_standard_name(const NetcdfVariable& variable, std::string_view wanted) {
  return lower(variable.attribute("standard_name")) == wanted;
}

bool is_named_any(const NetcdfVariable& variable, std::initializer_list<std::string_view> names) {
  const std::string name = lower(variable.name());
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_called_concentration(const NetcdfVariable& variable) {
  return is_named_any(variable, {"siconc", "sic", "ice_conc", "ice_concentration", "seaice_conc",
                                 "sea_ice_concentration", "cdr_seaice_conc", "icec", "aice", "fice",
                                 "ileadfra", "asi_ice_concentration"}) ||
         lower(variable.name()).ends_with("_icecon") ||
         contains_any(lower(variable.attribute("long_name")),
                      {"ice concentration", "ice area fraction", "fraction of cell covered by ice"});
}

bool is_called_thickness(const NetcdfVariable& variable) {
  return is_named_any(variable, {"sithick", "sit", "hice", "ice_thickness", "sea_ice_thickness"}) ||
         contains_any(lower(variable.attribute("long_name")), {"ice thickness"});
}

template <class Suits>
std::vector<const NetcdfVariable*> all_that(const NetcdfFile& file, const Suits& suits) {
  std::vector<const NetcdfVariable*> found;
  for (const NetcdfVariable& variable : file.variables())
    if (!is_something_else(variable) && suits(variable)) found.push_back(&variable);
  return found;
}

std::vector<const NetcdfVariable*> concentrations_of(const NetcdfFile& file) {
  auto found = all_that(file, [](const NetcdfVariable& variable) {
    return has_standard_name(variable, "sea_ice_area_fraction");
  });
  return found.empty() ? all_that(file, is_called_concentration) : found;
}

bool on_same_dimensions(const NetcdfVariable& a, const NetcdfVariable& b) {
  const auto same = [](const NetcdfDimension& x, const NetcdfDimension& y) { return x.name == y.name; };
  return std::ranges::equal(a.dimensions(), b.dimensions(), same);
}

/// The thickness on the dimensions of the concentration; a draft only where there is none.
void add_thickness(const NetcdfFile& file, IceVariables& ice) {
  const NetcdfVariable& concentration = *ice.concentrations.front();
  const auto take = [&](bool is_draft, const auto& suits) {
    for (const NetcdfVariable* variable : all_that(file, suits)) {
      if (ice.thickness != nullptr || !on_same_dimensions(*variable, concentration)) continue;
      ice.thickness = variable;
      ice.thickness_is_draft = is_draft;
    }
  };
  take(false, [](const NetcdfVariable& v) { return has_standard_name(v, "sea_ice_thickness"); });
  take(false, is_called_thickness);
  take(true, [](const NetcdfVariable& v) { return has_standard_name(v, "sea_ice_draft"); });
}

}  // namespace

bool holds_ice(const NetcdfFile& file) { return !concentrations_of(file).empty(); }

bool holds_ice_thickness(const NetcdfFile& file) {
  return !all_that(file, [](const NetcdfVariable& variable) {
            return has_standard_name(variable, "sea_ice_thickness") || is_called_thickness(variable);
          }).empty();
}

Checked<IceVariables> find_ice(const NetcdfFile& file, const std::optional<std::string>& wanted) {
  IceVariables ice;
  ice.concentrations = concentrations_of(file);
  std::vector<std::string> names;
  names.reserve(ice.concentrations.size());
  for (const NetcdfVariable* variable : ice.concentrations) names.push_back(variable->name());
  if (wanted) {
    const NetcdfVariable* named = file.find(*wanted);
    if (named == nullptr || named->dimensions().size() < 2 || !named->is_numeric())
      return refuse("the file has no grid of values called \"" + *wanted + "\"" +
                    (names.empty() ? "" : "; it holds the concentrations " + enumeration(names)) +
                    "; give one of its names");
    ice.concentrations = {named};
  }
  if (ice.concentrations.empty())
    return refuse(
        "the file holds no concentration of sea ice; there is nothing to store; give a file with, for "
        "example, "
        "a variable siconc of standard name sea_ice_area_fraction");

  const NetcdfVariable& first = *ice.concentrations.front();
  for (const NetcdfVariable* other : ice.concentrations)
    if (!on_same_dimensions(first, *other))
      return refuse(
          "the concentrations " + enumeration(names) +
          " lie on different dimensions; which of them counts is unclear; name one with --variable");
  if (ice.concentrations.size() > 1)
    ice.warnings.push_back(
        "the file holds several estimates of the concentration (" + enumeration(names) +
        "); the greatest of them is stored at every place; name one with --variable to use "
        "it alone");
  add_thickness(file, ice);
  return ice;
}

}  // namespace floeplan::ingest
