#pragma once

#include <optional>
#include <string>

#include "engine/core/units.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// A client's own key for a request. Sending the request again with the key, after a broken connection, has
/// no second effect.
struct IdempotencyKey {
  std::string owner;
  std::string key;
  std::string request_sha256;  // digest of everything that determines the answer
};

/// The answer to a request with a key: a job, or a text.
struct KeptAnswer {
  std::string request_sha256;
  std::optional<JobId> job;
  std::optional<std::string> answer;
};

/// Answers by the keys of their requests, kept for a day. Insert an answer in the transaction that carries
/// out the request.
/// Threads  as the connection: one thread at a time
class KeptAnswers {
 public:
  explicit KeptAnswers(sql::Connection& db) : db_{db} {}

  static constexpr core::Seconds lifetime{86'400.0};

  [[nodiscard]] std::optional<KeptAnswer> find(const IdempotencyKey& key) const;
  void insert(const IdempotencyKey& key, const std::optional<JobId>& job,
              const std::optional<std::string>& answer, core::UtcTime now);
  void remove_expired(core::UtcTime now);

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
