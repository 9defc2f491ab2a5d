#pragma once

#include "storage/repository/environment/environment_draft.hpp"

namespace floeplan::repository {

/// Adds the depths: of the finest dataset where it covers the area, else of several put together, the finest first (the
/// newest of those alike), or of those that are named, in that order.
/// Errors   are among the draft's violations
void add_bathymetry(EnvironmentDraft& draft);

}  // namespace floeplan::repository
