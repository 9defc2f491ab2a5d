#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/missing_marks.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// Facts about all values of a variable, from which its unit can be inferred.
struct Found {
  Extent extent{};           // range of the values that are not missing
  bool whole_numbers{true};  // all values are whole numbers
  std::int64_t values{};
  std::int64_t undeclared{};  // number of impossible values, which count as missing
};

/// Conversion of a variable's numbers to fractions of 1 or to metres.
struct IceUnit {
  double factor{1.0};
  Extent possible{};  // in the variable's unit
};

/// The unit of a concentration: the one that the variable states ("1", "%", tenths), or else the one given by
/// the user (IngestOptions::unit, "share" or "percent"). If there is neither: factor zero, and the range that
/// is possible in any unit.
/// Errors   a unit that is not a fraction
[[nodiscard]] Checked<IceUnit> stated_unit_of_concentration(const NetcdfVariable& variable,
                                                            const std::optional<std::string>& given);

/// Confirms the unit by the values of the variable. They must fit the stated or given unit. Without one, they
/// are fractions or percent, if only one of the two is possible.
/// Errors   values that contradict the unit, or that are possible in both units
[[nodiscard]] Checked<IceUnit> settled_unit_of_concentration(const NetcdfVariable& variable, IceUnit stated,
                                                             const Found& found, Messages& warnings);

/// Metres per unit of a thickness. Without a unit it is metres, with a warning.
[[nodiscard]] Checked<IceUnit> unit_of_thickness(const NetcdfVariable& variable, Messages& warnings);

/// Refuses a thickness that no sea ice has.
/// Errors   thicker than 50 m
[[nodiscard]] Checked<bool> check_thickness(const NetcdfVariable& variable, const IceUnit& unit,
                                            const Found& found);

}  // namespace floeplan::ingest
