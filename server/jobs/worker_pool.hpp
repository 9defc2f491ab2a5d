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

/// Opens a connection to the store; called once by each thread.
using OpenStore = std::function<sqlite::Connection()>;

/// Threads that take jobs from the queue and do them, at lower priority than the rest of the process, and one
/// that keeps their leases and writes their progress. One thread beside the `workers` ingests files and does nothing
/// else: nobody who plans waits for a large file.
/// A batch of flights uses as many threads as there are workers. Currents that a job has read are kept for the next, in
/// at most 256 MiB, and the seas that routes were judged in, in at most 128 MiB.
/// Start    jobs that a killed process left running become free at once Stop stop() or the destructor:
///          running work is asked to stop and goes back into the queue
/// Errors   what a job throws fails that job; what the store throws while looking for work is logged and
///          tried again
class WorkerPool {
 public:
  WorkerPool(OpenStore open_store, JobBoard& board, std::size_t workers, IngestPlace place = {});
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  void stop();

 private:
  void work(const std::stop_token& stop, const std::string& name, repository::Lane lane);
  void run(sqlite::Connection& db, const repository::JobRecord& job, const std::string& worker,
           const std::stop_token& pool_stop);
  void keep_leases(const std::stop_token& stop);

  OpenStore open_store_;
  JobBoard& board_;  // borrowed
  std::size_t workers_;
  IngestPlace place_;
  KeptWork kept_;
  std::vector<std::jthread> threads_;
  std::jthread lease_keeper_;
};

}  // namespace floeplan::jobs
