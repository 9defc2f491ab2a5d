#pragma once

#include <string>

namespace floeplan::support {

/// The top folder of the source tree, absolute, without a slash at the end. Only one source contains the
/// path, so that the objects of all other tests do not depend on the place of the tree and can come from the
/// compiler's cache.
[[nodiscard]] std::string source_folder();

/// The folder of the built programs, absolute, without a slash at the end.
[[nodiscard]] std::string program_folder();

}  // namespace floeplan::support
