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

/// What a running job has told of itself since it was last asked.
struct RunningJob {
  repository::JobId id;
  std::string worker;
  std::string stage;
  double progress{};
  bool changed{false};  // since the last call of running()
  std::chrono::steady_clock::time_point deadline{};
};

/// What this process knows of its jobs beside the store: who waits for which, and how to stop the ones that
/// run.
/// Threads  every member may be called from several threads at once
class JobBoard : public routes::JobGateway {
 public:
  /// More waiting jobs than this are refused.
  static constexpr std::int64_t max_waiting = 1000;
  /// More waiting jobs of one named owner are refused, too: nobody fills the queue alone.
  static constexpr int max_waiting_of_owner = 200;

  [[nodiscard]] tl::expected<repository::JobRecord, routes::SubmissionRefused> submit(
      sql::Connection& db, const routes::Submission& submission, core::UtcTime now) override;
  bool dismiss(sql::Connection& db, const repository::JobId& id, core::UtcTime now) override;
  [[nodiscard]] std::shared_ptr<void> subscribe(const repository::JobId& id,
                                                std::function<void()> wake) override;
  [[nodiscard]] std::shared_ptr<void> subscribe_to_all(std::function<void()> wake) override;

  /// Grows with every submission; read it before looking for work, and wait on it when there was none.
  [[nodiscard]] std::uint64_t submissions() const;
  /// Returns once there were more submissions than `seen`, after a second, or on `stop`.
  void wait_for_work(std::uint64_t seen, const std::stop_token& stop);

  /// A worker takes up a job; its work ends when the returned source is asked to stop.
  [[nodiscard]] std::stop_source begin(const repository::JobId& id, const std::string& worker,
                                       std::chrono::steady_clock::time_point deadline);
  void report(const repository::JobId& id, std::string_view stage, double progress);
  void end(const repository::JobId& id);
  /// The jobs of this process as they stand; takes back their `changed` marks.
  [[nodiscard]] std::vector<RunningJob> running();
  /// Asks the work on the job to stop, if it runs here.
  void stop(const repository::JobId& id);
  /// Asks the work on every job to stop whose deadline has passed.
  void stop_overdue(std::chrono::steady_clock::time_point now);
  /// Whether the work on the job was asked to stop because of its deadline.
  [[nodiscard]] bool is_overdue(const repository::JobId& id) const;
  /// Asks all work to stop.
  void stop_all();
  /// Wakes everybody who waits for the job, or for any.
  void announce(const repository::JobId& id);

 private:
  struct Entry {
    RunningJob job;
    std::stop_source stop;
    bool overdue{false};
  };

  void wake(const repository::JobId& id);

  mutable std::mutex mutex_;
  std::condition_variable_any work_;
  std::uint64_t submissions_{0};
  std::uint64_t next_subscription_{0};
  std::map<repository::JobId, std::map<std::uint64_t, std::function<void()>>> subscribers_;
  std::map<repository::JobId, Entry> running_;
};

}  // namespace floeplan::jobs
