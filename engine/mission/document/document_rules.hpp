#pragma once

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Judges what the lines of a document say together, and adds to its messages: counts, duplicates, names and
/// codes that the dictionary does not know, places given inline, the file's own name. Fills
/// `waypoints_declared`, and `waypoints` of a mission.
void check_document(Document& document);

}  // namespace floeplan::mission
