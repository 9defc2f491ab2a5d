#pragma once

#include "storage/repository/environment_draft.hpp"

namespace floeplan::repository {

/// Adds the sea ice: of the newest run, and of others where or when it tells nothing, the newer first; or of the one
/// that is named. Data of a time itself go before newer ones that are only held for it.
/// Errors   are among the draft's violations
void add_ice(EnvironmentDraft& draft);

}  // namespace floeplan::repository
