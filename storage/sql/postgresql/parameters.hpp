#pragma once

#include <string>
#include <vector>

namespace floeplan::sql::postgresql {

/// A statement's text as the server takes it, and which of our parameters each of the server's is.
struct ServerText {
  std::string sql;        // with $1, $2, ... in the order in which they first occur
  std::vector<int> ours;  // ours[k - 1] is the number behind the "?" that $k stands for
};

/// Translates "?1", "?7", ... Our numbers may have gaps, and a number may occur more than once.
/// Edges    a "?" within quotation marks stays
[[nodiscard]] ServerText server_text(const std::string& sql);

}  // namespace floeplan::sql::postgresql
