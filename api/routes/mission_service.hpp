#pragma once

#include <tl/expected.hpp>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/mission/goto_lists.hpp"
#include "storage/repository/plan_repository.hpp"

namespace floeplan::routes {

/// The GliderDOS goto lists of a stored plan, within the limits of its vehicle. One function for API and
/// command line. `number`  of the first list; `generated`: the time that the files' comments name
/// Errors   every fault of plan or options, as mission::write_goto_lists
[[nodiscard]] tl::expected<mission::GotoLists, core::Violations> mission_of(
    const repository::PlanRecord& record, int number, core::UtcTime generated);

}  // namespace floeplan::routes
