#pragma once

#include <string>

namespace floeplan::ingest {

/// Text of a table as UTF-8, without blanks around it. Tables without a stated encoding usually contain
/// Latin-1.
[[nodiscard]] std::string table_text(const char* text);

}  // namespace floeplan::ingest
