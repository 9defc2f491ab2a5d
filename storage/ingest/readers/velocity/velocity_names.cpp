#include "storage/ingest/readers/velocity/velocity_names.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

struct KnownPair {
  std::string_view first;
  std::string_view second;
  bool generic{false};
  CurrentContent content{CurrentContent::whole};
  WaterPart part{WaterPart::unstated};
  bool needs_words{false};
};

constexpr KnownPair currents_known[]{
    {"uo", "vo"},
    {"water_u", "water_v"},
    {"utotal", "vtotal", false, CurrentContent::total},
    {"ugos", "vgos", false, CurrentContent::geostrophic, WaterPart::surface},
    {"u_eastward", "v_northward", true},
    {"eastward_eulerian_current_velocity", "northward_eulerian_current_velocity"},
    {"vozocrtx", "vomecrty"},
    {"vxo", "vyo"},
    {"uvel", "vvel", true},
    {"u_velocity", "v_velocity", true},
    {"u-vel", "v-vel", true},
    {"hvel[0]", "hvel[1]"},
    {"dahv[0]", "dahv[1]", false, CurrentContent::whole, WaterPart::column_mean},
    {"depthaveragevelx", "depthaveragevely", false, CurrentContent::whole, WaterPart::column_mean},
    {"u", "v", true},
    {"ssu", "ssv", false, CurrentContent::whole, WaterPart::surface},
    {"uos", "vos", false, CurrentContent::whole, WaterPart::surface},
    {"sozocrtx", "somecrty", false, CurrentContent::whole, WaterPart::surface},
    {"u_sur_eastward", "v_sur_northward", false, CurrentContent::whole, WaterPart::surface},
    {"u_sur", "v_sur", false, CurrentContent::whole, WaterPart::surface},
    {"u_surf", "v_surf", true, CurrentContent::whole, WaterPart::surface},
    {"surf_u", "surf_v", true, CurrentContent::whole, WaterPart::surface},
    {"usurf", "vsurf", true, CurrentContent::whole, WaterPart::surface},
    {"ubar_eastward", "vbar_northward", false, CurrentContent::whole, WaterPart::column_mean},
    {"ubar", "vbar", false, CurrentContent::whole, WaterPart::column_mean},
    {"u_barotropic_velocity", "v_barotropic_velocity", false, CurrentContent::whole, WaterPart::column_mean},
    {"ua", "va", true, CurrentContent::whole, WaterPart::column_mean, true},
    {"utide", "vtide", false, CurrentContent::tide},
    {"vsdx", "vsdy", false, CurrentContent::wave_drift, WaterPart::surface},
    {"ustokes", "vstokes", false, CurrentContent::wave_drift, WaterPart::surface},
};

constexpr KnownPair winds_known[]{
    {"u10", "v10"},
    {"10u", "10v"},
    {"u10m", "v10m"},
    {"uas", "vas"},
    {"eastward_wind", "northward_wind"},
    {"u-component_of_wind_height_above_ground", "v-component_of_wind_height_above_ground"},
    {"ugrd10m", "vgrd10m"},
    {"ugrd_10maboveground", "vgrd_10maboveground"},
    {"x_wind_10m", "y_wind_10m"},
    {"uwnd", "vwnd"},
    {"wind_speed[0]", "wind_speed[1]"},
    {"windx", "windy"},
    {"u100", "v100"},
    {"100u", "100v"},
    {"u100m", "v100m"},
    {"u", "v", true},
};

std::span<const KnownPair> known_pairs_of(Moving what) {
  if (what == Moving::sea) return currents_known;
  return winds_known;
}

// endings of the first and of the second component
using Ends = std::pair<std::string_view, std::string_view>;

/// Parts in which the names of two components differ.
constexpr Ends differences[]{{"u", "v"},    {"x", "y"},   {"east", "north"},
                             {"e", "n"},    {"ew", "ns"}, {"zonal", "meridional"},
                             {"lon", "lat"}};

bool differ_by_component(std::string_view a, std::string_view b) {
  std::size_t before = 0;
  while (before < a.size() && before < b.size() && a[before] == b[before]) ++before;
  a.remove_prefix(before);
  b.remove_prefix(before);
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    a.remove_suffix(1);
    b.remove_suffix(1);
  }
  return std::ranges::any_of(differences, [&](const Ends& ends) {
    return (a == ends.first && b == ends.second) || (a == ends.second && b == ends.first);
  });
}

/// Core of a standard name, and its component.
struct Core {
  std::string_view text;
  Component component;
};

constexpr Core cores[]{
    {"eastward_sea_water_velocity", Component::first}, {"northward_sea_water_velocity", Component::second},
    {"x_sea_water_velocity", Component::first},        {"y_sea_water_velocity", Component::second},
    {"sea_water_x_velocity", Component::first},        {"sea_water_y_velocity", Component::second},
    {"eastward_water_velocity", Component::first},     {"northward_water_velocity", Component::second},
};

constexpr Core winds[]{{"eastward_wind", Component::first},
                       {"northward_wind", Component::second},
                       {"x_wind", Component::first},
                       {"y_wind", Component::second}};

/// Whether all words before the core are known. Adds their meaning to `velocity`.
bool take_before(std::string_view before, StandardVelocity& velocity) {
  return std::ranges::all_of(parts_of_name(before), [&](const std::string& word) {
    if (word == "surface") {
      velocity.part = WaterPart::surface;
    } else if (word == "barotropic" || word == "depth" || word == "vertically") {
      velocity.part = WaterPart::column_mean;
    } else if (word == "geostrophic") {
      velocity.content = CurrentContent::geostrophic;
    } else if (word == "tidal") {
      velocity.content = CurrentContent::tide;
    } else if (word == "baroclinic" || word == "bolus" || word == "ageostrophic" || word == "ekman") {
      velocity.content = CurrentContent::other_part;
    } else {
      return word == "sea" || word == "averaged" || word == "mean" || word == "total";
    }
    return true;
  });
}

/// The same for the words after the core. "assuming sea level for geoid" marks an anomaly, which is not a
/// current.
bool take_behind(std::string_view behind, StandardVelocity& velocity) {
  if (behind.empty()) return true;
  if (behind == "_assuming_no_tide") {
    velocity.content = CurrentContent::without_tide;
  } else if (behind.starts_with("_due_to_tide")) {
    velocity.content = CurrentContent::tide;
  } else if (behind.starts_with("_due_to_")) {
    velocity.content = CurrentContent::other_part;
  } else if (behind == "_at_sea_floor") {
    velocity.part = WaterPart::bed;
  } else if (behind == "_at_sea_surface" || behind == "_at_surface") {
    velocity.part = WaterPart::surface;
  } else if (behind.starts_with("_vertical_mean") || behind.starts_with("_depth_mean")) {
    velocity.part = WaterPart::column_mean;
  } else {
    return false;
  }
  return true;
}

constexpr std::string_view of_first[]{"u", "uo", "east", "eastward", "x", "zonal", "ucx", "utotal"};
constexpr std::string_view of_second[]{"v", "vo", "north", "northward", "y", "meridional", "ucy", "vtotal"};

template <class Words>
bool is_one_of(std::string_view word, const Words& words) {
  return std::ranges::find(words, word) != std::end(words);
}

/// Words in a name that only currents of the sea have.
constexpr std::string_view of_currents[]{"current", "currents", "curr", "cur"};
/// Words that may accompany the words above and the component; without the words above only if the long name
/// names the sea. Any other word (stress, error, ice) makes the name another quantity.
constexpr std::string_view beside_currents[]{
    "sea",     "water",    "ocean", "vel",        "velocity", "component", "comp",
    "total",   "surface",  "surf",  "sur",        "sfc",      "depth",     "avg",
    "average", "averaged", "mean",  "barotropic", "residual", "tidal",     "tide"};

/// Meaning of a name that joins a component with words for a current: "curr_east", "ucurr", "u_residual".
std::optional<KnownName> composed_name(const std::string& plain) {
  const std::vector<std::string> parts = parts_of_name(plain);
  KnownName known{.generic = true};
  bool first = false;
  bool second = false;
  for (const std::string& part : parts) {
    const std::string_view rest = std::string_view{part}.substr(1);
    if (is_one_of(part, of_first) || is_one_of(part, of_second)) {
      (is_one_of(part, of_first) ? first : second) = true;
    } else if (is_one_of(part, of_currents)) {
      known.generic = false;
    } else if (is_one_of(rest, of_currents) &&
               std::string_view{"uvxy"}.find(part[0]) != std::string_view::npos) {
      (part[0] == 'u' || part[0] == 'x' ? first : second) = true;
      known.generic = false;
    } else if (!is_one_of(part, beside_currents)) {
      return std::nullopt;
    }
  }
  const bool bare = parts.size() == 1 && known.generic;  // "x" or "east" alone is an axis
  if (first == second || bare) return std::nullopt;
  known.component = first ? Component::first : Component::second;
  known.rank = unknown_rank(Moving::sea);
  return known;
}

/// Meaning of a variable's name that is spelt like a standard name; otherwise empty.
std::optional<KnownName> standard_as_name(const std::string& plain, Moving what) {
  const auto velocity = standard_velocity(plain);
  if (!velocity || velocity->what != what) return std::nullopt;
  return KnownName{.component = velocity->component,
                   .content = velocity->content,
                   .part = velocity->part,
                   .rank = unknown_rank(what)};
}

}  // namespace

std::optional<KnownName> known_name(std::string_view name, Moving what) {
  const std::string plain = lower(name);
  const std::span<const KnownPair> pairs = known_pairs_of(what);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const KnownPair& pair = pairs[i];
    if (plain != pair.first && plain != pair.second) continue;
    return KnownName{.component = plain == pair.first ? Component::first : Component::second,
                     .content = pair.content,
                     .part = pair.part,
                     .generic = pair.generic,
                     .needs_words = pair.needs_words,
                     .rank = i};
  }
  if (auto standard = standard_as_name(plain, what)) return standard;
  return what == Moving::sea ? composed_name(plain) : std::nullopt;
}

std::size_t unknown_rank(Moving what) { return known_pairs_of(what).size(); }

bool name_one_pair(std::string_view a, std::string_view b) {
  for (const Moving what : {Moving::sea, Moving::air}) {
    const auto first = known_name(a, what);
    const auto second = known_name(b, what);
    const bool listed = first && second && std::min(first->rank, second->rank) < unknown_rank(what);
    if (listed) return first->rank == second->rank && first->component != second->component;
  }
  const std::vector<std::string> left = parts_of_name(a);
  const std::vector<std::string> right = parts_of_name(b);
  bool differ = false;
  const bool related = std::ranges::equal(left, right, [&](const std::string& x, const std::string& y) {
    if (x == y) return true;
    differ = true;
    return differ_by_component(x, y);
  });
  return related && differ;
}

std::optional<Component> component_in_name(std::string_view name) {
  bool first = false;
  bool second = false;
  for (const std::string& part : parts_of_name(name)) {
    first = first || is_one_of(part, of_first);
    second = second || is_one_of(part, of_second);
  }
  if (first == second) return std::nullopt;
  return first ? Component::first : Component::second;
}

std::optional<StandardVelocity> standard_velocity(std::string_view standard_name) {
  for (const Core& core : winds)
    if (standard_name == core.text) return StandardVelocity{.what = Moving::air, .component = core.component};
  if (standard_name.find("stokes_drift") != std::string_view::npos) {
    const bool first = contains_any(standard_name, {"x_velocity", "eastward"});
    const bool second = contains_any(standard_name, {"y_velocity", "northward"});
    if (first == second) return std::nullopt;
    return StandardVelocity{.component = first ? Component::first : Component::second,
                            .content = CurrentContent::wave_drift,
                            .part = WaterPart::surface};
  }
  for (const Core& core : cores) {
    const std::size_t at = standard_name.find(core.text);
    const bool whole_words = at == 0 || (at != std::string_view::npos && standard_name[at - 1] == '_');
    if (!whole_words) continue;
    StandardVelocity velocity{.component = core.component};
    const bool known = take_before(standard_name.substr(0, at), velocity) &&
                       take_behind(standard_name.substr(at + core.text.size()), velocity);
    return known ? std::optional{velocity} : std::nullopt;
  }
  return std::nullopt;
}

bool names_another_quantity(std::string_view standard_name, Moving what) {
  if (standard_name.find('_') == std::string_view::npos || standard_velocity(standard_name)) return false;
  if (contains_any(standard_name, {"ice", "wave", "stress", "tendency", "product_of", "square_of", "upward",
                                   "downward", "radial", "flux", "transport", "geoid", "shear"}))
    return true;
  const bool of_air = contains_any(standard_name, {"wind", "air_"});
  if (what == Moving::air) return !of_air;
  return of_air || !contains_any(standard_name, {"velocity", "current", "vel_", "_vel"});
}

}  // namespace floeplan::ingest
