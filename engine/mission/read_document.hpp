#pragma once

#include <string>
#include <string_view>

#include "engine/mission/document.hpp"

namespace floeplan::mission {

/// Reads a mission (`.mi`) or an argument file (`.ma`) as shore tools, operators and the vendor write them, and
/// judges it. `name` is the file's name without its folder; its ending says what the file is, or else its
/// content.
/// Edges    a broken file gives what could be read of it, and a verdict of `reject`
/// Bounds   64 KiB and 1000 waypoints; reading stops after 100 errors; time and memory grow with the size
///          alone
/// Threads  may be called from several threads at once
[[nodiscard]] Document read_document(std::string name, std::string_view bytes);

}  // namespace floeplan::mission
