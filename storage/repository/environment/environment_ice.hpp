#pragma once

#include "storage/repository/environment/environment_draft.hpp"

namespace floeplan::repository {

/// Adds the sea ice of the mission, which may begin at the latest departure that the query knows of and last for 30
/// days: of the newest run, and of others where or when it tells nothing, the newer first; or of the one that is named.
/// Data of a time itself go before newer ones that are only held for it. What ended before the departure, by 30 days at
/// most, tells what keels were known last.
/// Errors   are among the draft's violations
void add_ice(EnvironmentDraft& draft);

}  // namespace floeplan::repository
