#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/missing_marks.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The unit of a variable, found from all its values.
struct Found {
  Extent extent{};           // of the values that are not missing
  bool whole_numbers{true};  // all of them
  std::int64_t values{};
  std::int64_t undeclared{};  // outside what is possible, taken as missing
};

/// How a variable's numbers become shares of one or metres.
struct IceUnit {
  double factor{1.0};
  Extent possible{};  // in the variable's unit
};

/// The unit that a concentration states ("1", "%", tenths); with none, the extent for which every unit is possible
/// and a factor of zero.
/// Errors   a unit that is no share
[[nodiscard]] Checked<IceUnit> stated_unit_of_concentration(const NetcdfVariable& variable);

/// Settles the unit by what was found in it: values that fit the stated unit; or, with none stated, shares of one or
/// percent if only one of both is possible.
/// Errors   values that contradict the unit, or leave it open
[[nodiscard]] Checked<IceUnit> settled_unit_of_concentration(const NetcdfVariable& variable, IceUnit stated,
                                                             const Found& found, Messages& warnings);

/// Metres in one of the unit of a thickness; without a unit metres, said in `warnings`.
[[nodiscard]] Checked<IceUnit> unit_of_thickness(const NetcdfVariable& variable, Messages& warnings);

/// Errors   thicker than any sea ice
[[nodiscard]] Checked<bool> check_thickness(const NetcdfVariable& variable, const IceUnit& unit,
                                            const Found& found);

}  // namespace floeplan::ingest
