#include "storage/sql/postgresql/parameters.hpp"

#include <algorithm>
#include <cstddef>

namespace floeplan::sql::postgresql {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

ServerText server_text(const std::string& sql) {
  ServerText text;
  char quoted_by = '\0';
  for (std::size_t i = 0; i < sql.size();) {
    const char c = sql[i++];
    if (quoted_by == '\0' && c == '?' && i < sql.size() && is_digit(sql[i])) {
      int number = 0;
      while (i < sql.size() && is_digit(sql[i])) number = 10 * number + (sql[i++] - '0');
      auto known = std::ranges::find(text.ours, number);
      if (known == text.ours.end()) known = text.ours.insert(known, number);
      text.sql += "$" + std::to_string(known - text.ours.begin() + 1);
      continue;
    }
    if (quoted_by != '\0') {
      if (c == quoted_by) quoted_by = '\0';
    } else if (c == '\'' || c == '"') {
      quoted_by = c;
    }
    text.sql += c;
  }
  return text;
}

}  // namespace floeplan::sql::postgresql
