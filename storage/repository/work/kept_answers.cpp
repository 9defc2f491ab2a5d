#include "storage/repository/work/kept_answers.hpp"

#include "storage/sql/statement.hpp"

namespace floeplan::repository {

std::optional<KeptAnswer> KeptAnswers::find(const IdempotencyKey& key) const {
  sql::Statement query{
      db_, "SELECT request_sha256, job_id, answer FROM kept_answer WHERE owner = ?1 AND key = ?2"};
  query.bind_all(key.owner, key.key);
  if (!query.step()) return std::nullopt;
  KeptAnswer kept{.request_sha256 = query.text(0), .job = {}, .answer = query.optional_text(2)};
  if (const auto job = query.optional_text(1)) kept.job = JobId{*job};
  return kept;
}

void KeptAnswers::insert(const IdempotencyKey& key, const std::optional<JobId>& job,
                         const std::optional<std::string>& answer, core::UtcTime now) {
  sql::Statement insert{db_,
                        "INSERT INTO kept_answer (owner, key, request_sha256, created_s, job_id, answer) "
                        "VALUES (?1, ?2, ?3, ?4, ?5, ?6)"};
  const auto id = job ? std::optional{job->value} : std::nullopt;
  insert.bind_all(key.owner, key.key, key.request_sha256, now, id, answer);
  insert.run();
}

void KeptAnswers::remove_expired(core::UtcTime now) {
  sql::Statement remove{db_, "DELETE FROM kept_answer WHERE created_s < ?1"};
  remove.bind(1, now - lifetime);
  remove.run();
}

}  // namespace floeplan::repository
