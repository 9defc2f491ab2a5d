#pragma once

#include "engine/mission/document/document.hpp"
#include "engine/mission/document/file_text.hpp"

namespace floeplan::mission {

/// Reads a Seaglider's `targets` file. The document's waypoints are the places from the first target on, each
/// followed by the one that its `goto` names, until one repeats. A target with only a heading has no place,
/// so the waypoints end there. Targets off this route, and a last one that leads back to another, get notes.
/// Errors   reported as messages: unreadable lines, targets without lat, lon and radius (or head) and goto,
///          duplicate names, and a goto that names no target
/// Source   iop-apl-uw/basestation3 validate.py, the checks of a targets file
void read_targets(const FileText& text, Document& document);

/// Reads a Seaglider's `science` file into the document's bands: lines "DEPTH seconds=S sensors=DIGITS gc=S",
/// or the same four columns without names, as in older software.
/// Errors   reported as messages: unreadable lines, different numbers of sensors between bands, times that
///          are not positive
/// Source   iop-apl-uw/basestation3 validate.py, the checks of a science file
void read_science(const FileText& text, Document& document);

/// Reads a Seaglider's `cmdfile`: lines "$NAME,number" into the document's sensors, and the directive that
/// ends it.
/// Errors   reported as messages: unreadable lines, values outside the accepted ranges, a dive longer or
///          deeper than the limits at which it is aborted, no directive
/// Source   iop-apl-uw/basestation3 validate.py and parmdata.py (ranges), the University of Washington's
///          Parameter Reference Manual 66.12 (the directive is the last line)
void read_cmdfile(const FileText& text, Document& document);

}  // namespace floeplan::mission
