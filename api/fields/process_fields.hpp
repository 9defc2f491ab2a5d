#pragma once

#include <vector>

#include "api/fields/field.hpp"

namespace floeplan::fields {

/// Processes whose inputs the table of request fields describes.
enum class Process { plan_route, evaluate_route, reach };

/// Every field of the inputs of a process, with the members of their objects but for those of `vehicle`.
[[nodiscard]] std::vector<Field> fields_of(Process process);

/// The same without what says which route is meant.
[[nodiscard]] std::vector<Field> conditions_of_route();

/// The members of the object `vehicle`: the build of one, and what a pilot sets beside it, too.
[[nodiscard]] std::vector<Field> fields_of_vehicle();

}  // namespace floeplan::fields
