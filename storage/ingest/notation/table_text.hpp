#pragma once

#include <string>

namespace floeplan::ingest {

/// Text of a table as UTF-8, without blanks around it; tables without a stated encoding hold Latin-1 as a rule.
[[nodiscard]] std::string table_text(const char* text);

}  // namespace floeplan::ingest
