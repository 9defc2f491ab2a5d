#pragma once

#include <vector>

#include "api/fields/field.hpp"

namespace floeplan::fields {

/// Processes whose inputs the table of request fields describes.
enum class Process { plan_route, evaluate_route, reach };

/// All fields of a process, including the members of its objects, except those of `vehicle`.
[[nodiscard]] std::vector<Field> fields_of(Process process);

/// The fields of evaluate-route, except those that state the route.
[[nodiscard]] std::vector<Field> conditions_of_route();

/// The members of the object `vehicle`: the vehicle's build, and the settings that a pilot changes between
/// missions.
[[nodiscard]] std::vector<Field> fields_of_vehicle();

}  // namespace floeplan::fields
