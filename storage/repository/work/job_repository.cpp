#include "storage/repository/work/job_repository.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <utility>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

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

// Columns of SELECT and RETURNING, in the order in which read_job reads them.
const std::string job_columns =
    "row, id, process, request_json, status, stage, progress, attempts, created_s, started_s, finished_s, "
    "updated_s, "
    "result_json, message, owner, digest, reply_json, change, class ";

JobRecord read_job(const sql::Row& row) {
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

/// A query of jobs, newest first. `rows`: a condition that compares the row with parameter ?1.
sql::Statement select_jobs(sql::Connection& db, const std::string& rows, std::int64_t row, int limit,
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

  sql::Statement query{db, sql + " ORDER BY row DESC LIMIT ?2"};
  query.bind_all(row, std::max(limit, 0));
  if (filter.status) query.bind(3, status_name(*filter.status));
  if (filter.process) query.bind(4, *filter.process);
  if (filter.owner) query.bind(5, *filter.owner);
  if (filter.created_from) query.bind(6, *filter.created_from);
  if (filter.created_to) query.bind(7, *filter.created_to);
  if (filter.least_duration) query.bind(8, filter.least_duration->count());
  if (filter.most_duration) query.bind(9, filter.most_duration->count());
  return query;
}

std::vector<JobRecord> read_jobs(sql::Statement& query) {
  std::vector<JobRecord> jobs;
  while (query.step()) jobs.push_back(read_job(query));
  return jobs;
}

/// Rows of all waiting or running jobs that can be read completely.
std::set<std::int64_t> whole_unfinished_jobs(sql::Connection& db) {
  std::set<std::int64_t> unfinished;
  {
    sql::Statement query{
        db, "SELECT row FROM job INDEXED BY job_by_status WHERE status IN ('accepted', 'running')"};
    while (query.step()) unfinished.insert(query.integer(0));
  }
  sql::Statement query{db, "SELECT * FROM job WHERE row = ?1"};
  std::erase_if(unfinished, [&](std::int64_t row) {
    return !sql::meets_no_damage([&] {
      query.reset();
      query.bind(1, row);
      (void)query.step();
    });
  });
  return unfinished;
}

/// The jobs that a statement on the queue considers: all, or, in a store with damaged jobs, only the readable
/// ones, so that a damaged job does not block the others.
class Queue {
 public:
  /// Prepares `sql` with the jobs in place of {jobs}. Parameter ?9 is reserved.
  [[nodiscard]] sql::Statement statement(sql::Connection& db, std::string sql) const {
    constexpr std::string_view place = "{jobs}";
    const std::string jobs =
        rows_ ? "(SELECT job.* FROM json_each(?9) AS listed CROSS JOIN job ON job.row = listed.value)"
              : "job";
    for (auto at = sql.find(place); at != std::string::npos; at = sql.find(place, at + jobs.size()))
      sql.replace(at, place.size(), jobs);
    sql::Statement prepared{db, sql};
    if (rows_) prepared.bind(9, json(*rows_));
    return prepared;
  }

  /// Call after damage was met. The first time excludes all jobs that cannot be read; after that the job that
  /// was to be written, because its row may be on a page with a damaged one.
  /// Returns  whether another job was excluded
  [[nodiscard]] bool leave_out(sql::Connection& db, std::optional<std::int64_t> row) {
    if (rows_) return row && rows_->erase(*row) > 0;
    rows_ = whole_unfinished_jobs(db);
    return true;
  }

 private:
  static std::string json(const std::set<std::int64_t>& rows) {
    std::string list = "[";
    for (const std::int64_t row : rows) list += (list.size() == 1 ? "" : ",") + std::to_string(row);
    return list + "]";
  }

  std::optional<std::set<std::int64_t>> rows_;  // empty: all jobs
};

/// Changes the jobs that meet the condition. If this meets damage, changes them one by one; jobs that cannot
/// be read, or not written because their page has a damaged row, stay unchanged.
/// `bind`  binds the parameters of both texts; ?9 is reserved
template <class Bind>
void update_jobs(sql::Connection& db, const std::string& set, const std::string& condition,
                 const Bind& bind) {
  const std::string update = "UPDATE job SET " + set + " WHERE " + condition;
  const bool whole = sql::meets_no_damage([&] {
    sql::Statement statement{db, update};
    bind(statement);
    statement.run();
  });
  if (whole) return;
  for (const std::int64_t row : whole_unfinished_jobs(db)) {
    (void)sql::meets_no_damage([&] {
      sql::Statement statement{db, update + " AND row = ?9"};
      bind(statement);
      statement.bind(9, row);
      statement.run();
    });
  }
}

std::optional<std::string> name_of(std::optional<JobClass> only) {
  return only ? std::optional{class_name(*only)} : std::nullopt;
}

/// The beginning of the names of all workers of this worker's node; empty: all workers are one node's.
std::string node_of(const std::string& worker) { return worker.substr(0, worker.rfind('/') + 1); }

/// A job that waits, or whose worker was lost; ?1 is the time.
const std::string claimable =
    "(status = 'accepted' OR (status = 'running' AND (lease_until_s IS NULL OR lease_until_s <= ?1)))";

/// Row of the next job to claim, see JobRepository::claim. Only reads, so that idle workers do not wait for
/// each other's write lock.
std::optional<std::int64_t> next_in_turn(sql::Connection& db, const Queue& queue, const std::string& worker,
                                         core::UtcTime now, std::optional<JobClass> only,
                                         std::optional<std::int64_t> most_of_owner) {
  sql::Statement query = queue.statement(db, R"sql(
    SELECT first_row FROM (
      SELECT first_row, its_class, candidate, (
        SELECT count(*) FROM {jobs}
        WHERE status = 'running' AND class = its_class AND owner = candidate AND lease_until_s > ?1) AS running, (
        SELECT count(*) FROM {jobs}
        WHERE status = 'running' AND class = its_class AND owner = candidate AND lease_until_s > ?1
          AND substr(worker, 1, length(?5)) = ?5) AS running_here
      FROM (
        SELECT class AS its_class, owner AS candidate, min(row) AS first_row FROM {jobs} AS waiting
        WHERE (?2 IS NULL OR class = ?2) AND attempts < ?4 AND )sql" + claimable + R"sql(
          AND NOT (class = 'batch' AND EXISTS (
            SELECT 1 FROM {jobs} WHERE status = 'running' AND class = 'batch' AND owner = waiting.owner
              AND process = waiting.process AND lease_until_s > ?1))
        GROUP BY class, owner) AS candidates) AS turns
    WHERE ?3 IS NULL OR running_here < ?3
    ORDER BY CASE its_class WHEN 'interactive' THEN 0 WHEN 'batch' THEN 1 ELSE 2 END, running,
      (SELECT max(started_s) FROM job WHERE owner = candidate AND class = its_class) NULLS FIRST, first_row
    LIMIT 1)sql");
  query.bind_all(now, name_of(only), most_of_owner, JobRepository::max_attempts, node_of(worker));
  return query.step() ? std::optional{query.integer(0)} : std::nullopt;
}

/// Fails jobs that were started too often. Does not write if there are none.
void fail_exhausted(sql::Connection& db, core::UtcTime now) {
  const std::string exhausted =
      "status = 'running' AND (lease_until_s IS NULL OR lease_until_s <= ?1) AND attempts >= ?2";
  const auto bind = [&](sql::Statement& statement) { statement.bind_all(now, JobRepository::max_attempts); };
  bool any = true;  // stays true if damage prevents the check
  (void)sql::meets_no_damage([&] {
    sql::Statement query{db, "SELECT 1 FROM job WHERE " + exhausted + " LIMIT 1"};
    bind(query);
    any = query.step();
  });
  if (!any) return;
  update_jobs(
      db,
      "status = 'failed', worker = NULL, lease_until_s = NULL, finished_s = ?1, updated_s = ?1, message = "
      "'begun ' || attempts || ' times, and each time its worker stopped before the end'",
      exhausted, bind);
}

/// Empty where the job has changed since it was chosen: at a database server it may have been dismissed meanwhile, or its
/// worker has come back.
std::optional<JobRecord> take(sql::Connection& db, std::int64_t row, const std::string& worker,
                              core::UtcTime now, core::Seconds lease) {
  sql::Statement update{db, R"sql(
    UPDATE job SET status = 'running', worker = ?2, lease_until_s = ?4, attempts = attempts + 1,
      started_s = coalesce(started_s, ?1), updated_s = ?1, stage = '', progress = 0.0
    WHERE row = ?3 AND )sql" + claimable + " RETURNING " +
                                job_columns};
  update.bind_all(now, worker, row, now + lease);
  return update.step() ? std::optional{read_job(update)} : std::nullopt;
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
  throw std::runtime_error{messages::store_text<"stored-word-unknown">("a job's status", name)};
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
  throw std::runtime_error{messages::store_text<"stored-word-unknown">("a job's class", name)};
}

void JobRepository::submit(const JobRecord& job) {
  sql::Statement insert{db_,
                        "INSERT INTO job (id, process, request_json, status, stage, progress, attempts, "
                        "created_s, updated_s, message, owner, digest, reply_json, class) "
                        "VALUES (?1, ?2, ?3, 'accepted', '', 0.0, 0, ?4, ?4, '', ?5, ?6, ?7, ?8)"};
  insert.bind_all(job.id.value, job.process, job.request_json, job.created, job.owner, job.digest,
                  job.reply_json, class_name(job.job_class));
  insert.run();
}

std::optional<JobRecord> JobRepository::find(const JobId& id) const {
  sql::Statement query{db_, "SELECT " + job_columns + "FROM job WHERE id = ?1"};
  query.bind(1, id.value);
  if (!query.step()) return std::nullopt;
  return read_job(query);
}

std::vector<JobRecord> JobRepository::list(std::int64_t before, int limit, const JobFilter& filter) const {
  sql::Statement query = select_jobs(db_, "(?1 = 0 OR row < ?1)", before, limit, filter);
  return read_jobs(query);
}

PartialList<JobRecord> JobRepository::list_past_damage(std::int64_t before, int limit,
                                                       const JobFilter& filter) const {
  const auto of_row = [&](std::int64_t row) {
    sql::Statement query = select_jobs(db_, "row = ?1", row, 1, filter);
    return query.step() ? std::optional{read_job(query)} : std::nullopt;
  };
  return repository::list_past_damage(
      db_, job_table, {.behind = before, .limit = limit, .descending = true},
      [&] { return list(before, limit, filter); }, of_row);
}

std::optional<JobRecord> JobRepository::find_shared(const std::string& digest,
                                                    const std::string& owner) const {
  sql::Statement query{db_, "SELECT " + job_columns +
                                "FROM job WHERE digest = ?1 AND (status = 'successful' OR (owner = ?2 AND "
                                "status IN ('accepted', 'running'))) ORDER BY status = 'successful' DESC, "
                                "row DESC LIMIT 1"};
  query.bind_all(digest, owner);
  std::optional<JobRecord> shared;
  (void)sql::meets_no_damage([&] {
    if (query.step()) shared = read_job(query);
  });
  return shared;
}

std::vector<JobRecord> JobRepository::changed_since(std::int64_t change, int limit) const {
  sql::Statement query{db_, "SELECT " + job_columns + "FROM job WHERE change > ?1 ORDER BY change LIMIT ?2"};
  query.bind_all(change, std::max(limit, 0));
  return read_jobs(query);
}

std::int64_t JobRepository::last_change() const {
  sql::Statement query{db_, "SELECT change FROM job_clock"};
  return query.step() ? query.integer(0) : 0;
}

std::int64_t JobRepository::count(JobStatus status) const {
  sql::Statement query{db_, "SELECT count(*) FROM job WHERE status = ?1"};
  query.bind(1, status_name(status));
  return query.step() ? query.integer(0) : 0;
}

void JobRepository::touch_queue() { sql::execute(db_, "UPDATE job_clock SET change = change"); }

std::optional<JobRecord> JobRepository::claim(const std::string& worker, core::UtcTime now,
                                              core::Seconds lease, std::optional<JobClass> only,
                                              std::optional<std::int64_t> most_of_owner) {
  fail_exhausted(db_, now);
  Queue queue;
  while (true) {
    std::optional<std::int64_t> row;
    try {
      row = next_in_turn(db_, queue, worker, now, only, most_of_owner);
      if (!row) return std::nullopt;
      sql::Transaction transaction{db_};
      row = next_in_turn(db_, queue, worker, now, only, most_of_owner);
      std::optional<JobRecord> claimed;
      if (row) claimed = take(db_, *row, worker, now, lease);
      transaction.commit();
      if (claimed || !row) return claimed;
    } catch (const sql::Failure& failure) {
      if (failure.trouble() != sql::Trouble::damaged || !queue.leave_out(db_, row)) throw;
    }
  }
}

bool JobRepository::renew(const JobId& id, const std::string& worker, const std::string& stage,
                          double progress, core::UtcTime now, core::Seconds lease) {
  sql::Statement update{
      db_,
      "UPDATE job SET stage = ?3, progress = ?4, updated_s = ?5, lease_until_s = ?6 WHERE id = ?1 "
      "AND worker = ?2 AND status = 'running'"};
  update.bind_all(id.value, worker, stage, progress, now, now + lease);
  return update.run() > 0;
}

bool JobRepository::succeed(const JobId& id, const std::string& worker, const std::string& result_json,
                            core::UtcTime now, const std::string& message) {
  sql::Statement update{
      db_,
      "UPDATE job SET status = 'successful', result_json = ?3, stage = '', progress = 1.0, worker = NULL, "
      "lease_until_s = NULL, finished_s = ?4, updated_s = ?4, message = ?5 WHERE id = ?1 AND worker = ?2 AND "
      "status = 'running'"};
  update.bind_all(id.value, worker, result_json, now, message);
  return update.run() > 0;
}

bool JobRepository::fail(const JobId& id, const std::string& worker, const std::string& message,
                         core::UtcTime now) {
  sql::Statement update{
      db_,
      "UPDATE job SET status = 'failed', message = ?3, worker = NULL, lease_until_s = NULL, "
      "finished_s = ?4, updated_s = ?4 WHERE id = ?1 AND worker = ?2 AND status = 'running'"};
  update.bind_all(id.value, worker, message, now);
  return update.run() > 0;
}

void JobRepository::hand_back(const std::string& worker, core::UtcTime now) {
  update_jobs(db_,
              "status = 'accepted', attempts = attempts - 1, started_s = CASE WHEN attempts = 1 THEN NULL "
              "ELSE started_s END, stage = "
              "'', progress = 0.0, worker = NULL, lease_until_s = NULL, updated_s = ?2",
              "worker = ?1 AND status = 'running'",
              [&](sql::Statement& statement) { statement.bind_all(worker, now); });
}

void JobRepository::release_all_leases(core::UtcTime now) {
  update_jobs(db_, "worker = NULL, lease_until_s = NULL, updated_s = ?1", "status = 'running'",
              [&](sql::Statement& statement) { statement.bind(1, now); });
}

bool JobRepository::dismiss(const JobId& id, core::UtcTime now) {
  sql::Statement update{
      db_,
      "UPDATE job SET status = 'dismissed', message = 'dismissed on request', worker = NULL, "
      "lease_until_s = NULL, finished_s = ?2, updated_s = ?2 WHERE id = ?1 AND status IN "
      "('accepted', 'running')"};
  update.bind_all(id.value, now);
  return update.run() > 0;
}

bool JobRepository::remove(const JobId& id) {
  sql::Statement remove{db_, "DELETE FROM job WHERE id = ?1"};
  remove.bind(1, id.value);
  return remove.run() > 0;
}

}  // namespace floeplan::repository
