#include "server/jobs/worker_pool.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <map>
#include <new>
#include <optional>
#include <random>

#include "api/log/log.hpp"
#include "api/service/threads.hpp"
#include "server/jobs/pause.hpp"
#include "server/jobs/process_runner.hpp"
#include "storage/sql/driver/failure.hpp"

namespace floeplan::jobs {
namespace {

using repository::JobClass;
using repository::JobRecord;
using repository::JobRepository;

// Of a store that only one server uses, and which takes back all leases when it starts: practically unlimited. A
// lease that expired because the clock was set would make a job run twice at the same time.
constexpr core::Seconds lease_of_only_server{1e9};
// Of a store that several nodes share: a node that was lost for six renewals is taken for dead, and another one
// takes its jobs. A node that comes back in time keeps them.
constexpr core::Seconds lease_among_nodes{30.0};
constexpr std::chrono::seconds renewal_interval{5};  // if there is no progress to store
constexpr std::chrono::milliseconds progress_interval{250};

/// Size of the cache of currents between jobs, bytes. Five days of hourly currents over 150 x 150 km on six
/// levels need half.
constexpr std::size_t most_kept_currents = std::size_t{256} << 20;
/// Size of the cache of leg cost models, bytes: each has at most 32 MB of currents and usually a few MB of
/// its safety map.
constexpr std::size_t most_kept_grounds = std::size_t{128} << 20;

/// Delay before a job that the store could not serve is started again.
constexpr std::chrono::milliseconds before_next_try{2000};

constexpr const char* no_memory =
    "the server has not enough memory for this; ask for less at once (a wider spacing_m, fewer sectors, a "
    "shorter window), or again when it has less to do";

/// A name that no other process has, so that a node which was killed and started again does not take its old jobs for
/// its own.
std::string name_of_node() {
  std::array<char, 256> host{};
  if (gethostname(host.data(), host.size() - 1) != 0) host.front() = '\0';
  std::random_device source;
  return std::string{host.data()} + "-" + std::to_string(getpid()) + "-" + std::to_string(source());
}

/// Lowers the priority of this thread below that of requests; batches below interactive jobs. Linux has a
/// priority for each thread, and new threads inherit it.
void lower_priority(JobClass job_class) {
  const int niceness = job_class == JobClass::batch ? 19 : 10;
  if (setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness) != 0) {
    log::warn({"the priority of a worker thread could not be lowered"});
  }
}

/// Whether a failure of the store may be temporary: the disk may get free space, another process may release its
/// lock, or the database may be reached again. For an ingestion a full disk is no such failure: a file too large for
/// the disk would fill it again and again. Its sender is told at once.
bool may_pass(const sql::Failure& failure, JobClass job_class) {
  switch (failure.trouble()) {
    case sql::Trouble::disk_full: return job_class != JobClass::ingest;
    case sql::Trouble::held_by_another:
    case sql::Trouble::not_writable: return true;
    case sql::Trouble::damaged:
    case sql::Trouble::other: break;
  }
  return false;
}

/// Stores the end of a job. The finished work must not be lost because disk or memory is full for a while, so
/// a failure is retried until it succeeds or the server stops. In that case the job returns to the queue when
/// the server starts again.
template <class Write>
void keep_trying(sql::Connection& db, const repository::JobId& id, const Write& write,
                 const std::stop_token& stop) {
  constexpr std::chrono::seconds between{2};
  while (true) {
    try {
      JobRepository jobs{db};
      write(jobs);
      return;
    } catch (const std::exception& error) {
      log::error({"job=", id.value, " its end could not be written down: ", error.what()});
      if (stop.stop_requested()) return;
    }
    pause(between, stop);
  }
}

}  // namespace

WorkerPool::WorkerPool(const OpenStore& open_store, JobBoard& board, std::size_t workers,
                       service::IngestPlace place, TimeLimits limits, const Lanes& lanes)
    : board_{board},
      workers_{workers},
      place_{std::move(place)},
      limits_{limits},
      kept_{.currents = repository::CurrentGridCache{most_kept_currents},
            .grounds = repository::RecentlyUsed<service::GroundKey, planning::search::RouteGround>{
                most_kept_grounds}} {
  auto db = open_store();
  shared_ = sql::is_shared(db);
  lease_ = shared_ ? lease_among_nodes : lease_of_only_server;
  if (!shared_) JobRepository{db}.release_all_leases(sql::time_of(db));
  // All connections are opened here, so that a failure prevents the start of the pool instead of ending a
  // thread later.
  lease_keeper_ = std::jthread{
      [this, own = open_store()](const std::stop_token& stop) mutable { keep_leases(own, stop); }};
  std::vector<JobClass> classes;
  if (lanes.contains(JobClass::interactive)) classes.assign(workers + 1, JobClass::interactive);
  if (lanes.contains(JobClass::batch)) classes.insert(classes.end(), batches_at_once, JobClass::batch);
  if (lanes.contains(JobClass::ingest)) classes.push_back(JobClass::ingest);
  const std::string node = name_of_node();
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const std::string name = node + "/" + std::to_string(i + 1);
    threads_.emplace_back([this, own = open_store(), name, job_class = classes[i]](
                              const std::stop_token& stop) mutable { work(own, name, job_class, stop); });
  }
}

WorkerPool::~WorkerPool() { stop(); }

void WorkerPool::stop() {
  for (auto& thread : threads_) thread.request_stop();
  board_.stop_all();
  threads_.clear();
  lease_keeper_ = {};
}

void WorkerPool::work(sql::Connection& db, const std::string& name, JobClass job_class,
                      const std::stop_token& stop) {
  lower_priority(job_class);
  std::optional<std::int64_t> most_of_owner;
  if (job_class == JobClass::interactive) most_of_owner = static_cast<std::int64_t>(workers_);
  while (!stop.stop_requested()) {
    const auto seen = board_.submissions();
    try {
      const auto job = JobRepository{db}.claim(name, sql::time_of(db), lease_, job_class, most_of_owner);
      if (job) {
        run(db, *job, name, stop);
        continue;
      }
      if (shared_ && job_class == JobClass::batch && help(db, name, stop)) continue;
    } catch (const std::exception& error) {
      log::error({"a worker could not read or write the queue: ", error.what()});
    }
    board_.wait_for_work(seen, stop);
  }
}

void WorkerPool::run(sql::Connection& db, const JobRecord& job, const std::string& worker,
                     const std::stop_token& pool_stop) {
  const auto begin = std::chrono::steady_clock::now();
  const core::Seconds limit = limits_.of(job.job_class);
  const std::stop_source job_stop =
      board_.begin(job.id, worker, begin + std::chrono::duration_cast<std::chrono::milliseconds>(limit));
  const std::stop_callback stop_with_pool{pool_stop,
                                          [source = job_stop]() mutable { source.request_stop(); }};
  board_.announce(job.id);
  log::info(
      {"job=", job.id.value, " process=", job.process, " attempt=", std::to_string(job.attempts), " begins"});

  tl::expected<ProcessResult, std::string> result;
  bool put_off = false;
  try {
    const auto executor = executor_of(db, job, worker, job_stop);
    result = run_process(
        db, job, place_, *executor, kept_, job_stop.get_token(),
        [&](std::string_view stage, double share) { board_.report(job.id, stage, share); }, sql::time_of(db));
  } catch (const std::bad_alloc&) {
    log::error({"job=", job.id.value, " broke off: no memory"});
    result = tl::unexpected(std::string{no_memory});
  } catch (const sql::Failure& failure) {
    put_off = may_pass(failure, job.job_class);
    log::error({"job=", job.id.value, put_off ? " is put off: " : " broke off: ", failure.what()});
    result = tl::unexpected(std::string{"the work broke off: "} + failure.what());
  } catch (const std::exception& error) {
    log::error({"job=", job.id.value, " broke off: ", error.what()});
    result = tl::unexpected(std::string{"the work broke off: "} + error.what());
  }
  const bool stopped = job_stop.stop_requested();
  const bool overdue = board_.is_overdue(job.id);
  const auto write_end = [&](JobRepository& jobs) {
    const core::UtcTime now = sql::time_of(db);
    if (overdue) {
      jobs.fail(job.id, worker, overdue_message(job.job_class, limit), now);
    } else if (stopped || put_off) {
      jobs.hand_back(worker, now);  // has no effect on a dismissed job
    } else if (result) {
      jobs.succeed(job.id, worker, result->json, now, result->message);
    } else {
      jobs.fail(job.id, worker, result.error(), now);
    }
  };
  keep_trying(db, job.id, write_end, pool_stop);
  board_.end(job.id);
  board_.announce(job.id);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  const char* outcome = overdue   ? "overdue"
                        : stopped ? "stopped"
                        : put_off ? "put off"
                        : result  ? "successful"
                                  : "failed";
  log::info({"job=", job.id.value, " outcome=", outcome, " seconds=", log::decimals(taken.count(), 3)});
  if (put_off) pause(before_next_try, pool_stop);
}

std::unique_ptr<core::Executor> WorkerPool::executor_of(sql::Connection& db, const JobRecord& job,
                                                        const std::string& worker,
                                                        const std::stop_source& stop) {
  if (!shared_ || job.job_class != JobClass::batch) return std::make_unique<service::Threads>(workers_);
  return std::make_unique<SharedParts>(
      db, board_, part_holders_,
      SharedParts::Settings{
          .job = job.id, .worker = worker, .threads = workers_, .lease = lease_, .stop = stop});
}

bool WorkerPool::help(sql::Connection& db, const std::string& worker, const std::stop_token& stop) {
  const std::unique_lock alone{helping_, std::try_to_lock};
  if (!alone) return false;
  const std::string node = worker.substr(0, worker.rfind('/') + 1);
  const auto id = repository::JobParts{db}.in_need(node, sql::time_of(db), beyond_help_);
  if (!id) {
    beyond_help_.clear();
    return false;
  }
  const auto job = JobRepository{db}.find(*id);
  if (!job) return true;
  std::stop_source enough;
  const std::stop_callback stop_with_pool{stop, [&] { enough.request_stop(); }};
  const SharedParts parts{db,
                          board_,
                          part_holders_,
                          {.job = *id,
                           .worker = worker,
                           .threads = workers_,
                           .lease = lease_,
                           .role = SharedParts::Role::helps,
                           .stop = enough}};
  log::info({"job=", id->value, " process=", job->process, " is helped"});
  try {
    // Whoever leads the job gives its result.
    (void)run_process(
        db, *job, place_, parts, kept_, enough.get_token(), [](std::string_view, double) {},
        sql::time_of(db));
  } catch (const std::exception& error) {
    log::error({"job=", id->value, " could not be helped: ", error.what()});
  }
  log::info({"job=", id->value, " parts=", std::to_string(parts.done_here()), " done here"});
  if (parts.done_here() == 0) beyond_help_.insert(*id);
  return true;
}

void WorkerPool::keep_leases(sql::Connection& db, const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  std::map<repository::JobId, Clock::time_point> renewed;
  Clock::time_point parts_renewed = Clock::now();
  while (!stop.stop_requested()) {
    board_.stop_overdue(Clock::now());
    const auto running = board_.running();
    std::map<repository::JobId, Clock::time_point> next;
    for (const auto& job : running) {
      const auto last = renewed.find(job.id);
      const bool due =
          job.changed || last == renewed.end() || Clock::now() - last->second >= renewal_interval;
      next[job.id] = due ? Clock::now() : last->second;
      if (!due) continue;
      try {
        const core::UtcTime now = sql::time_of(db);
        if (!JobRepository{db}.renew(job.id, job.worker, job.stage, job.progress, now, lease_))
          board_.stop(job.id);
      } catch (const std::exception& error) {
        log::error({"job=", job.id.value, " the lease could not be renewed: ", error.what()});
      }
      board_.announce(job.id);
    }
    renewed = std::move(next);
    if (Clock::now() - parts_renewed >= renewal_interval) {
      parts_renewed = Clock::now();
      try {
        part_holders_.renew(db, sql::time_of(db), lease_);
      } catch (const std::exception& error) {
        log::error({"the leases of parts could not be renewed: ", error.what()});
      }
    }
    pause(progress_interval, stop);
  }
}

}  // namespace floeplan::jobs
