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

/// Threads that take jobs from the queue and run them, at lower priority than the rest of the process. One
/// more thread renews leases, checks time limits and stores progress.
/// Classes  Each class has its own threads: `workers` for the interactive jobs of one owner and one more for
///          other owners, `batches_at_once` for batches, and one for ingestion. So a pilot who plans never
///          waits for a batch or a large file. If batches shared these threads and only yielded between their
///          parts, a pilot could wait half a minute, the time of one flight
/// Priority Batch threads have a niceness of 19, so they yield to interactive jobs at any moment and lose no
///          work. Beside one busy interactive thread, a batch thread gets 15/(15+110) = 12 % of their core:
///          15 and 110 are the kernel's weights of niceness 19 and 10 (sched_prio_to_weight). Without
///          interactive jobs it gets the whole core. So interactive jobs make a batch at most 8 times slower,
///          if there are no more workers than cores
/// Fairness Between the owners within a class: see JobRepository::claim. The kernel shares the cores evenly
///          between batches that run at the same time. A batch of flights, a window of departures and a plan
///          with ensemble members use as many threads as there are workers. At a shared store, a thread for
///          batches that has no batch of its own does parts of another node's batch, see SharedParts
/// Memory   Caches between jobs hold at most 256 MiB of currents and 128 MiB of leg cost models
/// Limits   A job that exceeds the time limit of its class is stopped and fails; its message says what to do
/// Start    Jobs that a killed process left running can be taken again: at once if only one server uses the
///          store, otherwise when their lease has expired, half a minute after the process was killed
/// Stop     stop() or the destructor: running work is stopped and returns to the queue
/// Errors   Exceptions of `open_store` leave the constructor. An exception of a job makes the job fail, unless
///          the store fails only for a while (lock of another process, lost connection; or a full disk, except
///          of an ingestion): then the job goes back to the queue. Exceptions of the store while the pool
///          looks for work are logged, and the pool tries again
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
