#pragma once

#include <string_view>

namespace floeplan::core {

/// The release, as "0.2.0": that of CMakeLists.txt. One source holds it, so that a new release compiles one file.
[[nodiscard]] std::string_view version();

/// "floeplan 0.2.0", as files and datasets name the program that wrote them.
[[nodiscard]] std::string_view program_version();

}  // namespace floeplan::core
