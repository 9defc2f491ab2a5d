#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>

#include "api/service/threads.hpp"
#include "engine/core/executor.hpp"
#include "server/jobs/job_board.hpp"
#include "storage/repository/work/job_parts.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::jobs {

/// Who does parts of jobs at this node, so that their leases are renewed.
/// Threads  every member may be called from several threads at once
class PartHolders {
 public:
  struct Holder {
    repository::JobId job;
    std::stop_source stop;
  };

  void add(const std::string& name, Holder holder);
  void remove(const std::string& name);
  /// Renews the leases of all; requests those to stop whose job has ended.
  void renew(sql::Connection& db, core::UtcTime now, core::Seconds lease);

 private:
  std::mutex mutex_;
  std::map<std::string, Holder> holders_;
};

/// Does the parts of a job in a shared store together with other nodes. Each node that takes part does the same job
/// from its beginning, comes to the same parts, and does those that nobody has taken. One of them leads: it has
/// claimed the job, waits for all parts and stores the job's result. The others only help: their work on the job
/// stops when no part is left for them.
/// Basis   the version and the datasets in the store. Nodes whose basis differs do nothing together; when the datasets
///         change while the job runs, the leader does the rest alone
/// Faults  parts of a node that was lost are done again when its lease has expired. What a lost leader and its
///         helpers have finished stays for the next leader
class SharedParts final : public core::Executor {
 public:
  enum class Role { leads, helps };
  struct Settings {
    repository::JobId job;
    std::string worker;   // name of this node's worker
    std::size_t threads;  // at this node
    core::Seconds lease;
    Role role{Role::leads};
    std::stop_source stop{};  // of the work on the job at this node
  };

  /// `db`, `board`, `holders` are borrowed. `db` must not be used by others while `run_parts` runs.
  SharedParts(sql::Connection& db, JobBoard& board, PartHolders& holders, Settings settings);
  ~SharedParts() override;

  void run(std::size_t count, const Piece& piece) const override { threads_.run(count, piece); }
  /// Errors  as `run`; sql::Failure when the store fails
  void run_parts(const Parts& parts) const override;

  /// Number of parts that were done at this node.
  [[nodiscard]] std::size_t done_here() const { return done_here_; }

 private:
  class Stage;

  sql::Connection& db_;
  JobBoard& board_;
  PartHolders& holders_;
  Settings settings_;
  service::Threads threads_;
  std::string holder_;
  std::string basis_;
  // Of the work so far; only the thread that calls `run_parts` uses them.
  mutable std::int64_t stages_{0};
  mutable std::size_t done_here_{0};
};

}  // namespace floeplan::jobs
