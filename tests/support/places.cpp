#include "tests/support/places.hpp"

namespace floeplan::support {

std::string source_folder() { return FLOEPLAN_SOURCE_DIR; }

std::string program_folder() { return FLOEPLAN_BINARY_DIR; }

}  // namespace floeplan::support
