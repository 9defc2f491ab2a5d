#pragma once

#include <span>

namespace floeplan::repository {

/// Scripts that lead from one schema to the next. A released script is never changed; new ones go to the end.
/// Foreign keys are not enforced while a script runs, so that a table can be rebuilt; they are checked at the end.
/// Longitudes in the box tables run eastwards from [-180, 180), so a box across the antimeridian ends beyond
/// 180.
[[nodiscard]] std::span<const char* const> schema_scripts();

}  // namespace floeplan::repository
