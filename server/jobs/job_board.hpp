#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include "api/routes/request/job_gateway.hpp"

namespace floeplan::jobs {

/// The progress that a running job has reported.
struct RunningJob {
  repository::JobId id;
  std::string worker;
  std::string stage;
  double progress{};
  bool changed{false};  // since the last call of running()
  std::chrono::steady_clock::time_point deadline{};
};

/// The part of the job system that is not in the store: the subscribers of each job, and the means to stop
/// running jobs.
/// Threads  every member may be called from several threads at once
class JobBoard : public routes::JobGateway {
 public:
  /// Largest number of waiting jobs; more are refused.
  static constexpr std::int64_t max_waiting = 1000;
  /// Largest number of waiting jobs of one named owner, so that nobody fills the queue alone.
  static constexpr int max_waiting_of_owner = 200;

  [[nodiscard]] tl::expected<repository::JobRecord, routes::SubmissionRefused> submit(
      sql::Connection& db, const routes::Submission& submission, core::UtcTime now) override;
  bool dismiss(sql::Connection& db, const repository::JobId& id, core::UtcTime now) override;
  [[nodiscard]] std::shared_ptr<void> subscribe(const repository::JobId& id,
                                                std::function<void()> wake) override;
  [[nodiscard]] std::shared_ptr<void> subscribe_to_all(std::function<void()> wake) override;

  /// A number that grows with every submission. Read it before looking for work; if there was none, pass it
  /// to wait_for_work.
  [[nodiscard]] std::uint64_t submissions() const;
  /// Returns when there were more submissions than `seen`, after one second, or on `stop`.
  void wait_for_work(std::uint64_t seen, const std::stop_token& stop);

  /// A worker begins a job. The job's work must end when a stop of the returned source is requested.
  [[nodiscard]] std::stop_source begin(const repository::JobId& id, const std::string& worker,
                                       std::chrono::steady_clock::time_point deadline);
  void report(const repository::JobId& id, std::string_view stage, double progress);
  void end(const repository::JobId& id);
  /// The running jobs of this process; resets their `changed` marks.
  [[nodiscard]] std::vector<RunningJob> running();
  /// Requests the job's work to stop, if it runs in this process.
  void stop(const repository::JobId& id);
  /// Requests the work on all jobs whose deadline has passed to stop.
  void stop_overdue(std::chrono::steady_clock::time_point now);
  /// Whether the job was stopped because its deadline has passed.
  [[nodiscard]] bool is_overdue(const repository::JobId& id) const;
  /// Requests all work to stop.
  void stop_all();
  /// Wakes all who wait for this job or for any job.
  void announce(const repository::JobId& id);
  /// Another process has changed a job, `status` as in repository::ChangedJobs. Wakes the threads that this concerns:
  /// for a waiting job and for parts the workers, and for a job that runs here the thread that renews leases, because
  /// the job may have been dismissed.
  void take_note(const repository::JobId& id, const std::string& status);
  /// Other processes may have changed any job. Wakes everybody.
  void take_note_of_all();

 private:
  struct Entry {
    RunningJob job;
    std::stop_source stop;
    bool overdue{false};
  };

  void wake_workers();
  void wake(const repository::JobId& id);

  mutable std::mutex mutex_;
  std::condition_variable_any work_;
  std::uint64_t submissions_{0};
  std::uint64_t next_subscription_{0};
  std::map<repository::JobId, std::map<std::uint64_t, std::function<void()>>> subscribers_;
  std::map<repository::JobId, Entry> running_;
};

}  // namespace floeplan::jobs
