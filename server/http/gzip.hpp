#pragma once

#include <string>
#include <string_view>

namespace floeplan::http {

/// The bytes in gzip format (RFC 1952), without a time stamp: the same input gives the same output.
[[nodiscard]] std::string gzip(std::string_view bytes);

}  // namespace floeplan::http
