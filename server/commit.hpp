#pragma once

namespace floeplan::server {

/// The commit that the program was built from: "62e0624" or "62e0624, changed"; empty if the source tree has
/// no git data.
[[nodiscard]] const char* commit();

}  // namespace floeplan::server
