#pragma once

#include "engine/mission/document/document.hpp"
#include "engine/mission/document/file_text.hpp"

namespace floeplan::mission {

/// Reads a Seaglider's `targets`: the document's waypoints are the places from the first target on, each followed by
/// the one that its `goto` names, until one comes again. A target that is steered to by its heading alone has no place;
/// there the waypoints end. Targets off that way, and a last one that leads back to another, are noted.
/// Errors   reported: lines that cannot be read, targets without lat, lon and radius (or head) and goto, names that are
///          there twice, and every kind of goto that names no target
/// Source   iop-apl-uw/basestation3 validate.py, the checks of a targets file
void read_targets(const FileText& text, Document& document);

}  // namespace floeplan::mission
