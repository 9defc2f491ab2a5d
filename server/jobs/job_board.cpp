#include "server/jobs/job_board.hpp"

#include <chrono>
#include <random>
#include <string_view>

namespace floeplan::jobs {
namespace {

using repository::JobId;

/// 128 bits from the operating system: nobody can guess the id of somebody else's job.
JobId random_id() {
  constexpr std::string_view digits = "0123456789abcdef";
  std::random_device source;
  std::string text;
  for (int word = 0; word < 4; ++word) {
    const auto bits = source();
    for (unsigned shift = 0; shift < 32; shift += 4) text += digits[(bits >> shift) & 15U];
  }
  return {text};
}

}  // namespace

std::optional<repository::JobRecord> JobBoard::submit(sqlite::Connection& db, const std::string& process,
                                                      const std::string& inputs_json, core::UtcTime now) {
  repository::JobRepository jobs{db};
  if (jobs.count(repository::JobStatus::accepted) >= max_waiting) return std::nullopt;

  repository::JobRecord job;
  job.id = random_id();
  job.process = process;
  job.request_json = inputs_json;
  job.created = now;
  job.updated = now;
  jobs.submit(job);
  {
    const std::lock_guard lock{mutex_};
    ++submissions_;
  }
  work_.notify_all();  // a worker takes only what belongs to its lane
  return job;
}

bool JobBoard::dismiss(sqlite::Connection& db, const JobId& id, core::UtcTime now) {
  if (!repository::JobRepository{db}.dismiss(id, now)) return false;
  stop(id);
  announce(id);
  return true;
}

std::shared_ptr<void> JobBoard::subscribe(const JobId& id, std::function<void()> wake) {
  const std::lock_guard lock{mutex_};
  const std::uint64_t number = next_subscription_++;
  subscribers_[id].emplace(number, std::move(wake));
  return {nullptr, [this, id, number](void*) {
            const std::lock_guard guard{mutex_};
            const auto found = subscribers_.find(id);
            found->second.erase(number);
            if (found->second.empty()) subscribers_.erase(found);
          }};
}

std::uint64_t JobBoard::submissions() const {
  const std::lock_guard lock{mutex_};
  return submissions_;
}

void JobBoard::wait_for_work(std::uint64_t seen, const std::stop_token& stop) {
  std::unique_lock lock{mutex_};
  work_.wait_for(lock, stop, std::chrono::seconds{1}, [&] { return submissions_ > seen; });
}

std::stop_source JobBoard::begin(const JobId& id, const std::string& worker) {
  const std::lock_guard lock{mutex_};
  Entry& entry = running_[id];
  entry.job.id = id;
  entry.job.worker = worker;
  return entry.stop;
}

void JobBoard::report(const JobId& id, std::string_view stage, double progress) {
  const std::lock_guard lock{mutex_};
  const auto found = running_.find(id);
  if (found == running_.end()) return;
  RunningJob& job = found->second.job;
  job.stage = stage;
  job.progress = progress;
  job.changed = true;
}

void JobBoard::end(const JobId& id) {
  const std::lock_guard lock{mutex_};
  running_.erase(id);
}

std::vector<RunningJob> JobBoard::running() {
  const std::lock_guard lock{mutex_};
  std::vector<RunningJob> jobs;
  for (auto& [id, entry] : running_) {
    jobs.push_back(entry.job);
    entry.job.changed = false;
  }
  return jobs;
}

void JobBoard::stop(const JobId& id) {
  const std::lock_guard lock{mutex_};
  const auto found = running_.find(id);
  if (found != running_.end()) found->second.stop.request_stop();
}

void JobBoard::stop_all() {
  const std::lock_guard lock{mutex_};
  for (auto& [id, entry] : running_) entry.stop.request_stop();
}

void JobBoard::announce(const JobId& id) {
  const std::lock_guard lock{mutex_};
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end()) return;
  for (const auto& [number, wake] : found->second) wake();
}

}  // namespace floeplan::jobs
