#include "storage/repository/job_repository.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include "storage/sqlite/statement.hpp"
#include "storage/sqlite/transaction.hpp"

namespace floeplan::repository {
namespace {

constexpr std::array<std::pair<JobStatus, const char*>, 5> status_names{
    {{JobStatus::accepted, "accepted"},
     {JobStatus::running, "running"},
     {JobStatus::successful, "successful"},
     {JobStatus::failed, "failed"},
     {JobStatus::dismissed, "dismissed"}}};

constexpr std::array<std::pair<JobClass, const char*>, 3> class_names{
    {{JobClass::interactive, "interactive"}, {JobClass::batch, "batch"}, {JobClass::ingest, "ingest"}}};

// Shared by SELECT and RETURNING; read_job reads them in this order.
const std::string job_columns =
    "row, id, process, request_json, status, stage, progress, attempts, created_s, started_s, finished_s, "
    "updated_s, "
    "result_json, message, owner, digest, reply_json, change, class ";

JobRecord read_job(const sqlite::Statement& row) {
  return {.row = row.integer(0),
          .id = {row.text(1)},
          .process = row.text(2),
          .request_json = row.text(3),
          .job_class = parse_class(row.text(18)),
          .owner = row.text(14),
          .digest = row.optional_text(15),
          .reply_json = row.text(16),
          .status = parse_status(row.text(4)),
          .stage = row.text(5),
          .progress = row.real(6),
          .attempts = static_cast<int>(row.integer(7)),
          .created = row.time(8),
          .started = row.optional_time(9),
          .finished = row.optional_time(10),
          .updated = row.time(11),
          .result_json = row.optional_text(12),
          .message = row.text(13),
          .change = row.integer(17)};
}

/// Newest first. `rows` is a condition on the row that ?1 stands for.
sqlite::Statement select_jobs(sqlite::Connection& db, const std::string& rows, std::int64_t row, int limit,
                              const JobFilter& filter) {
  const std::string duration = "(coalesce(finished_s, updated_s) - started_s)";
  std::string sql = "SELECT " + job_columns + "FROM job WHERE " + rows;
  if (filter.status) sql += " AND status = ?3";
  if (filter.process) sql += " AND process = ?4";
  if (filter.owner) sql += " AND owner = ?5";
  if (filter.created_from) sql += " AND created_s >= ?6";
  if (filter.created_to) sql += " AND created_s <= ?7";
  if (filter.least_duration) sql += " AND " + duration + " >= ?8";
  if (filter.most_duration) sql += " AND " + duration + " <= ?9";

  sqlite::Statement query{db, sql + " ORDER BY row DESC LIMIT max(?2, 0)"};
  query.bind_all(row, limit);
  if (filter.status) query.bind(3, status_name(*filter.status));
  if (filter.process) query.bind(4, *filter.process);
  if (filter.owner) query.bind(5, *filter.owner);
  if (filter.created_from) query.bind(6, *filter.created_from);
  if (filter.created_to) query.bind(7, *filter.created_to);
  if (filter.least_duration) query.bind(8, filter.least_duration->count());
  if (filter.most_duration) query.bind(9, filter.most_duration->count());
  return query;
}

std::vector<JobRecord> read_jobs(sqlite::Statement& query) {
  std::vector<JobRecord> jobs;
  while (query.step()) jobs.push_back(read_job(query));
  return jobs;
}

/// The oldest claimable job of the class and the owner whose turn it is; ?2 is the time, ?4 a class or NULL, ?5 the most
/// running jobs that its owner may have or NULL.
const std::string next_in_turn =
    "SELECT first_row FROM (SELECT first_row, its_class, candidate, (SELECT count(*) FROM job WHERE status = "
    "'running' AND class = its_class AND owner = candidate AND lease_until_s > ?2) AS running FROM (SELECT "
    "class AS its_class, owner AS candidate, min(row) AS first_row FROM job AS waiting WHERE (?4 IS NULL OR "
    "class = ?4) AND (status = 'accepted' OR (status = 'running' AND (lease_until_s IS NULL OR lease_until_s "
    "<= ?2))) AND NOT (class = 'batch' AND EXISTS (SELECT 1 FROM job WHERE status = 'running' AND class = "
    "'batch' AND owner = waiting.owner AND process = waiting.process AND lease_until_s > ?2)) GROUP BY "
    "class, "
    "owner)) WHERE ?5 IS NULL OR running < ?5 ORDER BY CASE its_class WHEN 'interactive' THEN 0 WHEN 'batch' "
    "THEN 1 ELSE 2 END, running, (SELECT max(started_s) FROM job WHERE owner = candidate AND class = "
    "its_class) NULLS FIRST, first_row LIMIT 1";

std::optional<std::string> name_of(std::optional<JobClass> only) {
  return only ? std::optional{class_name(*only)} : std::nullopt;
}

/// A read, which many idle workers may do at once, before anybody asks for the right to write.
bool has_claimable(sqlite::Connection& db, core::UtcTime now, std::optional<JobClass> only,
                   std::optional<std::int64_t> most_of_owner) {
  sqlite::Statement query{db, next_in_turn};
  query.bind(2, now);
  query.bind(4, name_of(only));
  query.bind(5, most_of_owner);
  return query.step();
}

void fail_exhausted(sqlite::Connection& db, core::UtcTime now) {
  sqlite::Statement update{db,
                           "UPDATE job SET status = 'failed', message = 'begun ' || attempts || ' times, and "
                           "each time its worker stopped "
                           "before the end', worker = NULL, lease_until_s = NULL, finished_s = ?1, updated_s "
                           "= ?1 WHERE status = 'running' "
                           "AND (lease_until_s IS NULL OR lease_until_s <= ?1) AND attempts >= ?2"};
  update.bind_all(now, JobRepository::max_attempts);
  update.run();
}

}  // namespace

std::string status_name(JobStatus status) {
  for (const auto& [candidate, name] : status_names) {
    if (candidate == status) return name;
  }
  throw std::logic_error{"JobStatus without a name"};
}

JobStatus parse_status(const std::string& name) {
  for (const auto& [status, candidate] : status_names) {
    if (name == candidate) return status;
  }
  throw std::runtime_error{"no job has the status " + name};
}

std::string class_name(JobClass job_class) {
  for (const auto& [candidate, name] : class_names) {
    if (candidate == job_class) return name;
  }
  throw std::logic_error{"JobClass without a name"};
}

JobClass parse_class(const std::string& name) {
  for (const auto& [job_class, candidate] : class_names) {
    if (name == candidate) return job_class;
  }
  throw std::runtime_error{"no job is of the class " + name};
}

void JobRepository::submit(const JobRecord& job) {
  sqlite::Statement insert{db_,
                           "INSERT INTO job (id, process, request_json, status, stage, progress, attempts, "
                           "created_s, updated_s, message, owner, digest, reply_json, class) "
                           "VALUES (?1, ?2, ?3, 'accepted', '', 0.0, 0, ?4, ?4, '', ?5, ?6, ?7, ?8)"};
  insert.bind_all(job.id.value, job.process, job.request_json, job.created, job.owner, job.digest,
                  job.reply_json, class_name(job.job_class));
  insert.run();
}

std::optional<JobRecord> JobRepository::find(const JobId& id) const {
  sqlite::Statement query{db_, "SELECT " + job_columns + "FROM job WHERE id = ?1"};
  query.bind(1, id.value);
  if (!query.step()) return std::nullopt;
  return read_job(query);
}

std::vector<JobRecord> JobRepository::list(std::int64_t before, int limit, const JobFilter& filter) const {
  sqlite::Statement query = select_jobs(db_, "(?1 = 0 OR row < ?1)", before, limit, filter);
  return read_jobs(query);
}

PartialList<JobRecord> JobRepository::list_past_damage(std::int64_t before, int limit,
                                                       const JobFilter& filter) const {
  const auto of_row = [&](std::int64_t row) {
    sqlite::Statement query = select_jobs(db_, "row = ?1", row, 1, filter);
    return query.step() ? std::optional{read_job(query)} : std::nullopt;
  };
  return repository::list_past_damage(
      db_, job_table, {.behind = before, .limit = limit, .descending = true},
      [&] { return list(before, limit, filter); }, of_row);
}

std::optional<JobRecord> JobRepository::find_shared(const std::string& digest,
                                                    const std::string& owner) const {
  sqlite::Statement query{db_, "SELECT " + job_columns +
                                   "FROM job WHERE digest = ?1 AND (status = 'successful' OR (owner = ?2 AND "
                                   "status IN ('accepted', 'running'))) ORDER BY status = 'successful' DESC, "
                                   "row DESC LIMIT 1"};
  query.bind_all(digest, owner);
  if (!query.step()) return std::nullopt;
  return read_job(query);
}

std::vector<JobRecord> JobRepository::changed_since(std::int64_t change, int limit) const {
  sqlite::Statement query{
      db_, "SELECT " + job_columns + "FROM job WHERE change > ?1 ORDER BY change LIMIT max(?2, 0)"};
  query.bind_all(change, limit);
  return read_jobs(query);
}

std::int64_t JobRepository::last_change() const {
  sqlite::Statement query{db_, "SELECT change FROM job_clock"};
  return query.step() ? query.integer(0) : 0;
}

std::int64_t JobRepository::count(JobStatus status) const {
  sqlite::Statement query{db_, "SELECT count(*) FROM job WHERE status = ?1"};
  query.bind(1, status_name(status));
  return query.step() ? query.integer(0) : 0;
}

void JobRepository::touch_queue() { sqlite::execute(db_, "UPDATE job_clock SET change = change"); }

std::optional<JobRecord> JobRepository::claim(const std::string& worker, core::UtcTime now,
                                              core::Seconds lease, std::optional<JobClass> only,
                                              std::optional<std::int64_t> most_of_owner) {
  if (!has_claimable(db_, now, only, most_of_owner)) return std::nullopt;

  sqlite::Transaction transaction{db_};
  fail_exhausted(db_, now);
  std::optional<JobRecord> claimed;
  {
    sqlite::Statement update{db_,
                             "UPDATE job SET status = 'running', worker = ?1, lease_until_s = ?3, attempts = "
                             "attempts + 1, started_s = coalesce(started_s, ?2), updated_s = ?2, stage = '', "
                             "progress = 0.0 WHERE row = (" +
                                 next_in_turn + ") RETURNING " + job_columns};
    update.bind_all(worker, now, now + lease, name_of(only), most_of_owner);
    if (update.step()) claimed = read_job(update);
  }
  transaction.commit();
  return claimed;
}

bool JobRepository::renew(const JobId& id, const std::string& worker, const std::string& stage,
                          double progress, core::UtcTime now, core::Seconds lease) {
  sqlite::Statement update{
      db_,
      "UPDATE job SET stage = ?3, progress = ?4, updated_s = ?5, lease_until_s = ?6 WHERE id = ?1 "
      "AND worker = ?2 AND status = 'running'"};
  update.bind_all(id.value, worker, stage, progress, now, now + lease);
  return update.run() > 0;
}

bool JobRepository::succeed(const JobId& id, const std::string& worker, const std::string& result_json,
                            core::UtcTime now) {
  sqlite::Statement update{
      db_,
      "UPDATE job SET status = 'successful', result_json = ?3, stage = '', progress = 1.0, worker = NULL, "
      "lease_until_s = NULL, finished_s = ?4, updated_s = ?4 WHERE id = ?1 AND worker = ?2 AND "
      "status = 'running'"};
  update.bind_all(id.value, worker, result_json, now);
  return update.run() > 0;
}

bool JobRepository::fail(const JobId& id, const std::string& worker, const std::string& message,
                         core::UtcTime now) {
  sqlite::Statement update{
      db_,
      "UPDATE job SET status = 'failed', message = ?3, worker = NULL, lease_until_s = NULL, "
      "finished_s = ?4, updated_s = ?4 WHERE id = ?1 AND worker = ?2 AND status = 'running'"};
  update.bind_all(id.value, worker, message, now);
  return update.run() > 0;
}

void JobRepository::hand_back(const std::string& worker, core::UtcTime now) {
  sqlite::Statement update{db_,
                           "UPDATE job SET status = 'accepted', attempts = attempts - 1, started_s = "
                           "iif(attempts = 1, NULL, started_s), "
                           "stage = '', progress = 0.0, worker = NULL, lease_until_s = NULL, updated_s = ?2 "
                           "WHERE worker = ?1 AND status = "
                           "'running'"};
  update.bind_all(worker, now);
  update.run();
}

void JobRepository::release_all_leases(core::UtcTime now) {
  sqlite::Statement update{
      db_, "UPDATE job SET worker = NULL, lease_until_s = NULL, updated_s = ?1 WHERE status = 'running'"};
  update.bind(1, now);
  update.run();
}

bool JobRepository::dismiss(const JobId& id, core::UtcTime now) {
  sqlite::Statement update{
      db_,
      "UPDATE job SET status = 'dismissed', message = 'dismissed on request', worker = NULL, "
      "lease_until_s = NULL, finished_s = ?2, updated_s = ?2 WHERE id = ?1 AND status IN "
      "('accepted', 'running')"};
  update.bind_all(id.value, now);
  return update.run() > 0;
}

bool JobRepository::remove(const JobId& id) {
  sqlite::Statement remove{db_, "DELETE FROM job WHERE id = ?1"};
  remove.bind(1, id.value);
  return remove.run() > 0;
}

}  // namespace floeplan::repository
