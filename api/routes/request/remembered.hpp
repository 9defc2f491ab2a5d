#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "api/routes/request/message.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::routes {

/// Answers that one connection has found in the store and would find again. All are forgotten with the first change of
/// anything in the store, whoever made it, so none is ever out of date.
/// Threads  as the connection: one thread at a time
class Remembered {
 public:
  /// Before each request: forgets what may have changed since the last one.
  /// Errors   sql::Failure when the store cannot be read
  void refresh(sql::Connection& db);

  /// Null when there is none.
  [[nodiscard]] const Response* find(const Request& request) const;
  /// Small answers of status 200 alone, up to a bound in all. The answer gets its tag, if it has none.
  void keep(const Request& request, Response& response);

  std::optional<bool> ever_any_tokens{};  // whether the store has ever held one; nothing: not looked yet

 private:
  std::optional<sql::Version> version_;
  std::map<std::string, Response> answers_;  // by path and query
  std::size_t bytes_{0};
};

/// Whether a request takes no longer than to read one small row, as scripts do that watch a job.
[[nodiscard]] bool asks_for_job_status(const Request& request);

/// Whether the answer to a request follows from its path, its query and the store alone: a job's status or one feature,
/// without a wait.
[[nodiscard]] bool follows_from_store(const Request& request);

}  // namespace floeplan::routes
