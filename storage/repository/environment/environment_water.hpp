#pragma once

#include "storage/repository/environment/environment_draft.hpp"

namespace floeplan::repository {

/// Adds the currents, one dataset or an ensemble, with tides if they are asked for.
/// Precondition  the icebergs have been added: currents are needed from their oldest sighting on
/// Errors   are among the draft's violations
void add_water(EnvironmentDraft& draft);

}  // namespace floeplan::repository
