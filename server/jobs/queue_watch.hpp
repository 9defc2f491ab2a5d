#pragma once

#include <thread>

#include "server/jobs/job_board.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::jobs {

/// A thread that receives the notices of other nodes about the jobs of a shared store, and wakes the threads
/// of this node that wait for such a job. Its connection marks the store as used by this node. A lost notice
/// only costs time, because every waiting thread also looks into the store once a second.
class QueueWatch {
 public:
  /// `db`     a connection of its own
  /// `board`  is borrowed
  /// Errors   sql::Failure when the store cannot be reached
  QueueWatch(sql::Connection db, JobBoard& board);

 private:
  std::jthread thread_;
};

}  // namespace floeplan::jobs
