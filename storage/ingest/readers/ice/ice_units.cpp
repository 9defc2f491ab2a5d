#include "storage/ingest/readers/ice/ice_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/messages/ingest_ice_messages.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double share_rounding = 0.005;  // half a per cent, the rounding of products packed in bytes
constexpr double thickest_m = 50.0;       // keels of ridges reach 47 m; the mean of a grid cell is less
constexpr double thickness_rounding_m = 0.01;

bool is_one_of(const std::string& unit, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), unit) != words.end();
}

/// Models that assimilate observations may exceed a concentration of 1: files of the reanalysis GLORYS12
/// reach 1.0096 and declare values up to 1.043 valid. Values up to the variable's own valid_max are accepted,
/// but not beyond this excess.
constexpr double most_overshoot = 0.05;

IceUnit unit_with(double factor) {
  return {factor, {-share_rounding / factor, (1.0 + share_rounding) / factor}};
}

IceUnit with_declared_overshoot(IceUnit unit, const NetcdfVariable& variable) {
  const auto packed = variable.numeric_attribute("valid_max");
  if (!packed) return unit;
  const double declared = std::min(variable.unpacked(*packed), (1.0 + most_overshoot) / unit.factor);
  unit.possible.greatest = std::max(unit.possible.greatest, declared);
  return unit;
}

std::string extent_text(const Found& found) {
  return number(found.extent.least) + " to " + number(found.extent.greatest);
}

bool states_unit(const NetcdfVariable& variable) {
  return !is_one_of(lower(variable.attribute("units")), {"", "unitless", "none"});
}

/// Whether the greatest valid value that the variable declares is 1. NOAA's OISST has such a range with the
/// unit percent.
bool declares_shares(const NetcdfVariable& variable) {
  const auto range = variable.numbers("valid_range");
  const auto packed = range.size() == 2 ? std::optional{range[1]} : variable.numeric_attribute("valid_max");
  return packed && std::abs(variable.unpacked(*packed) - 1.0) <= share_rounding;
}

}  // namespace

Checked<IceUnit> stated_unit_of_concentration(const NetcdfVariable& variable,
                                              const std::optional<std::string>& given) {
  const std::string unit = lower(variable.attribute("units"));
  if (!states_unit(variable)) {
    if (given == "share") return with_declared_overshoot(unit_with(1.0), variable);
    if (given == "percent") return unit_with(0.01);
    IceUnit open = unit_with(0.01);
    open.factor = 0.0;
    return open;
  }
  if (is_one_of(unit, {"1", "1.0", "fraction", "(0-1)", "(0 - 1)", "0-1", "0 - 1", "m2/m2", "m2 m-2"}))
    return with_declared_overshoot(unit_with(1.0), variable);
  if (is_one_of(unit, {"%", "percent", "per cent", "pct", "1e-2", "0.01"})) return unit_with(0.01);
  if (is_one_of(unit, {"tenths", "1/10", "0.1"})) return unit_with(0.1);
  return refuse(messages::ingest_ice_message<"concentration-unit-unknown">(variable.name(),
                                                                           variable.attribute("units")));
}

Checked<IceUnit> settled_unit_of_concentration(const NetcdfVariable& variable, IceUnit stated,
                                               const Found& found, Messages& warnings) {
  const std::string name = "the concentration \"" + variable.name() + "\"";
  const double greatest = found.extent.greatest;
  if (stated.factor > 0.0) {
    const bool given = !states_unit(variable);
    const bool fits = stated.possible.contains(found.extent.least) && stated.possible.contains(greatest);
    if (!fits && given)
      return refuse(messages::ingest_ice_message<"concentration-not-in-the-given-unit">(
          variable.name(), stated.factor == 1.0 ? "share" : "percent", extent_text(found),
          stated.factor == 1.0 ? "percent" : "share"));
    if (!fits)
      return refuse(messages::ingest_ice_message<"concentration-off-scale">(
          variable.name(), variable.attribute("units"), extent_text(found)));
    const bool looks_like_shares =
        !given && stated.factor < 1.0 && greatest > 0.0 && greatest <= 1.0 && !found.whole_numbers;
    if (looks_like_shares && declares_shares(variable)) {
      warnings.push_back(messages::ingest_ice_message<"concentration-taken-as-shares">(
          variable.name(), variable.attribute("units")));
      return unit_with(1.0);
    }
    if (looks_like_shares)
      return refuse(messages::ingest_ice_message<"concentration-like-shares">(
          variable.name(), variable.attribute("units"), number(greatest)));
    return stated;
  }

  if (greatest > 1.5 && stated.possible.contains(greatest) && stated.possible.contains(found.extent.least)) {
    warnings.push_back(messages::ingest_ice_message<"concentration-without-unit">(
        variable.name(), extent_text(found), "percent"));
    return unit_with(0.01);
  }
  const IceUnit shares = unit_with(1.0);
  const bool few_per_cent_possible = greatest <= 0.15;
  if (shares.possible.contains(greatest) && shares.possible.contains(found.extent.least) &&
      !few_per_cent_possible) {
    warnings.push_back(messages::ingest_ice_message<"concentration-without-unit">(
        variable.name(), extent_text(found), "shares of 1"));
    return shares;
  }
  return refuse(
      messages::ingest_ice_message<"concentration-unit-unclear">(variable.name(), extent_text(found)));
}

Checked<IceUnit> unit_of_thickness(const NetcdfVariable& variable, Messages& warnings) {
  const std::string text = variable.attribute("units");
  const auto factor = text.empty() ? std::optional{1.0} : length_factor(text);
  if (!factor) return refuse(messages::ingest_ice_message<"thickness-unit-unknown">(variable.name(), text));
  if (text.empty())
    warnings.push_back(messages::ingest_ice_message<"thickness-without-unit">(variable.name()));
  return IceUnit{*factor, {-thickness_rounding_m / *factor, thickest_m / *factor}};
}

Checked<bool> check_thickness(const NetcdfVariable& variable, const IceUnit& unit, const Found& found) {
  if (unit.possible.contains(found.extent.least) && unit.possible.contains(found.extent.greatest))
    return true;
  return refuse(messages::ingest_ice_message<"thickness-off-scale">(variable.name(), extent_text(found),
                                                                    variable.attribute("units")));
}

}  // namespace floeplan::ingest
