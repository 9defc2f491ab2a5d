#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace floeplan::codec {

/// One part of a multipart/form-data body.
struct FormPart {
  std::string name;       // name of the form's field
  std::string file_name;  // empty if the part is not a file
  std::string content;    // the bytes of the part, unchanged
};

/// The parts of a multipart/form-data body, in their order.
/// `content_type`  the header of the whole body, which contains the boundary
/// Bounds   at most 1000 parts; time and memory grow linearly with the size
/// Errors   the fault, for the user: no boundary, no closing boundary, a part without a disposition
/// Source   RFC 7578, and RFC 2046 section 5.1 for the boundaries
[[nodiscard]] tl::expected<std::vector<FormPart>, std::string> parse_multipart(std::string_view content_type,
                                                                               std::string_view body);

}  // namespace floeplan::codec
