#pragma once

#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// What a quantity can be, in the unit of its variable.
struct Extent {
  double least{};
  double greatest{};
  [[nodiscard]] bool contains(double value) const { return value >= least && value <= greatest; }
};

/// Tells which values of a variable stand for "nothing is known here": the fill; flags that mean land, a coast, the
/// hole of a satellite's orbit round the pole or a missing value; and, of what the quantity cannot be, any flag,
/// whatever lies outside the declared valid range, and numbers that producers write without declaring them. A valid
/// range alone never removes a possible value: some files state it for the packed numbers, some for the unpacked.
/// Source   CF conventions 1.8, sections 2.5.1 (missing data) and 3.5 (flags)
class MissingMarks {
 public:
  explicit MissingMarks(const NetcdfVariable& variable);

  /// `value` as the layout's slices give it: unpacked, NaN where it is the fill.
  [[nodiscard]] bool cover(double value, Extent possible) const;

 private:
  std::vector<double> flags_;             // all of them, unpacked
  std::vector<double> flags_of_absence_;  // those whose meaning says that there is no value
  Extent valid_;                          // unpacked
};

}  // namespace floeplan::ingest
