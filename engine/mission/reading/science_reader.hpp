#pragma once

#include "engine/mission/document/document.hpp"
#include "engine/mission/document/file_text.hpp"

namespace floeplan::mission {

/// Reads a Seaglider's `science` into the document's bands: "DEPTH seconds=S sensors=DIGITS gc=S", or four columns of
/// the same without names, as older software has them.
/// Errors   reported: lines that cannot be read, numbers of sensors that differ between bands, times that are not
///          positive
/// Source   iop-apl-uw/basestation3 validate.py, the checks of a science file
void read_science(const FileText& text, Document& document);

}  // namespace floeplan::mission
