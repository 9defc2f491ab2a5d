#pragma once

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Checks the lines of a document together, and adds messages: counts, duplicates, names and codes that the
/// dictionary does not have, inline places, the file's own name. Fills `waypoints_declared`, and `waypoints`
/// of a mission.
void check_document(Document& document);

}  // namespace floeplan::mission
