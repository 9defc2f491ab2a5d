#pragma once

namespace floeplan::server {

/// The commit that the program was built from, as "62e0624" or "62e0624, changed"; empty where the tree has no git.
[[nodiscard]] const char* commit();

}  // namespace floeplan::server
