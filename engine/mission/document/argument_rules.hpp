#pragma once

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Whether the firmware of a back-seat driver takes the number as the name of a mission parameter: 1000000 is
/// `u_mission_param_a`, 1000001 `u_mission_param_b`, up to one per letter.
/// Source   missions published with dsor-isr/slocum_glider
[[nodiscard]] constexpr bool is_mission_parameter(double value) {
  constexpr int first = 1'000'000;
  constexpr int letters = 26;
  return value >= first && value < first + letters && value == static_cast<int>(value);
}

/// Checks the arguments of one behavior against the dictionary.
void check_arguments(const Behavior& behavior, Messages& messages);

/// Notes settings that are given more than once; if `conflicts` is true, different values are an error.
void check_duplicates(const std::vector<Argument>& settings, bool conflicts, Messages& messages);

}  // namespace floeplan::mission
