#include "storage/ingest/readers/ice/ice_variables.hpp"

#include <algorithm>
#include <string_view>

#include "engine/messages/ingest_ice_messages.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

std::string description(const NetcdfVariable& variable) {
  return lower(variable.name() + " " + variable.attribute("standard_name") + " " +
               variable.attribute("long_name"));
}

bool is_named_any(const NetcdfVariable& variable, std::initializer_list<std::string_view> names) {
  const std::string name = lower(variable.name());
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool has_name_of_concentration(const NetcdfVariable& variable) {
  return is_named_any(variable, {"siconc", "sic", "ice_conc", "ice_concentration", "seaice_conc",
                                 "sea_ice_concentration", "cdr_seaice_conc", "icec", "aice", "fice",
                                 "ileadfra", "asi_ice_concentration"}) ||
         lower(variable.name()).ends_with("_icecon");
}

bool has_name_of_thickness(const NetcdfVariable& variable) {
  return is_named_any(variable, {"sithick", "sit", "hice", "ice_thickness", "sea_ice_thickness"});
}

/// A quantity of sea ice that this program reads, with the names that files use for it.
struct IceQuantity {
  std::string_view standard_name;
  bool (*has_name)(const NetcdfVariable&);
  std::initializer_list<std::string_view> words;  // words of its long name
};

const IceQuantity concentration_of_ice{
    "sea_ice_area_fraction",
    has_name_of_concentration,
    {"ice concentration", "ice area fraction", "fraction of cell covered by ice"}};
const IceQuantity thickness_of_ice{"sea_ice_thickness", has_name_of_thickness, {"ice thickness"}};
const IceQuantity draft_of_ice{"sea_ice_draft", [](const NetcdfVariable&) { return false; }, {}};

/// Whether a description contains words of errors, intermediate results or other quantities. They exclude a
/// variable unless both its name and its standard name are those of the quantity.
bool speaks_of_something_else(const NetcdfVariable& variable) {
  return contains_any(description(variable),
                      {"error", "uncertain", "stdev", "status", "flag", "quality", "confidence", "raw",
                       "unfiltered", "climatolog", "background", "lake", "velocity", "drift",
                       "number_of_observations", "threshold", "spatial_interp"});
}

bool is_state_on_a_plane(const NetcdfVariable& variable) {
  return variable.is_numeric() && variable.dimensions().size() >= 2 &&
         statistic_of(variable) == Statistic::none;
}

/// Whether the standard name names another quantity. The name and the long name of the variable then do not count.
bool is_named_otherwise(const NetcdfVariable& variable, const IceQuantity& quantity) {
  const std::string standard_name = standard_name_of(variable);
  if (standard_name.find('_') == std::string::npos || standard_name == quantity.standard_name) return false;
  const auto is_of = [&](const IceQuantity& other) { return standard_name == other.standard_name; };
  return is_of(concentration_of_ice) || is_of(thickness_of_ice) || is_of(draft_of_ice) ||
         !contains_any(standard_name, {"ice", "area_fraction"}) ||
         contains_any(standard_name, {"velocity", "temperature", "age", "drift", "snow", "albedo", "extent",
                                      "edge", "type", "stress", "volume", "amount", "freeboard"});
}

bool is(const NetcdfVariable& variable, const IceQuantity& quantity) {
  if (!is_state_on_a_plane(variable)) return false;
  const bool by_standard_name = standard_name_of(variable) == quantity.standard_name;
  const bool by_name = quantity.has_name(variable);
  if (by_standard_name && by_name) return true;
  if (speaks_of_something_else(variable)) return false;
  if (by_standard_name) return true;
  return !is_named_otherwise(variable, quantity) &&
         (by_name || contains_any(lower(variable.attribute("long_name")), quantity.words));
}

/// The variables with the standard name of the quantity; if none has it, those with a name or long name of the
/// quantity.
std::vector<const NetcdfVariable*> all_of(const NetcdfFile& file, const IceQuantity& quantity) {
  std::vector<const NetcdfVariable*> found;
  for (const NetcdfVariable& variable : file.variables())
    if (is(variable, quantity)) found.push_back(&variable);
  const auto is_standard = [&](const NetcdfVariable* variable) {
    return standard_name_of(*variable) == quantity.standard_name;
  };
  if (std::ranges::any_of(found, is_standard))
    std::erase_if(found, [&](const NetcdfVariable* variable) { return !is_standard(variable); });
  return found;
}

bool on_same_dimensions(const NetcdfVariable& a, const NetcdfVariable& b) {
  const auto same = [](const NetcdfDimension& x, const NetcdfDimension& y) { return x.name == y.name; };
  return std::ranges::equal(a.dimensions(), b.dimensions(), same);
}

/// Adds a thickness on the dimensions of the concentration, or a draft if there is no thickness.
void add_thickness(const NetcdfFile& file, IceVariables& ice) {
  const NetcdfVariable& concentration = *ice.concentrations.front();
  const auto take = [&](bool is_draft, const IceQuantity& quantity) {
    for (const NetcdfVariable* variable : all_of(file, quantity)) {
      if (ice.thickness != nullptr || !on_same_dimensions(*variable, concentration)) continue;
      ice.thickness = variable;
      ice.thickness_is_draft = is_draft;
    }
  };
  take(false, thickness_of_ice);
  take(true, draft_of_ice);
}

}  // namespace

bool holds_ice(const NetcdfFile& file) { return !all_of(file, concentration_of_ice).empty(); }

bool holds_ice_thickness(const NetcdfFile& file) { return !all_of(file, thickness_of_ice).empty(); }

std::optional<messages::Message> ice_left_out(const NetcdfFile& file) {
  for (const NetcdfVariable& variable : file.variables()) {
    const Statistic statistic = statistic_of(variable);
    const bool ice = standard_name_of(variable) == concentration_of_ice.standard_name;
    if (ice && variable.is_numeric() && statistic != Statistic::none)
      return messages::ingest_ice_message<"not-the-concentration-itself">(variable.name(),
                                                                          in_words(statistic));
  }
  return std::nullopt;
}

Checked<IceVariables> find_ice(const NetcdfFile& file, const std::optional<std::string>& wanted) {
  IceVariables ice;
  ice.concentrations = all_of(file, concentration_of_ice);
  std::vector<std::string> names;
  names.reserve(ice.concentrations.size());
  for (const NetcdfVariable* variable : ice.concentrations) names.push_back(variable->name());
  if (wanted) {
    const NetcdfVariable* named = file.find(*wanted);
    if (named == nullptr || named->dimensions().size() < 2 || !named->is_numeric())
      return refuse(messages::ingest_ice_message<"ice-variable-not-found">(
          *wanted, names.empty() ? "" : "; it holds the concentrations " + enumeration(names)));
    ice.concentrations = {named};
  }
  if (ice.concentrations.empty()) return refuse(messages::ingest_ice_message<"concentration-missing">());

  const NetcdfVariable& first = *ice.concentrations.front();
  for (const NetcdfVariable* other : ice.concentrations)
    if (!on_same_dimensions(first, *other))
      return refuse(messages::ingest_ice_message<"concentrations-differ-in-shape">(enumeration(names)));
  if (ice.concentrations.size() > 1)
    ice.warnings.push_back(messages::ingest_ice_message<"greatest-concentration-stored">(enumeration(names)));
  add_thickness(file, ice);
  return ice;
}

}  // namespace floeplan::ingest
