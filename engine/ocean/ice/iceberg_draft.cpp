#include "engine/ocean/ice/iceberg_draft.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::ocean {
namespace {

constexpr double longest_of_barker_m = 160.0;

double barker_draft_m(double length_m) { return 2.91 * std::pow(length_m, 0.71); }
double hotzel_miller_draft_m(double length_m) { return 3.78 * std::pow(length_m, 0.63); }
double ccore_draft_m(double length_m) { return 1.78 * std::pow(length_m, 0.71); }

}  // namespace

core::Metres safe_draft(const Iceberg& iceberg) {
  if (iceberg.draft) return *iceberg.draft;
  const double length_m = safe_length(iceberg).value;
  const double draft_m = barker_draft_m(std::min(length_m, longest_of_barker_m));
  if (length_m <= longest_of_barker_m) return {draft_m};
  return {std::max(draft_m, hotzel_miller_draft_m(length_m))};
}

core::Metres drift_draft(const Iceberg& iceberg) {
  return iceberg.draft.value_or(core::Metres{ccore_draft_m(safe_length(iceberg).value)});
}

}  // namespace floeplan::ocean
