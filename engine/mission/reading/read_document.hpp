#pragma once

#include <string>
#include <string_view>

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Reads and checks a file: a mission (`.mi`) or argument file (`.ma`) of a Slocum, or the targets, science
/// or cmdfile of a Seaglider, as shore tools, operators and vendors write them. `name` is the file's name
/// without folder. The kind follows from its ending (.mi, .ma) or a word in it (targets, science, cmdfile),
/// otherwise from the content.
/// Edges    a broken file gives the parts that could be read, and the verdict `reject`
/// Bounds   64 KiB and 1000 waypoints; reading stops after 100 errors; time and memory depend on the size
///          only
/// Threads  may be called from several threads at once
[[nodiscard]] Document read_document(std::string name, std::string_view bytes);

}  // namespace floeplan::mission
