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
/// Errors   std::runtime_error for a name that is none
[[nodiscard]] JobStatus parse_status(const std::string& name);

/// How long somebody waits for a job, and with it which workers take it. Workers of any class take the first first.
enum class JobClass {
  interactive,  // somebody waits for one plan, one evaluation, one flight
  batch,  // many parts that each take as long as an interactive job: flights, departures, members of an ensemble
  ingest  // reads files, which may take minutes
};

[[nodiscard]] std::string class_name(JobClass job_class);
/// Errors   std::runtime_error for a name that is none
[[nodiscard]] JobClass parse_class(const std::string& name);

/// A job as it stands in the store.
struct JobRecord {
  std::int64_t row{};  // given by the store, ascending in the order of submission
  JobId id;
  std::string process;       // "plan-route"
  std::string request_json;  // the execute request's inputs
  JobClass job_class{JobClass::interactive};
  std::string owner{};                  // who asked for it; empty: nobody in particular
  std::optional<std::string> digest{};  // of all that the result follows from; empty: shared with nobody
  std::string reply_json{"{}"};         // which outputs the client wants, and in which form
  JobStatus status{JobStatus::accepted};
  std::string stage;  // of the running work, in words
  double progress{};  // 0 to 1
  int attempts{};     // how often a worker has begun it
  core::UtcTime created;
  std::optional<core::UtcTime> started;
  std::optional<core::UtcTime> finished;
  core::UtcTime updated;
  std::optional<std::string> result_json;  // when successful
  std::string message;    // why it failed or was dismissed, or gave no route although it was successful
  std::int64_t change{};  // given by the store: grows over all jobs with every change that a client sees
};

/// Which jobs a list wants. Everything empty: all.
struct JobFilter {
  std::optional<JobStatus> status{};
  std::optional<std::string> process{};
  std::optional<std::string> owner{};
  std::optional<core::UtcTime> created_from{};
  std::optional<core::UtcTime> created_to{};
  std::optional<core::Seconds> least_duration{};  // from its start to its end, or so far
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
  /// Newest first, at most `limit` with a row below `before` (0: from the newest).
  [[nodiscard]] std::vector<JobRecord> list(std::int64_t before, int limit,
                                            const JobFilter& filter = {}) const;
  /// The same, past jobs that are damaged.
  [[nodiscard]] PartialList<JobRecord> list_past_damage(std::int64_t before, int limit,
                                                        const JobFilter& filter = {}) const;
  /// A job whose result follows from the same: the newest that was successful, else this owner's newest that has not
  /// ended. Nothing where one of them cannot be read: the work is then done anew.
  [[nodiscard]] std::optional<JobRecord> find_shared(const std::string& digest,
                                                     const std::string& owner) const;
  /// Jobs that changed after the change of this number, in the order of their last changes, at most `limit`.
  /// A job that changed several times comes once, as it stands.
  [[nodiscard]] std::vector<JobRecord> changed_since(std::int64_t change, int limit) const;
  /// The number of the last change of all.
  [[nodiscard]] std::int64_t last_change() const;
  [[nodiscard]] std::int64_t count(JobStatus status) const;
  /// Writes to the queue as a new job would, and changes nothing.
  /// Errors  sql::Failure where a job could not be taken
  void touch_queue();

  /// An accepted job, or a running one whose lease ran out, made this worker's until `now + lease`: of the first class
  /// the oldest of the owner with the fewest running jobs of this class, of several owners the one whose last began
  /// longest ago. Of one owner's batches of one process no two run at the same time: their order is kept, and one owner
  /// does not take the workers of all.
  /// Jobs that cannot be read or written are passed over: one that is damaged holds up no other.
  /// `only`           jobs of this class; empty: of any
  /// `most_of_owner`  owners with so many running jobs of the class are passed over; empty: none is
  [[nodiscard]] std::optional<JobRecord> claim(const std::string& worker, core::UtcTime now,
                                               core::Seconds lease, std::optional<JobClass> only = {},
                                               std::optional<std::int64_t> most_of_owner = {});
  /// Reports progress and renews the lease. False when the job was dismissed or is no longer this worker's:
  /// stop then.
  [[nodiscard]] bool renew(const JobId& id, const std::string& worker, const std::string& stage,
                           double progress, core::UtcTime now, core::Seconds lease);
  /// False when the job is no longer this worker's; the result is then dropped.
  /// `message`  why the result holds no route; empty: it holds what was asked for
  bool succeed(const JobId& id, const std::string& worker, const std::string& result_json, core::UtcTime now,
               const std::string& message = "");
  bool fail(const JobId& id, const std::string& worker, const std::string& message, core::UtcTime now);
  /// Gives back every running job of this worker (a graceful stop), not counted as an attempt.
  void hand_back(const std::string& worker, core::UtcTime now);
  /// At start: every running job whose worker belongs to this store's previous server process becomes
  /// claimable at once.
  void release_all_leases(core::UtcTime now);
  /// Dismisses an accepted or running job. False when it is unknown or already ended.
  bool dismiss(const JobId& id, core::UtcTime now);
  bool remove(const JobId& id);

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
