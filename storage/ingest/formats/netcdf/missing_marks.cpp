#include "storage/ingest/formats/netcdf/missing_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Whether producers use this number for land or missing values: numbers of nines, powers of ten, and flags
/// near the end of a byte's range (120 for land in concentrations of the ASI algorithm; 251 to 255 in those
/// of NSIDC).
bool is_customary(double value) {
  constexpr std::array sizes{99.0,  999.0, 9999.0, 99999.0, 10000.0, 32767.0, 32768.0,
                             120.0, 251.0, 252.0,  253.0,   254.0,   255.0};
  return value == -1.0 || std::abs(value) >= 1e10 ||
         std::find(sizes.begin(), sizes.end(), std::abs(value)) != sizes.end();
}

Extent valid_range_of(const NetcdfVariable& variable) {
  Extent range{-infinite, infinite};
  if (const auto both = variable.numbers("valid_range"); both.size() == 2) range = {both[0], both[1]};
  if (const auto least = variable.numbers("valid_min"); least.size() == 1) range.least = least[0];
  if (const auto greatest = variable.numbers("valid_max"); greatest.size() == 1) range.greatest = greatest[0];
  const auto unpacked = [&](double packed) {
    if (std::isinf(packed)) return packed;
    const double value = variable.unpacked(packed);
    return std::isnan(value) ? std::copysign(infinite, packed) : value;
  };
  const double a = unpacked(range.least);
  const double b = unpacked(range.greatest);
  return {std::min(a, b), std::max(a, b)};
}

bool holds(const std::vector<double>& values, double value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

}  // namespace

MissingMarks::MissingMarks(const NetcdfVariable& variable) : valid_{valid_range_of(variable)} {
  std::istringstream meanings{lower(variable.attribute("flag_meanings"))};
  for (const double packed : variable.numbers("flag_values")) {
    std::string meaning;
    meanings >> meaning;
    const double flag = variable.unpacked(packed);
    flags_.push_back(flag);
    if (contains_any(meaning, {"land", "coast", "lake", "missing", "pole", "hole", "mask", "fill"}))
      flags_of_absence_.push_back(flag);
  }
}

bool MissingMarks::cover(double value, Extent possible) const {
  if (std::isnan(value) || holds(flags_of_absence_, value)) return true;
  if (possible.contains(value)) return false;
  return holds(flags_, value) || !valid_.contains(value) || is_customary(value);
}

}  // namespace floeplan::ingest
