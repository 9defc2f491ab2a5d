#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "api/service/ingest_service.hpp"
#include "api/service/kept_work.hpp"
#include "server/jobs/job_board.hpp"
#include "server/jobs/job_class.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::jobs {

/// Opens a connection to the store, for one thread.
using OpenStore = std::function<sql::Connection()>;

/// Threads that take jobs from the queue and do them, at lower priority than the rest of the process, and one
/// that keeps their leases, their time limits, and writes their progress.
/// Classes  each has threads of its own: `workers` for the interactive jobs of one owner and one more for another,
///          `batches_at_once` for batches, one that ingests files. So nobody who plans waits for a batch or a large file,
///          however long their parts take: a flight may take half a minute, and a batch that gave way between flights
///          would be too late.
/// Priority batches yield to interactive jobs by the niceness of their threads, at any moment, and lose no work by it:
///          beside one interactive thread that never rests, a batch's has 15/(15+110) = 12 % of their core (the kernel's
///          weights of niceness 19 and 10, sched_prio_to_weight), and all of it when there is none. That is the bound on
///          starving, too: interactive jobs slow a batch 8 times where there are no more workers than cores.
/// Fairness between owners, within each class (JobRepository::claim); the kernel shares the cores evenly between the
///          threads of batches that run side by side.
/// A batch of flights, a window of departures and a plan over members use as many threads as there are workers. Currents that a job has read are kept for the next, in
/// at most 256 MiB, and the seas that routes were judged in, in at most 128 MiB.
/// Limits   a job that runs longer than its class may is stopped, and fails with what to do about it
/// Start    jobs that a killed process left running become free at once
/// Stop     stop() or the destructor: running work is asked to stop and goes back into the queue
/// Errors   what `open_store` throws while the pool is made; what a job throws fails that job, except that a plan which
///          the store cannot serve for a while, because the disk is full or another holds it, goes back into the
///          queue; what the store throws while looking for work is logged and tried again
class WorkerPool {
 public:
  /// Batches of different owners, or of different processes, that run side by side.
  static constexpr std::size_t batches_at_once = 6;

  WorkerPool(const OpenStore& open_store, JobBoard& board, std::size_t workers,
             service::IngestPlace place = {}, TimeLimits limits = {});
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  void stop();

 private:
  void work(sql::Connection& db, const std::string& name, repository::JobClass job_class,
            const std::stop_token& stop);
  void run(sql::Connection& db, const repository::JobRecord& job, const std::string& worker,
           const std::stop_token& pool_stop);
  void keep_leases(sql::Connection& db, const std::stop_token& stop);

  JobBoard& board_;  // borrowed
  std::size_t workers_;
  service::IngestPlace place_;
  TimeLimits limits_;
  service::KeptWork kept_;
  std::vector<std::jthread> threads_;
  std::jthread lease_keeper_;
};

}  // namespace floeplan::jobs
