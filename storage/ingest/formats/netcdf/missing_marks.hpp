#pragma once

#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The range of possible values of a quantity, in the unit of its variable.
struct Extent {
  double least{};
  double greatest{};
  [[nodiscard]] bool contains(double value) const { return value >= least && value <= greatest; }
};

/// Decides which values of a variable mean "missing". These are: the fill value; flags for land, a coast, the
/// gap of satellite orbits at the pole or a missing value; and impossible values of the quantity that are
/// flags, lie outside the valid range or are numbers that producers commonly use without declaring them. A
/// valid range alone never excludes a possible value: some files state it for packed numbers, some for
/// unpacked ones.
/// Source   CF conventions 1.8, sections 2.5.1 (missing data) and 3.5 (flags)
class MissingMarks {
 public:
  explicit MissingMarks(const NetcdfVariable& variable);

  /// Whether `value`, unpacked and NaN for the fill value, means "missing".
  [[nodiscard]] bool cover(double value, Extent possible) const;

 private:
  std::vector<double> flags_;             // all flags, unpacked
  std::vector<double> flags_of_absence_;  // flags whose meaning is that there is no value
  Extent valid_;                          // declared valid range, unpacked
};

}  // namespace floeplan::ingest
