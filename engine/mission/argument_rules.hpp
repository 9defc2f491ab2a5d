#pragma once

#include "engine/mission/document.hpp"

namespace floeplan::mission {

/// A value from which on the firmware of a back-seat driver takes a number as the name of a mission
/// parameter (`u_mission_param_a` and its like) instead of as itself.
/// Source   missions published with dsor-isr/slocum_glider
inline constexpr double first_mission_parameter = 1'000'000.0;

/// Judges the arguments of one behavior against the dictionary.
void check_arguments(const Behavior& behavior, Messages& messages);

/// Notes settings that are given more than once; where `conflicts` holds, different values are an error.
void check_duplicates(const std::vector<Argument>& settings, bool conflicts, Messages& messages);

}  // namespace floeplan::mission
