#include "server/jobs/job_board.hpp"

#include <algorithm>
#include <chrono>
#include <random>
#include <string_view>

#include "server/jobs/job_class.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::jobs {
namespace {

using repository::JobId;
using repository::JobRecord;
using routes::SubmissionRefused;

/// A random id of 128 bits from the operating system, so that nobody can guess the id of another user's job.
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

JobRecord new_job(const routes::Submission& submission, core::UtcTime now) {
  JobRecord job;
  job.id = random_id();
  job.process = submission.process;
  job.request_json = submission.inputs_json;
  job.job_class = class_of(job.process, job.request_json);
  job.owner = submission.owner;
  job.digest = submission.digest;
  job.reply_json = submission.reply_json;
  job.created = now;
  job.updated = now;
  return job;
}

/// The job of an earlier request with the same key; empty if there is none.
tl::expected<std::optional<JobRecord>, SubmissionRefused> find_by_key(sql::Connection& db,
                                                                      const repository::IdempotencyKey& key,
                                                                      core::UtcTime now) {
  repository::KeptAnswers answers{db};
  answers.remove_expired(now);
  const auto kept = answers.find(key);
  if (!kept) return std::optional<JobRecord>{};
  if (kept->request_sha256 != key.request_sha256 || !kept->job)
    return tl::unexpected(SubmissionRefused::key_reused);
  auto job = repository::JobRepository{db}.find(*kept->job);
  if (!job) return tl::unexpected(SubmissionRefused::job_removed);
  return job;
}

/// A job that does, or has done, the same work.
std::optional<JobRecord> find_shared(sql::Connection& db, const routes::Submission& submission) {
  if (!submission.digest || submission.force) return std::nullopt;
  return repository::JobRepository{db}.find_shared(*submission.digest, submission.owner);
}

/// Whether the queue accepts another job of the owner.
bool has_room(const repository::JobRepository& jobs, const std::string& owner) {
  constexpr auto waiting = repository::JobStatus::accepted;
  if (jobs.count(waiting) >= JobBoard::max_waiting) return false;
  if (owner.empty()) return true;
  const auto own =
      jobs.list_past_damage(0, JobBoard::max_waiting_of_owner, {.status = waiting, .owner = owner});
  return std::ssize(own.whole) < JobBoard::max_waiting_of_owner;
}

}  // namespace

tl::expected<JobRecord, SubmissionRefused> JobBoard::submit(sql::Connection& db,
                                                            const routes::Submission& submission,
                                                            core::UtcTime now) {
  // One transaction, so that two equal submissions at the same time create only one job.
  sql::Transaction transaction{db};
  if (submission.key) {
    auto repeated = find_by_key(db, *submission.key, now);
    if (!repeated) return tl::unexpected(repeated.error());
    if (*repeated) return **repeated;
  }
  repository::JobRepository jobs{db};
  const auto shared = find_shared(db, submission);
  if (!shared && !has_room(jobs, submission.owner)) return tl::unexpected(SubmissionRefused::queue_full);
  JobRecord job = shared.value_or(new_job(submission, now));
  if (!shared) jobs.submit(job);
  if (submission.key) repository::KeptAnswers{db}.insert(*submission.key, job.id, std::nullopt, now);
  transaction.commit();
  if (shared) return job;

  wake_workers();
  announce(job.id);
  return job;
}

bool JobBoard::dismiss(sql::Connection& db, const JobId& id, core::UtcTime now) {
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

// The empty id, which no job has, stands for all jobs.
std::shared_ptr<void> JobBoard::subscribe_to_all(std::function<void()> wake) {
  return subscribe({}, std::move(wake));
}

std::uint64_t JobBoard::submissions() const {
  const std::lock_guard lock{mutex_};
  return submissions_;
}

void JobBoard::wait_for_work(std::uint64_t seen, const std::stop_token& stop) {
  std::unique_lock lock{mutex_};
  work_.wait_for(lock, stop, std::chrono::seconds{1}, [&] { return submissions_ > seen; });
}

std::stop_source JobBoard::begin(const JobId& id, const std::string& worker,
                                 std::chrono::steady_clock::time_point deadline) {
  const std::lock_guard lock{mutex_};
  Entry& entry = running_[id];
  entry.job.id = id;
  entry.job.worker = worker;
  entry.job.deadline = deadline;
  return entry.stop;
}

void JobBoard::report(const JobId& id, std::string_view stage, double progress) {
  const std::lock_guard lock{mutex_};
  const auto found = running_.find(id);
  if (found == running_.end()) return;
  RunningJob& job = found->second.job;
  job.stage = stage;
  job.progress = std::max(job.progress, progress);  // progress never decreases, even if a part is repeated
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

void JobBoard::stop_overdue(std::chrono::steady_clock::time_point now) {
  const std::lock_guard lock{mutex_};
  for (auto& [id, entry] : running_) {
    if (entry.overdue || now < entry.job.deadline) continue;
    entry.overdue = true;
    entry.stop.request_stop();
  }
}

bool JobBoard::is_overdue(const JobId& id) const {
  const std::lock_guard lock{mutex_};
  const auto found = running_.find(id);
  return found != running_.end() && found->second.overdue;
}

void JobBoard::stop_all() {
  const std::lock_guard lock{mutex_};
  for (auto& [id, entry] : running_) entry.stop.request_stop();
}

void JobBoard::announce(const JobId& id) {
  const std::lock_guard lock{mutex_};
  wake(id);
  wake({});
}

void JobBoard::take_note(const JobId& id, const std::string& status) {
  using repository::JobStatus;
  if (status == repository::status_name(JobStatus::accepted) || status == "parts") wake_workers();
  const std::lock_guard lock{mutex_};
  // A job that runs here and is still running has only told its progress, which this process has stored itself.
  const auto found = running_.find(id);
  if (found != running_.end() && status != repository::status_name(JobStatus::running) && status != "parts" &&
      status != "part")
    found->second.job.changed = true;
  wake(id);
  wake({});
}

void JobBoard::take_note_of_all() {
  wake_workers();
  const std::lock_guard lock{mutex_};
  for (auto& [id, entry] : running_) entry.job.changed = true;
  for (const auto& [id, waiting] : subscribers_) wake(id);
}

void JobBoard::wake_workers() {
  {
    const std::lock_guard lock{mutex_};
    ++submissions_;
  }
  work_.notify_all();  // all, because a worker takes only jobs of its class
}

void JobBoard::wake(const JobId& id) {
  const auto found = subscribers_.find(id);
  if (found == subscribers_.end()) return;
  for (const auto& [number, wake_up] : found->second) wake_up();
}

}  // namespace floeplan::jobs
