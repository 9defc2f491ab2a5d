#pragma once

#include <thread>

#include "server/jobs/job_board.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::jobs {

/// A thread that hears what other nodes do with the jobs of a shared store, and wakes those who wait for it here.
/// Its connection marks the store as used by this node. Waking only saves time: nobody relies on being woken, since each who waits looks into the store once a second.
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
