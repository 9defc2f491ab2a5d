#include "engine/avoidance/soundings.hpp"

#include <algorithm>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {

void Soundings::take(const Sounding& found, bool renews_depth) {
  const auto known = list_.begin() + static_cast<std::ptrdiff_t>(size_);
  const auto near = std::find_if(list_.begin(), known, [&](const Sounding& sounding) {
    return distance_m(sounding.place, found.place) < apart_m;
  });
  if (near != known) {
    near->time_s = found.time_s;
    if (renews_depth) near->depth_m = found.depth_m;
    return;
  }
  if (size_ < list_.size()) {
    list_[size_++] = found;
    return;
  }
  *std::ranges::min_element(list_, {}, &Sounding::time_s) = found;
}

}  // namespace floeplan::avoidance
