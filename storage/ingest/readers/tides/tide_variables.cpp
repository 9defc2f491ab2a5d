#include "storage/ingest/readers/tides/tide_variables.hpp"

#include <algorithm>
#include <array>

#include "engine/messages/ingest_tide_messages.hpp"
#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/velocity/velocity_meaning.hpp"

namespace floeplan::ingest {
namespace {

using ocean::TideQuantity;

struct KnownTidePair {
  const char* first;  // lower case
  const char* second;
  TideQuantity quantity;
  bool amplitude_and_phase;
};

constexpr std::array known_pairs{
    KnownTidePair{"hre", "him", TideQuantity::elevation, false},
    KnownTidePair{"ure", "uim", TideQuantity::east, false},
    KnownTidePair{"vre", "vim", TideQuantity::north, false},
    KnownTidePair{"amplitude", "phase", TideQuantity::elevation, true},
    KnownTidePair{"ha", "hg", TideQuantity::elevation, true},
    KnownTidePair{"ua", "ug", TideQuantity::east, true},
    KnownTidePair{"va", "vg", TideQuantity::north, true},
    KnownTidePair{"ampl", "phas", TideQuantity::elevation, true},
    KnownTidePair{"uamp", "upha", TideQuantity::east, true},
    KnownTidePair{"vamp", "vpha", TideQuantity::north, true},
};

const NetcdfVariable* field_named(const NetcdfFile& file, const std::string& lower_name) {
  for (const NetcdfVariable& variable : file.variables())
    if (variable.is_numeric() && variable.dimensions().size() >= 2 && lower(variable.name()) == lower_name &&
        statistic_of(variable) == Statistic::none)
      return &variable;
  return nullptr;
}

/// Whether a file has both variables of a pair. Winds and geostrophic currents can also be named ua and ug,
/// so a phase must have a unit of angle.
bool has_pair(const NetcdfFile& file, const KnownTidePair& pair) {
  const NetcdfVariable* second = field_named(file, pair.second);
  if (field_named(file, pair.first) == nullptr || second == nullptr) return false;
  const std::string unit = lower(second->attribute("units"));
  return !pair.amplitude_and_phase || unit.empty() || unit.starts_with("deg") || unit.starts_with("rad");
}

/// Whether a variable's attributes say that it is the other component.
bool contradicts(const NetcdfVariable& variable, TideQuantity quantity) {
  const auto stated = stated_component(variable);
  return stated && ((quantity == TideQuantity::east && *stated == Component::second) ||
                    (quantity == TideQuantity::north && *stated == Component::first));
}

bool is_roms_forcing(const NetcdfFile& file) {
  return file.find("tide_Eamp") != nullptr || file.find("tide_Cmax") != nullptr ||
         (file.find("ssh_Re") != nullptr && file.find("ssh_Im") != nullptr);
}

bool has_depths(const NetcdfFile& file) {
  return field_named(file, "hu") != nullptr && field_named(file, "hv") != nullptr;
}

/// A unit in short form: "cm2/s" for "centimeter^2/sec".
std::string plain_unit(std::string unit) {
  unit = lower(unit);
  const auto replace = [&](std::string_view from, std::string_view to) {
    for (std::size_t at = unit.find(from); at != std::string::npos; at = unit.find(from, at + to.size()))
      unit.replace(at, from.size(), to);
  };
  replace("millimeters", "mm");
  replace("millimeter", "mm");
  replace("centimeters", "cm");
  replace("centimeter", "cm");
  replace("meters", "m");
  replace("meter", "m");
  replace("metres", "m");
  replace("metre", "m");
  replace("seconds", "s");
  replace("second", "s");
  replace("sec", "s");
  replace("s^-1", "s-1");
  replace("**", "");
  replace("^", "");
  replace(" ", "");
  replace("s-1", "/s");
  replace("//", "/");
  return unit;
}

Checked<bool> read_unit(TideVariables& found) {
  struct Unit {
    const char* name;
    double factor;
    bool transport;
  };
  constexpr std::array lengths{Unit{"m", 1.0, false}, Unit{"cm", 0.01, false}, Unit{"mm", 0.001, false}};
  constexpr std::array flows{Unit{"m/s", 1.0, false}, Unit{"cm/s", 0.01, false}, Unit{"mm/s", 0.001, false},
                             Unit{"m2/s", 1.0, true}, Unit{"cm2/s", 1e-4, true}, Unit{"mm2/s", 1e-6, true}};
  const std::string stated = found.first->attribute("units");
  const std::string unit = plain_unit(stated);
  const auto take = [&](const auto& units) {
    const auto known = std::ranges::find_if(units, [&](const Unit& u) { return unit == u.name; });
    if (known == units.end()) return false;
    found.factor = known->factor;
    found.transport = known->transport;
    return true;
  };
  if (found.quantity == TideQuantity::elevation ? take(lengths) : take(flows)) return true;
  return refuse(messages::ingest_tide_message<"tide-unit-unknown">(found.first->name(), stated));
}

Checked<bool> check_phase(const NetcdfVariable& phase) {
  const std::string unit = lower(phase.attribute("units"));
  if (unit.empty() || unit.starts_with("deg")) return true;
  return refuse(messages::ingest_tide_message<"phase-not-in-degrees">(phase.name(), unit));
}

}  // namespace

bool holds_tides(const NetcdfFile& file) {
  return is_roms_forcing(file) ||
         std::ranges::any_of(known_pairs, [&](const KnownTidePair& pair) { return has_pair(file, pair); });
}

bool needs_tide_depths(const NetcdfFile& file) {
  if (!holds_tides(file) || has_depths(file)) return false;
  const auto tides = find_tides(file);
  return tides && std::ranges::any_of(*tides, &TideVariables::transport);
}

std::optional<TideQuantity> lone_tide_component(const NetcdfFile& file) {
  const auto holds = [&](TideQuantity quantity) {
    return std::ranges::any_of(known_pairs, [&](const KnownTidePair& pair) {
      return pair.quantity == quantity && has_pair(file, pair);
    });
  };
  const bool east = holds(TideQuantity::east);
  if (east == holds(TideQuantity::north)) return std::nullopt;
  return east ? TideQuantity::east : TideQuantity::north;
}

bool holds_tide_depths_alone(const NetcdfFile& file) { return has_depths(file) && !holds_tides(file); }

Checked<std::vector<TideVariables>> find_tides(const NetcdfFile& file) {
  if (is_roms_forcing(file)) return refuse(messages::ingest_tide_message<"roms-forcing">());
  std::vector<TideVariables> tides;
  const auto has = [&](TideQuantity quantity) {
    return std::ranges::find(tides, quantity, &TideVariables::quantity) != tides.end();
  };
  for (const KnownTidePair& pair : known_pairs) {
    const NetcdfVariable* first = field_named(file, pair.first);
    const NetcdfVariable* second = field_named(file, pair.second);
    if (!has_pair(file, pair) || has(pair.quantity)) continue;
    const auto same = [](const NetcdfDimension& a, const NetcdfDimension& b) { return a.name == b.name; };
    if (!std::ranges::equal(first->dimensions(), second->dimensions(), same))
      return refuse(messages::ingest_tide_message<"tide-parts-differ">(first->name(), second->name()));
    if (contradicts(*first, pair.quantity))
      return refuse(messages::ingest_tide_message<"tide-component-contradicts">(
          first->name(), std::string{pair.quantity == TideQuantity::east ? "eastward" : "northward"}));
    TideVariables found{pair.quantity, first, second, pair.amplitude_and_phase};
    if (const auto unit = read_unit(found); !unit) return refuse(unit.error());
    if (pair.amplitude_and_phase)
      if (const auto phase = check_phase(*second); !phase) return refuse(phase.error());
    tides.push_back(found);
  }
  return tides;
}

}  // namespace floeplan::ingest
