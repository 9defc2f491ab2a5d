#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "api/service/ingest_service.hpp"
#include "api/service/kept_work.hpp"
#include "server/jobs/job_board.hpp"
#include "server/jobs/job_class.hpp"
#include "server/jobs/shared_parts.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::jobs {

/// Opens a connection to the store, for one thread.
using OpenStore = std::function<sql::Connection()>;

/// The classes of jobs that a pool takes.
using Lanes = std::set<repository::JobClass>;
inline const Lanes all_lanes{repository::JobClass::interactive, repository::JobClass::batch,
                             repository::JobClass::ingest};

/// Threads that take jobs from the queue and run them, at lower priority than the rest of the process; and
/// one thread that renews leases, checks time limits and stores progress.
/// Classes  each class has its own threads: `workers` for interactive jobs of one owner and one more for
///          other owners, `batches_at_once` for batches, and one for ingestion. So a pilot who plans never
///          waits for a batch or a large file. A batch that only yielded between its parts would be too slow,
///          because a flight may take half a minute
/// Priority batches yield to interactive jobs at any moment by the niceness of their threads, and lose no
/// work. Beside one busy
///          interactive thread, a batch thread gets 15/(15+110) = 12 % of their core (the kernel's weights of
///          niceness 19
///          and 10, sched_prio_to_weight); without interactive jobs it gets the whole core. So interactive
///          jobs slow a batch
///          down at most 8 times if there are no more workers than cores Fairness between owners within each
///          class, see JobRepository::claim; the kernel shares the cores evenly between
///          simultaneous batches
/// A batch of flights, a window of departures and a plan with ensemble members use as many threads as there
/// are workers; at a shared store one thread for batches that has none of its own does parts of another node's, see
/// SharedParts. Caches between jobs hold at most 256 MiB of currents and 128 MiB of leg cost models.
/// Limits   a job that exceeds its class's time limit is stopped and fails, with a message what to do
/// Start    jobs that a killed process left running can be taken again: at once where one server alone uses the
///          store, else when their lease has expired, half a minute after the process was killed
/// Stop     stop() or the destructor: running work is stopped and returns to the queue
/// Errors   exceptions of `open_store` leave the constructor; an exception of a job makes it fail, except
///          that it goes back to the queue if the store fails temporarily (lock of another process, lost connection; full
///          disk, except of an ingestion); exceptions of the store while looking for work are logged, and the pool tries again
class WorkerPool {
 public:
  /// Number of batches, of different owners or different processes, that run at the same time.
  static constexpr std::size_t batches_at_once = 6;

  WorkerPool(const OpenStore& open_store, JobBoard& board, std::size_t workers,
             service::IngestPlace place = {}, TimeLimits limits = {}, const Lanes& lanes = all_lanes);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  void stop();

 private:
  void work(sql::Connection& db, const std::string& name, repository::JobClass job_class,
            const std::stop_token& stop);
  void run(sql::Connection& db, const repository::JobRecord& job, const std::string& worker,
           const std::stop_token& pool_stop);
  /// Where the work of a job is done: here, or at several nodes.
  [[nodiscard]] std::unique_ptr<core::Executor> executor_of(sql::Connection& db,
                                                            const repository::JobRecord& job,
                                                            const std::string& worker,
                                                            const std::stop_source& stop);
  /// Does parts of a batch of another node, if one needs help. Returns  false if none does
  bool help(sql::Connection& db, const std::string& worker, const std::stop_token& stop);
  void keep_leases(sql::Connection& db, const std::stop_token& stop);

  JobBoard& board_;     // borrowed
  bool shared_{false};  // the store, with other nodes
  core::Seconds lease_{};
  std::size_t workers_;
  service::IngestPlace place_;
  TimeLimits limits_;
  service::KeptWork kept_;
  PartHolders part_holders_;
  std::mutex helping_;  // held by the one thread that helps another node
  std::set<repository::JobId>
      beyond_help_;  // jobs that this node could do nothing for; belongs to that thread
  std::vector<std::jthread> threads_;
  std::jthread lease_keeper_;
};

}  // namespace floeplan::jobs
