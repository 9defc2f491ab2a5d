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

/// Reads a Seaglider's `science` into the document's bands: "DEPTH seconds=S sensors=DIGITS gc=S", or four columns of
/// the same without names, as older software has them.
/// Errors   reported: lines that cannot be read, numbers of sensors that differ between bands, times that are not
///          positive
/// Source   iop-apl-uw/basestation3 validate.py, the checks of a science file
void read_science(const FileText& text, Document& document);

/// Reads a Seaglider's `cmdfile`: lines "$NAME,number" into the document's sensors, and the directive that ends it.
/// Errors   reported: lines that cannot be read, values outside of what the vehicle takes, a dive that is to last
///          longer or go deeper than it is aborted at, no directive
/// Source   iop-apl-uw/basestation3 validate.py and parmdata.py (ranges), the University of Washington's Parameter
///          Reference Manual 66.12 (the directive is the last line)
void read_cmdfile(const FileText& text, Document& document);

}  // namespace floeplan::mission
