#pragma once

#include <string_view>

#include "engine/mission/document.hpp"

namespace floeplan::mission {

/// Notes codes of start_when, stop_when and their like that firmware 10.5 does not have, or not for this behavior.
/// Codes above 14 differ between firmwares, so that none is more than noted.
/// Source   facts from the vendor's data dictionary of firmware 10.5: codes 0 to 18, and which of them each behavior
///          takes
void check_code(std::string_view behavior, const Argument& argument, Messages& messages);

}  // namespace floeplan::mission
