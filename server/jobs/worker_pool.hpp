#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "server/jobs/ingest_service.hpp"
#include "server/jobs/job_board.hpp"
#include "server/jobs/kept_work.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::jobs {

/// Opens a connection to the store, for one thread.
using OpenStore = std::function<sqlite::Connection()>;

/// Threads that take jobs from the queue and do them, at lower priority than the rest of the process, and one
/// that keeps their leases and writes their progress. One thread beside the `workers` ingests files and does nothing
/// else: nobody who plans waits for a large file.
/// A batch of flights uses as many threads as there are workers. Currents that a job has read are kept for the next, in
/// at most 256 MiB, and the seas that routes were judged in, in at most 128 MiB.
/// Start    jobs that a killed process left running become free at once Stop stop() or the destructor:
///          running work is asked to stop and goes back into the queue
/// Errors   what `open_store` throws while the pool is made; what a job throws fails that job, except that a plan which
///          the store cannot serve for a while, because the disk is full or another holds it, goes back into the
///          queue; what the store throws while looking for work is logged and tried again
class WorkerPool {
 public:
  WorkerPool(const OpenStore& open_store, JobBoard& board, std::size_t workers, IngestPlace place = {});
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  void stop();

 private:
  void work(sqlite::Connection& db, const std::string& name, repository::Lane lane,
            const std::stop_token& stop);
  void run(sqlite::Connection& db, const repository::JobRecord& job, const std::string& worker,
           repository::Lane lane, const std::stop_token& pool_stop);
  void keep_leases(sqlite::Connection& db, const std::stop_token& stop);

  JobBoard& board_;  // borrowed
  std::size_t workers_;
  IngestPlace place_;
  KeptWork kept_;
  std::vector<std::jthread> threads_;
  std::jthread lease_keeper_;
};

}  // namespace floeplan::jobs
