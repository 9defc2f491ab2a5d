#pragma once

#include <string>
#include <string_view>

namespace floeplan::codec {

/// Text made safe for the content or an attribute of XML and HTML; control characters go, since XML has no way to
/// write them.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace floeplan::codec
