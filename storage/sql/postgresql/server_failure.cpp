#include "storage/sql/postgresql/server_failure.hpp"

#include <string_view>

#include "engine/messages/store_messages.hpp"

namespace floeplan::sql::postgresql {
namespace {

std::string without_line_end(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace

/// Codes: appendix A of the manual of PostgreSQL 15. The first two characters are the class.
Failure failure_of(const PGresult* result, const PGconn* connection, const std::string& name) {
  const char* const told = result != nullptr ? PQresultErrorField(result, PG_DIAG_SQLSTATE) : nullptr;
  const std::string_view code = told != nullptr ? told : "";
  const std::string detail =
      without_line_end(result != nullptr ? PQresultErrorMessage(result) : PQerrorMessage(connection));
  if (code.empty() || code.starts_with("08") || code.starts_with("57P"))
    return Failure{messages::store_text<"server-not-reached">(name, detail), Trouble::not_writable};
  if (code == "53100") return Failure{messages::store_text<"disk-full">(name, detail), Trouble::disk_full};
  if (code == "55P03" || code == "40P01" || code == "40001")
    return Failure{messages::store_text<"database-locked">(name, detail), Trouble::held_by_another};
  // 3F000: no schema of the search path is there, or this role may use none of them
  if (code == "25006" || code == "42501" || code == "3F000" || code.starts_with("28"))
    return Failure{messages::store_text<"database-read-only">(name, detail), Trouble::not_writable};
  if (code == "XX001" || code == "XX002")
    return Failure{messages::store_text<"server-database-damaged">(name, detail), Trouble::damaged};
  return Failure{messages::store_text<"database-failed">(name, detail)};
}

}  // namespace floeplan::sql::postgresql
