#include "engine/core/version.hpp"

namespace floeplan::core {

std::string_view version() { return FLOEPLAN_VERSION; }

std::string_view program_version() { return "floeplan " FLOEPLAN_VERSION; }

}  // namespace floeplan::core
