#pragma once

#include <string>
#include <string_view>

namespace floeplan::codec {

/// The text escaped for the content or an attribute of XML and HTML. Control characters are dropped, because
/// XML cannot represent them.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace floeplan::codec
