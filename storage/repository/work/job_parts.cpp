#include "storage/repository/work/job_parts.hpp"

#include <span>

#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

/// Condition for a part that no worker holds; ?1 is the time.
const std::string is_free = "result IS NULL AND (holder IS NULL OR lease_until_s <= ?1)";

}  // namespace

void JobParts::offer(const JobStage& stage, std::size_t count) {
  sql::Transaction transaction{db_};
  sql::Statement of_another_basis{db_,
                                  "DELETE FROM job_part WHERE job_id = ?1 AND stage = ?2 AND basis <> ?3"};
  of_another_basis.bind_all(stage.job.value, stage.number, stage.basis);
  of_another_basis.run();
  sql::Statement insert{db_,
                        "INSERT INTO job_part (job_id, stage, part, basis) VALUES (?1, ?2, ?3, ?4) "
                        "ON CONFLICT (job_id, stage, part) DO NOTHING"};
  for (std::size_t part = 0; part < count; ++part) {
    insert.reset();
    insert.bind_all(stage.job.value, stage.number, static_cast<std::int64_t>(part), stage.basis);
    insert.run();
  }
  transaction.commit();
}

std::optional<std::size_t> JobParts::take(const JobStage& stage, const std::string& holder, core::UtcTime now,
                                          core::Seconds lease) {
  sql::Transaction transaction{db_};
  sql::Statement update{db_, R"sql(
    UPDATE job_part SET holder = ?5, lease_until_s = ?6
    WHERE job_id = ?2 AND stage = ?3 AND part = (
      SELECT min(part) FROM job_part WHERE job_id = ?2 AND stage = ?3 AND basis = ?4 AND )sql" +
                                 is_free + ") RETURNING part"};
  update.bind_all(now, stage.job.value, stage.number, stage.basis, holder, now + lease);
  const auto part = update.step() ? std::optional{static_cast<std::size_t>(update.integer(0))} : std::nullopt;
  update.reset();
  transaction.commit();
  return part;
}

bool JobParts::finish(const JobStage& stage, std::size_t part, const std::string& holder,
                      const std::string& result) {
  sql::Statement update{db_, R"sql(
    UPDATE job_part SET result = ?5, holder = NULL, lease_until_s = NULL
    WHERE job_id = ?1 AND stage = ?2 AND part = ?3 AND holder = ?4 AND result IS NULL)sql"};
  update.bind_all(stage.job.value, stage.number, static_cast<std::int64_t>(part), holder,
                  std::as_bytes(std::span{result}));
  return update.run() > 0;
}

std::vector<std::size_t> JobParts::finished(const JobStage& stage) const {
  sql::Statement query{db_,
                       "SELECT part FROM job_part WHERE job_id = ?1 AND stage = ?2 AND basis = ?3 AND "
                       "result IS NOT NULL ORDER BY part"};
  query.bind_all(stage.job.value, stage.number, stage.basis);
  std::vector<std::size_t> parts;
  while (query.step()) parts.push_back(static_cast<std::size_t>(query.integer(0)));
  return parts;
}

std::optional<std::string> JobParts::result(const JobStage& stage, std::size_t part) const {
  sql::Statement query{db_,
                       "SELECT result FROM job_part WHERE job_id = ?1 AND stage = ?2 AND part = ?3 AND "
                       "basis = ?4 AND result IS NOT NULL"};
  query.bind_all(stage.job.value, stage.number, static_cast<std::int64_t>(part), stage.basis);
  if (!query.step()) return std::nullopt;
  const auto bytes = query.blob(0);
  return std::string{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool JobParts::renew(const JobId& job, const std::string& holder, core::UtcTime now, core::Seconds lease) {
  sql::Statement update{
      db_, "UPDATE job_part SET lease_until_s = ?3 WHERE job_id = ?1 AND holder = ?2 AND result IS NULL"};
  update.bind_all(job.value, holder, now + lease);
  update.run();
  sql::Statement query{db_, "SELECT 1 FROM job WHERE id = ?1 AND status = 'running'"};
  query.bind(1, job.value);
  return query.step();
}

void JobParts::give_back(const JobId& job, const std::string& holder) {
  sql::Statement update{db_,
                        "UPDATE job_part SET holder = NULL, lease_until_s = NULL WHERE job_id = ?1 AND "
                        "holder = ?2 AND result IS NULL"};
  update.bind_all(job.value, holder);
  update.run();
}

std::optional<JobId> JobParts::in_need(const std::string& node, core::UtcTime now,
                                       const std::set<JobId>& except) const {
  sql::Statement query{db_, R"sql(
    SELECT id FROM job
    WHERE status = 'running' AND lease_until_s > ?1 AND substr(worker, 1, length(?2)) <> ?2
      AND EXISTS (SELECT 1 FROM job_part WHERE job_id = job.id AND )sql" +
                                is_free + ") ORDER BY started_s, row"};
  query.bind_all(now, node);
  while (query.step())
    if (JobId id{query.text(0)}; !except.contains(id)) return id;
  return std::nullopt;
}

}  // namespace floeplan::repository
