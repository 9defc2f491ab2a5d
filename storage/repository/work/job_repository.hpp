#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/repository/store/partial_list.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

struct JobId {
  std::string value;  // 128 random bits as 32 hexadecimal digits

  friend auto operator<=>(const JobId&, const JobId&) = default;
};

/// The states of OGC API - Processes, Part 1, table 13.
enum class JobStatus { accepted, running, successful, failed, dismissed };

[[nodiscard]] std::string status_name(JobStatus status);
/// The status with this name.
/// Errors   std::runtime_error for another name
[[nodiscard]] JobStatus parse_status(const std::string& name);

/// The class of a job: how urgent it is, and which workers take it. Workers for all classes take the first
/// class first.
enum class JobClass {
  interactive,  // a user waits for one plan, one evaluation, one flight
  batch,        // many parts of the length of an interactive job: flights, departures, ensemble members
  ingest        // reads files, which may take minutes
};

[[nodiscard]] std::string class_name(JobClass job_class);
/// The class with this name.
/// Errors   std::runtime_error for another name
[[nodiscard]] JobClass parse_class(const std::string& name);

/// A job in the store.
struct JobRecord {
  std::int64_t row{};  // given by the store, ascending in the order of submission
  JobId id;
  std::string process;       // "plan-route"
  std::string request_json;  // inputs of the request
  JobClass job_class{JobClass::interactive};
  std::string owner{};  // who requested it; empty: a server without tokens
  // digest of everything that determines the result; empty: the result is not shared
  std::optional<std::string> digest{};
  std::string reply_json{"{}"};  // the outputs that the client wants, and their form
  JobStatus status{JobStatus::accepted};
  std::string stage{};  // name of the current stage of the work
  double progress{};    // 0 to 1
  int attempts{};       // number of times that a worker has started it
  core::UtcTime created;
  std::optional<core::UtcTime> started;
  std::optional<core::UtcTime> finished;
  core::UtcTime updated;
  std::optional<std::string> result_json;  // set if successful
  std::string message;  // why it failed, was dismissed, or succeeded without finding a route
  // assigned by the store: increases over all jobs with every change that a client can see
  std::int64_t change{};
};

/// Conditions for a list of jobs. Empty members are no condition.
struct JobFilter {
  std::optional<JobStatus> status{};
  std::optional<std::string> process{};
  std::optional<std::string> owner{};
  std::optional<core::UtcTime> created_from{};
  std::optional<core::UtcTime> created_to{};
  std::optional<core::Seconds> least_duration{};  // time from its start to its end, or to now
  std::optional<core::Seconds> most_duration{};
};

/// The durable queue. Every change is one transaction that is on disk when the call returns.
/// A worker claims a job with a lease; a job whose lease ran out (its worker was killed) is claimable again,
/// at most `max_attempts` times, then it fails with the reason in `message`.
/// Threads  as the connection: one thread at a time; several connections and processes may claim at once
class JobRepository {
 public:
  explicit JobRepository(sql::Connection& db) : db_{db} {}

  static constexpr int max_attempts = 3;

  void submit(const JobRecord& job);
  [[nodiscard]] std::optional<JobRecord> find(const JobId& id) const;
  /// At most `limit` jobs with a row below `before`, newest first; 0: from the newest.
  [[nodiscard]] std::vector<JobRecord> list(std::int64_t before, int limit,
                                            const JobFilter& filter = {}) const;
  /// As `list`, without damaged jobs.
  [[nodiscard]] PartialList<JobRecord> list_past_damage(std::int64_t before, int limit,
                                                        const JobFilter& filter = {}) const;
  /// A job with the same digest: the newest successful one, or else this owner's newest that has not ended.
  /// nullopt also if one of them cannot be read; the work is then done again.
  [[nodiscard]] std::optional<JobRecord> find_shared(const std::string& digest,
                                                     const std::string& owner) const;
  /// At most `limit` jobs with a change number above `change`, in the order of their last changes. A job that
  /// changed several times is listed once, in its present state.
  [[nodiscard]] std::vector<JobRecord> changed_since(std::int64_t change, int limit) const;
  /// The highest change number of all jobs.
  [[nodiscard]] std::int64_t last_change() const;
  [[nodiscard]] std::int64_t count(JobStatus status) const;
  /// Writes to the queue as a new job would, but changes nothing.
  /// Errors  sql::Failure when a new job could not be stored
  void touch_queue();

  /// Assigns a job to this worker until `now + lease`: an accepted job, or a running one whose lease has
  /// expired. Chosen are, in this order: the first class; the owner with the fewest running jobs of this
  /// class; of several such owners the one whose last job started longest ago; the owner's oldest job. Batch
  /// jobs of one owner and one process never run at the same time, so that they keep their order and one
  /// owner does not occupy all workers. Damaged jobs are skipped and do not block others.
  /// `worker`         name of the node, "/", number of the worker there
  /// `only`           only jobs of this class; empty: of any class
  /// `most_of_owner`  owners with this number of running jobs of the class at this node are skipped; empty: no
  ///                  limit
  [[nodiscard]] std::optional<JobRecord> claim(const std::string& worker, core::UtcTime now,
                                               core::Seconds lease, std::optional<JobClass> only = {},
                                               std::optional<std::int64_t> most_of_owner = {});
  /// Reports progress and renews the lease. False when the job was dismissed or now belongs to another
  /// worker; the worker must then stop.
  [[nodiscard]] bool renew(const JobId& id, const std::string& worker, const std::string& stage,
                           double progress, core::UtcTime now, core::Seconds lease);
  /// Stores the result. False when the job now belongs to another worker; the result is then discarded.
  /// `message`  why the result contains no route; empty if it does
  bool succeed(const JobId& id, const std::string& worker, const std::string& result_json, core::UtcTime now,
               const std::string& message = "");
  bool fail(const JobId& id, const std::string& worker, const std::string& message, core::UtcTime now);
  /// Returns all running jobs of this worker to the queue (on a graceful stop); this does not count as an
  /// attempt.
  void hand_back(const std::string& worker, core::UtcTime now);
  /// Call at the start of the only server of a store: all running jobs, which belonged to workers of the previous
  /// server process, can be claimed at once.
  void release_all_leases(core::UtcTime now);
  /// Dismisses an accepted or running job. False when it is unknown or has ended.
  bool dismiss(const JobId& id, core::UtcTime now);
  bool remove(const JobId& id);

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
