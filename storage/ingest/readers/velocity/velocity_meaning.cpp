#include "storage/ingest/readers/velocity/velocity_meaning.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "engine/messages/ingest_velocity_messages.hpp"
#include "storage/ingest/formats/netcdf/variable_level.hpp"
#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/velocity/velocity_names.hpp"

namespace floeplan::ingest {
namespace {

std::string standard_and_long_name(const NetcdfVariable& variable) {
  return lower(variable.attribute("standard_name") + " " + variable.attribute("long_name"));
}

/// Words in long names: of the first component and of the second.
constexpr std::pair<std::string_view, std::string_view> component_words[]{
    {"eastward", "northward"},
    {"zonal", "meridional"},
    {"zonal", "meridian"},
    {"east component", "north component"},
    {"east-component", "north-component"},
    {"east/west", "north/south"},
    {"east velocity", "north velocity"},
    {"east current", "north current"},
    {"i-current", "j-current"},
    {"i-axis", "j-axis"},
    {"u-momentum", "v-momentum"},
    {"grid-x", "grid-y"},
    {"xi-direction", "eta-direction"},
    {"x-direction", "y-direction"},
    {"x-velocity", "y-velocity"},
    {"x velocity", "y velocity"},
    {"x_velocity", "y_velocity"},
    {"x-component", "y-component"},
    {"x component", "y component"},
    {"u-component", "v-component"},
    {"u component", "v component"},
    {"u-velocity", "v-velocity"},
    {"u velocity", "v velocity"},
    {"u wind", "v wind"}};

/// Whether `wanted` occurs at the beginning of a word: "y velocity", but not in "eddy velocity".
bool has_word(std::string_view words, std::string_view wanted) {
  for (std::size_t at = words.find(wanted); at != std::string_view::npos; at = words.find(wanted, at + 1))
    if (at == 0 || words[at - 1] < 'a' || words[at - 1] > 'z') return true;
  return false;
}

std::optional<Component> component_in_long_name(const std::string& words) {
  const bool first =
      std::ranges::any_of(component_words, [&](const auto& pair) { return has_word(words, pair.first); });
  const bool second =
      std::ranges::any_of(component_words, [&](const auto& pair) { return has_word(words, pair.second); });
  if (first == second) return std::nullopt;
  return first ? Component::first : Component::second;
}

std::string in_words(Component component, VelocityAxes axes) {
  if (axes == VelocityAxes::grid)
    return component == Component::first ? "the component along x" : "the component along y";
  return component == Component::first ? "the eastward component" : "the northward component";
}

/// The axes according to the words of a component. A name alone counts only if it follows a convention.
VelocityAxes stated_axes(const NetcdfVariable& variable, Moving what) {
  const std::string name = lower(variable.name());
  const std::string words = standard_and_long_name(variable);
  if (what == Moving::air) {
    const std::string all = name + " " + words;
    if (contains_any(all, {"x_wind", "y_wind", "grid-x", "grid-y"})) return VelocityAxes::grid;
    return contains_any(all, {"eastward", "northward"}) ? VelocityAxes::east_north : VelocityAxes::unstated;
  }
  if (contains_any(words, {"x_sea_water_velocity", "y_sea_water_velocity", "sea_water_x_velocity",
                           "sea_water_y_velocity", "surface_x_velocity", "surface_y_velocity", "i-current",
                           "j-current", "i-axis", "j-axis", "u-momentum", "v-momentum", "grid-x", "grid-y",
                           "along the grid", "xi-direction", "eta-direction"}))
    return VelocityAxes::grid;
  if (contains_any(words, {"eastward", "northward"})) return VelocityAxes::east_north;
  for (const std::string& part : parts_of_name(name))
    if (part == "eastward" || part == "northward" || part == "east" || part == "north")
      return VelocityAxes::east_north;
  if (name == "vozocrtx" || name == "vomecrty" || name == "vxo" || name == "vyo" || name == "sozocrtx" ||
      name == "somecrty")
    return VelocityAxes::grid;
  return VelocityAxes::unstated;
}

/// Whether the words are about water (or air, by `what`). Needed for names that are used for water, air and
/// ice.
bool speaks_of(const std::string& words, Moving what) {
  const bool water = contains_any(words, {"sea water", "seawater", "sea_water", "water velocity",
                                          "water_velocity", "current", "ocean velocity", "eulerian"});
  const bool air = contains_any(words, {"wind", "air_velocity", "air velocity"});
  if (what == Moving::air) return air && !water;
  const bool ice = contains_any(
      words, {"ice velocity", "ice drift", "ice motion", "ice_", "sea ice", "sea-ice", "velocity of ice"});
  return water || (!air && !ice);
}

/// Whether words of a velocity in the long name mean another quantity: a transport or a stress, which has
/// another unit, or the shear of the wind.
bool is_no_speed(const NetcdfVariable& variable, const std::string& words, Moving what) {
  const std::string unit = variable.attribute("units");
  const bool speed = !unit.empty() && speed_factor(unit);
  return (what == Moving::air && contains_any(words, {"shear"})) ||
         (!speed && contains_any(words, {"transport", "vertically integrated", "stress", "shear"}));
}

WaterPart part_in_cell_methods(const NetcdfVariable& variable) {
  for (const CellMethod& cell : cell_methods_of(variable))
    if (cell.method == "mean" && std::ranges::any_of(cell.axes, [](const std::string& axis) {
          return axis == "depth" || axis == "z" || axis == "lev" || axis == "deptht" || axis == "ocean_depth";
        }))
      return WaterPart::column_mean;
  return WaterPart::unstated;
}

/// Whether a number of metres occurs: "0-300 m", "the upper 300 metres".
bool states_metres(std::string_view words) {
  for (std::size_t at = words.find('m'); at != std::string_view::npos; at = words.find('m', at + 1)) {
    std::size_t before = at;
    while (before > 0 && words[before - 1] == ' ') --before;
    const std::string_view behind = words.substr(at + 1);
    const bool is_unit = behind.empty() || behind[0] < 'a' || behind[0] > 'z' || behind.starts_with("etre") ||
                         behind.starts_with("eter");
    const bool is_speed = behind.starts_with("/") || behind.starts_with(" s-1");
    if (before > 0 && words[before - 1] >= '0' && words[before - 1] <= '9' && is_unit && !is_speed)
      return true;
  }
  return false;
}

WaterPart part_in_words(const std::string& words) {
  if (contains_any(words, {"vertically integrated", "vertically averaged", "vertically-averaged",
                           "barotropic", "depth average", "depth-average", "depth mean", "depth-mean",
                           "vertical mean", "column mean"}))
    return WaterPart::column_mean;
  if (contains_any(words, {"averaged", "average", "mean"}) && states_metres(words))
    return WaterPart::column_mean;
  if (contains_any(words, {"at the sea floor", "at sea floor", "at bottom", "at the bottom", "near-bottom",
                           "bottom velocity", "bottom current", "at the sea bed"}))
    return WaterPart::bed;
  if (contains_any(words, {"surface velocity", "surface current", "surface eastward", "surface northward",
                           "surface zonal", "surface meridional", "surface u", "surface v", "surface x",
                           "surface y", "surface_x", "surface_y", "at the surface", "at surface",
                           "at the sea surface", "at sea surface", "near-surface", "surface sea water"}))
    return WaterPart::surface;
  return WaterPart::unstated;
}

/// The first value that is not the default.
template <class Kind>
Kind first_stated(std::initializer_list<Kind> all) {
  for (const Kind one : all)
    if (one != Kind{}) return one;
  return Kind{};
}

/// The component according to each kind of evidence, strongest first.
struct ComponentEvidence {
  std::optional<Component> standard_name;
  std::optional<Component> long_name;
  std::optional<Component> name;
};

/// Decides the component, or notes the contradiction. The standard name decides, unless the long name
/// contradicts it and the name does not confirm it.
void settle_component(VelocityMeaning& meaning, const NetcdfVariable& variable,
                      const ComponentEvidence& evidence) {
  const auto differ = [](std::optional<Component> a, std::optional<Component> b) {
    return a && b && *a != *b;
  };
  if (differ(evidence.standard_name, evidence.long_name) &&
      !(evidence.name && !differ(evidence.name, evidence.standard_name))) {
    meaning.component = *evidence.standard_name;
    meaning.contradiction = messages::ingest_velocity_message<"component-contradicts-itself">(
        variable.name(), variable.attribute("standard_name"), in_words(*evidence.standard_name, meaning.axes),
        variable.attribute("long_name"), in_words(*evidence.long_name, meaning.axes));
    return;
  }
  meaning.component = evidence.standard_name ? *evidence.standard_name
                      : evidence.long_name   ? *evidence.long_name
                                             : *evidence.name;
  const std::optional<Component> settled = meaning.component;
  if (evidence.standard_name && (differ(settled, evidence.name) || differ(settled, evidence.long_name)))
    meaning.remark = messages::ingest_velocity_message<"taken-by-standard-name">(
        variable.name(), in_words(*settled, meaning.axes),
        differ(settled, evidence.name) ? "name" : "long name");
  else if (!evidence.standard_name && differ(settled, evidence.name))
    meaning.remark = messages::ingest_velocity_message<"taken-by-long-name">(
        variable.name(), in_words(*settled, meaning.axes));
}

/// A message if a component is described as westward or southward. It is then not clear which sign its values
/// have.
std::optional<messages::Message> against_custom(const NetcdfVariable& variable, const std::string& words) {
  const bool west = contains_any(words, {"westward"}) && !contains_any(words, {"eastward"});
  const bool south = contains_any(words, {"southward"}) && !contains_any(words, {"northward"});
  if (!west && !south) return std::nullopt;
  return messages::ingest_velocity_message<"counts-the-other-way">(
      variable.name(), west ? "westward" : "southward", variable.attribute("long_name"));
}

void describe_current(VelocityMeaning& meaning, const NetcdfVariable& variable,
                      const std::optional<StandardVelocity>& standard,
                      const std::optional<KnownName>& known) {
  const std::string long_name = lower(variable.attribute("long_name"));
  using enum CurrentContent;
  const CurrentContent by_names =
      first_stated({standard ? standard->content : whole, known ? known->content : whole,
                    content_in_name(variable.name())});
  meaning.content = first_stated({by_names, content_in_words(long_name)});
  const bool is_part =
      meaning.content == tide || meaning.content == wave_drift || meaning.content == other_part;
  meaning.on_request = is_part && !(standard && known && by_names == whole);
  using enum WaterPart;
  meaning.part =
      first_stated({standard ? standard->part : unstated, part_in_cell_methods(variable),
                    known ? known->part : unstated, part_in_name(variable.name()), part_in_words(long_name)});
  meaning.depth_m = depth_in_words(variable);
}

/// Whether the variable is the amplitude of one tidal constituent, which is useless without its phase.
bool is_amplitude(const NetcdfVariable& variable) {
  return contains_any(lower(variable.attribute("long_name")), {"amplitude"}) ||
         std::ranges::any_of(parts_of_name(variable.name()), [](const std::string& part) {
           return part == "amp" || part == "amplitude" || part == "ampl";
         });
}

void describe_wind(VelocityMeaning& meaning, const NetcdfVariable& variable) {
  const auto level = wind_level_in_words(variable);
  if (!level) return;
  meaning.at_10_m = level->at_10_m;
  if (!level->at_10_m && meaning.instead.empty()) meaning.instead = "the wind at " + level->words;
}

}  // namespace

CurrentContent content_in_words(const std::string& words) {
  if (contains_any(words, {"detided",
                           "de-tided",
                           "without tide",
                           "without the tide",
                           "no tide",
                           "non-tidal",
                           "nontidal",
                           "tide removed",
                           "tides removed",
                           "tide-free",
                           "tidal signal removed",
                           "tide excluded",
                           "tides excluded",
                           "residual current",
                           "residual velocity",
                           "excluding tide",
                           "excluding the tide",
                           "tidally averaged",
                           "tidally-averaged",
                           "tidally filtered",
                           "tidal residual"}))
    return CurrentContent::without_tide;
  const bool several =
      contains_any(words, {"total", "+", "includ", "incl.", "with tid", "with the tid", "with wave",
                           "with stokes", " and tid", " and wave", " and stokes", " and drift", " plus ", "&",
                           "combined", "tide-resolving", "tide resolving"});
  if (several && contains_any(words, {"tide", "tidal", "wave", "stokes drift"})) return CurrentContent::total;
  if (contains_any(words, {"total velocity", "total current"})) return CurrentContent::total;
  if (contains_any(words, {"without", "exclud", "except", "minus"})) return CurrentContent::whole;
  if (contains_any(words, {"stokes drift", "stokes_drift", "wave-induced", "wave induced"}))
    return CurrentContent::wave_drift;
  if (contains_any(words, {"tide-induced", "tide induced", "tidal current", "tidal velocity", "tide current",
                           "tide velocity", "tidal component", "tidal eastward", "tidal northward", "tidal u",
                           "tidal v", "tidal zonal", "tidal meridional", "due to tide", "due to the tide"}) ||
      words.ends_with("tide"))
    return CurrentContent::tide;
  if (contains_any(words,
                   {"ekman velocity", "ekman current", "ekman drift", "baroclinic velocity",
                    "baroclinic component", "bolus velocity", "eddy-induced", "eddy velocity", "eddy current",
                    "eddy component", "velocity fluctuation", "current fluctuation", "fluctuating",
                    "perturbation", "ageostrophic velocity", "ageostrophic component", "inertial current"}))
    return CurrentContent::other_part;
  if (contains_any(words, {"geostrophic"}) &&
      !contains_any(words, {"+", "includ", "incl.", " and ", "ekman"}))
    return CurrentContent::geostrophic;
  return CurrentContent::whole;
}

CurrentContent content_in_name(std::string_view name) {
  for (const std::string& part : parts_of_name(name)) {
    if (part == "tide" || part == "tides" || part == "tidal" || part == "utide" || part == "vtide")
      return CurrentContent::tide;
    if (part == "stokes") return CurrentContent::wave_drift;
    if (part == "ekman" || part == "baroclinic" || part == "bolus") return CurrentContent::other_part;
    if (part == "detided" || part == "notide" || part == "nontidal" || part == "residual")
      return CurrentContent::without_tide;
    if (part == "total" || part == "utotal" || part == "vtotal") return CurrentContent::total;
    if (part == "geostrophic") return CurrentContent::geostrophic;
  }
  return CurrentContent::whole;
}

WaterPart part_in_name(std::string_view name) {
  for (const std::string& part : parts_of_name(name)) {
    if (part == "sur" || part == "surf" || part == "surface" || part == "sfc") return WaterPart::surface;
    if (part == "ubar" || part == "vbar" || part == "bar" || part == "barotropic" || part == "davg")
      return WaterPart::column_mean;
    const bool is_mean = part == "averaged" || part == "average" || part == "avg";  // over depth or over time
    if (is_mean && contains_any(lower(name), {"depth"})) return WaterPart::column_mean;
    if (part == "bottom" || part == "bot" || part == "seafloor" || part == "bed") return WaterPart::bed;
  }
  return WaterPart::unstated;
}

std::string content_words(CurrentContent content) {
  switch (content) {
    case CurrentContent::whole: return "currents";
    case CurrentContent::total: return "currents with the tide";
    case CurrentContent::without_tide: return "currents without the tide";
    case CurrentContent::geostrophic: return "geostrophic currents";
    case CurrentContent::tide: return "the tide alone";
    case CurrentContent::wave_drift: return "the drift by waves alone";
    case CurrentContent::other_part: return "a part of the current alone";
  }
  return {};
}

std::optional<Component> stated_component(const NetcdfVariable& variable) {
  if (const auto standard = standard_velocity(standard_name_of(variable))) return standard->component;
  return component_in_long_name(lower(variable.attribute("long_name")));
}

std::optional<VelocityMeaning> velocity_meaning(const NetcdfVariable& variable, Moving what) {
  if (!variable.is_numeric() || variable.dimensions().empty()) return std::nullopt;
  const std::string standard_name = standard_name_of(variable);
  const std::string words = standard_and_long_name(variable);
  const auto standard = standard_velocity(standard_name);
  const auto known = known_name(variable.name(), what);
  if (standard ? standard->what != what : !known || names_another_quantity(standard_name, what))
    return std::nullopt;
  if (!standard && known->generic && !speaks_of(words, what)) return std::nullopt;
  if (!standard && known->needs_words && part_in_words(words) != known->part) return std::nullopt;
  if (is_no_speed(variable, words, what)) return std::nullopt;
  // Names that are not known count only if the unit is a speed.
  const bool is_guess = !standard && known->rank == unknown_rank(what);
  if (is_guess && (variable.dimensions().size() < 2 || !speed_factor(variable.attribute("units"))))
    return std::nullopt;

  VelocityMeaning meaning;
  meaning.axes = stated_axes(variable, what);
  meaning.rank = known ? known->rank : unknown_rank(what);
  meaning.instead = is_amplitude(variable) ? "the amplitude of a tide" : in_words(statistic_of(variable));
  const std::string long_name = lower(variable.attribute("long_name"));
  settle_component(meaning, variable,
                   {.standard_name = standard ? std::optional{standard->component} : std::nullopt,
                    .long_name = component_in_long_name(long_name),
                    .name = known ? std::optional{known->component} : component_in_name(variable.name())});
  if (!meaning.contradiction) meaning.contradiction = against_custom(variable, long_name);
  if (what == Moving::sea) {
    describe_current(meaning, variable, standard, known);
  } else {
    describe_wind(meaning, variable);
  }
  return meaning;
}

}  // namespace floeplan::ingest
