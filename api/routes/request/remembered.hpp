#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "api/routes/request/message.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::routes {

/// Cache of answers, one for each connection to the store. It is cleared at any change of the store by
/// anyone, so its answers are never outdated.
/// Threads  as the connection: one thread at a time
class Remembered {
 public:
  /// Call before each request: clears the cache if the store has changed since the last call.
  /// Errors   sql::Failure when the store cannot be read
  void refresh(sql::Connection& db);

  /// The cached answer; null if there is none.
  [[nodiscard]] const Response* find(const Request& request) const;
  /// Stores small answers with status 200, up to a total size. Adds an ETag to the answer if it has none.
  void keep(const Request& request, Response& response);

  std::optional<bool> ever_any_tokens{};  // whether the store ever had a token; empty: not known yet

 private:
  std::optional<sql::Version> version_;
  std::map<std::string, Response> answers_;  // by path and query
  std::size_t bytes_{0};
};

/// Whether a request only reads the status of a job, which is fast. Scripts send such requests often.
[[nodiscard]] bool asks_for_job_status(const Request& request);

/// Whether path, query and store alone determine the answer to a request: the status of a job or one feature,
/// without a wait.
[[nodiscard]] bool follows_from_store(const Request& request);

}  // namespace floeplan::routes
