#pragma once

#include <vector>

#include "engine/mission/document/document.hpp"
#include "engine/mission/writing/hold_lists.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// Places no further apart are the same: files hold them to a fifth of a metre.
inline constexpr core::Metres same_waypoint{10.0};
/// A hold that is longer or shorter by no more of itself lasts as planned.
inline constexpr double same_hold = 0.1;

/// Compares the goto lists among the documents, in their order, with a plan, and adds to their messages where they order
/// otherwise: waypoints that are left out or are not of the plan; holds that are missing, not planned, elsewhere, wider
/// than the circle that the plan found clear, or of another length by hold_time. A note where they order the same.
/// Lists to recover by, rejected documents and other files have no part in it.
/// `holds`  as the plan's lists are written
void compare_with_plan(std::vector<Document>& documents, const planning::Plan& plan,
                       const HoldOptions& holds);

}  // namespace floeplan::mission
