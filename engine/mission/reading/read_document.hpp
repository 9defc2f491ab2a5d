#pragma once

#include <string>
#include <string_view>

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Reads a mission (`.mi`) or an argument file (`.ma`) of a Slocum, or the targets, science or cmdfile of a Seaglider,
/// as shore tools, operators and the vendors write them, and judges it. `name` is the file's name without its folder;
/// it says what the file is by its ending (.mi, .ma) or a word in it (targets, science, cmdfile), or else the content
/// does.
/// Edges    a broken file gives what could be read of it, and a verdict of `reject`
/// Bounds   64 KiB and 1000 waypoints; reading stops after 100 errors; time and memory grow with the size
///          alone
/// Threads  may be called from several threads at once
[[nodiscard]] Document read_document(std::string name, std::string_view bytes);

}  // namespace floeplan::mission
