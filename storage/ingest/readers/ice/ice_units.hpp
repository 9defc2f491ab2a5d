#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/missing_marks.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// What all values of a variable show about its unit.
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

/// The unit that a concentration states ("1", "%", tenths). A variable without a unit has the one that the user gave
/// for it (IngestOptions::unit: "share" or "percent"); if the user gave none, the extent for which every unit is possible
/// and a factor of zero.
/// Errors   a unit that is no share
[[nodiscard]] Checked<IceUnit> stated_unit_of_concentration(const NetcdfVariable& variable,
                                                            const std::optional<std::string>& given);

/// Settles the unit by the values of the variable: they must fit the unit that was stated or given; without such a unit
/// they are shares of one or percent if only one of both is possible.
/// Errors   values that contradict the unit, or that both units could have
[[nodiscard]] Checked<IceUnit> settled_unit_of_concentration(const NetcdfVariable& variable, IceUnit stated,
                                                             const Found& found, Messages& warnings);

/// Metres in one of the unit of a thickness; without a unit metres, said in `warnings`.
[[nodiscard]] Checked<IceUnit> unit_of_thickness(const NetcdfVariable& variable, Messages& warnings);

/// Errors   thicker than any sea ice
[[nodiscard]] Checked<bool> check_thickness(const NetcdfVariable& variable, const IceUnit& unit,
                                            const Found& found);

}  // namespace floeplan::ingest
