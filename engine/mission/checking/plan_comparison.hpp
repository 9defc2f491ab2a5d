#pragma once

#include <vector>

#include "engine/mission/document/document.hpp"
#include "engine/mission/writing/hold_lists.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// Places at most this far apart count as the same: files store them to a fifth of a metre.
inline constexpr core::Metres same_waypoint{10.0};
/// A hold may be longer or shorter than planned by this share.
inline constexpr double same_hold = 0.1;

/// Compares the goto lists among the documents, in order, with a plan, and adds messages about differences:
/// waypoints left out or not in the plan; holds that are missing, not planned, at another place, wider than
/// the circle that the plan found clear, or of another length (hold_time). A note if there is no difference.
/// Recovery lists, rejected documents and other files are ignored.
/// `holds`  options with which the plan's lists are written
void compare_with_plan(std::vector<Document>& documents, const planning::Plan& plan,
                       const HoldOptions& holds);

}  // namespace floeplan::mission
