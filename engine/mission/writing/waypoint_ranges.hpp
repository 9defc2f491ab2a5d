#pragma once

#include <cstddef>
#include <string>

namespace floeplan::mission {

/// The numbers of the waypoints after the start for which `is_so` is true, such as "2, 4 to 7"; empty: none.
/// `count`: number of waypoints, start included.
template <class IsSo>
[[nodiscard]] std::string waypoint_ranges(std::size_t count, const IsSo& is_so) {
  std::string text;
  for (std::size_t first = 1; first < count; ++first) {
    if (!is_so(first)) continue;
    std::size_t last = first;
    while (last + 1 < count && is_so(last + 1)) ++last;
    text += (text.empty() ? "" : ", ") + std::to_string(first);
    if (last > first) text += " to " + std::to_string(last);
    first = last;
  }
  return text;
}

}  // namespace floeplan::mission
