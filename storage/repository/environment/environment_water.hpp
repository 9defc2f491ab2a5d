#pragma once

#include "storage/repository/environment/environment_draft.hpp"

namespace floeplan::repository {

/// Adds the currents, one dataset or an ensemble, with tides where they are asked for. The icebergs are to be there
/// already: the oldest sighting says from when on currents are needed.
/// Errors   are among the draft's violations
void add_water(EnvironmentDraft& draft);

}  // namespace floeplan::repository
