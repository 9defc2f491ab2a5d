#pragma once

#include "engine/mission/document/document.hpp"
#include "engine/mission/document/file_text.hpp"

namespace floeplan::mission {

/// Reads a Seaglider's `cmdfile`: lines "$NAME,number" into the document's sensors, and the directive that ends it.
/// Errors   reported: lines that cannot be read, values outside of what the vehicle takes, a dive that is to last
///          longer or go deeper than it is aborted at, no directive
/// Source   iop-apl-uw/basestation3 validate.py and parmdata.py (ranges), the University of Washington's Parameter
///          Reference Manual 66.12 (the directive is the last line)
void read_cmdfile(const FileText& text, Document& document);

}  // namespace floeplan::mission
