#include "engine/ocean/ice/sighting_age.hpp"

#include <algorithm>
#include <chrono>

namespace floeplan::ocean {

core::UtcTime oldest_that_counts(core::UtcTime as_of, core::UtcTime depart, core::Seconds max_age) {
  return std::chrono::floor<std::chrono::days>(std::min(as_of, depart) - max_age);
}

core::UtcTime too_old_from(core::UtcTime observed, core::Seconds max_age) {
  return std::chrono::floor<std::chrono::days>(observed) + std::chrono::days{1} + max_age;
}

}  // namespace floeplan::ocean
