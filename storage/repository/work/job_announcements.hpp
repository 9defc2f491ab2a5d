#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "storage/repository/work/job_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Jobs that other sessions have changed.
struct ChangedJobs {
  struct Job {
    JobId id;
    std::string status;  // its new status; or "parts": it has parts to do; "part": one of them is finished
  };
  std::vector<Job> jobs;  // in the order of their changes
  bool missed{false};     // the connection was lost for a while, and any job may have changed
};

/// From this call on, the connection receives each change of a job that a client can see. Only a shared store
/// announces changes.
void listen_to_jobs(sql::Connection& db);

/// Waits until jobs have changed, at most this long.
[[nodiscard]] ChangedJobs wait_for_changed_jobs(sql::Connection& db, std::chrono::milliseconds at_most);

}  // namespace floeplan::repository
