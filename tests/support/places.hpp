#pragma once

#include <string>

namespace floeplan::support {

/// The top of the source tree, absolute, without a slash at its end. Known to one source alone, so that the objects of
/// all other tests are the same wherever the tree lies, and come from the compiler's cache.
[[nodiscard]] std::string source_folder();

/// Where the programs were built, absolute, without a slash at its end.
[[nodiscard]] std::string program_folder();

}  // namespace floeplan::support
