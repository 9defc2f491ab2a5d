#include "engine/mission/list_parts.hpp"

#include <algorithm>
#include <string>

#include "engine/mission/below_ice.hpp"

namespace floeplan::mission {
namespace {

std::string waypoints_text(std::size_t first, std::size_t last) {
  return first == last ? "waypoint " + std::to_string(first)
                       : "waypoints " + std::to_string(first) + " to " + std::to_string(last);
}

/// Of the list that begins with this waypoint.
std::size_t last_of_list(const planning::Plan& plan, std::size_t first, std::size_t max_waypoints) {
  const std::size_t farthest = std::min(first + max_waypoints, plan.waypoints.size()) - 1;
  for (const Overhead wanted : {Overhead::open, Overhead::unknown}) {
    for (std::size_t last = farthest; last >= first; --last) {
      if (overhead(plan, last) == wanted) return last;
    }
  }
  return farthest;
}

}  // namespace

std::vector<ListPart> part_into_lists(const planning::Plan& plan, std::size_t max_waypoints) {
  std::vector<ListPart> parts;
  for (std::size_t first = 1; first < plan.waypoints.size();) {
    parts.push_back({first, last_of_list(plan, first, max_waypoints)});
    first = parts.back().last + 1;
  }
  return parts;
}

core::Violations list_end_violations(const planning::Plan& plan, std::size_t max_waypoints) {
  core::Violations found;
  const std::size_t count = plan.waypoints.size();
  for (std::size_t first = 1; first < count; ++first) {
    if (overhead(plan, first) != Overhead::closed) continue;
    std::size_t last = first;
    while (last + 1 < count && overhead(plan, last + 1) == Overhead::closed) ++last;
    if (last + 1 == count) {
      found.push_back({"/waypoints/" + std::to_string(last),
                       "is the end of the plan and lies below ice or icebergs, yet the vehicle comes up "
                       "where its list is flown: plan on to open water"});
    } else if (last - first + 1 >= max_waypoints) {
      found.push_back(
          {"/waypoints", "must not be so many below ice or icebergs: " + waypoints_text(first, last) +
                             " lie there, a list holds " + std::to_string(max_waypoints) +
                             ", and the vehicle comes up where its list is flown; plan anew with "
                             "--max-waypoints or a longer --max-leg"});
    }
    first = last;
  }
  return found;
}

}  // namespace floeplan::mission
