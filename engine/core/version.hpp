#pragma once

#include <string_view>

namespace floeplan::core {

/// The version, such as "0.2.0", from CMakeLists.txt. Only one source file contains it, so a new release
/// compiles one file.
[[nodiscard]] std::string_view version();

/// Program and version, such as "floeplan 0.2.0", as written into files and datasets.
[[nodiscard]] std::string_view program_version();

}  // namespace floeplan::core
