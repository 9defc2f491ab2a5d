#pragma once

#include <string>
#include <vector>

namespace floeplan::sql::postgresql {

/// The text of a statement as the server takes it, and for each parameter of the server the number in the
/// original text.
struct ServerText {
  std::string sql;        // with $1, $2, ... in the order in which they first occur
  std::vector<int> ours;  // ours[k - 1] is the number behind the "?" that $k stands for
};

/// Translates "?1", "?7", ... The numbers may have gaps, and a number may occur more than once.
/// Edges    a "?" within quotation marks stays
[[nodiscard]] ServerText server_text(const std::string& sql);

}  // namespace floeplan::sql::postgresql
