#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// A stretch of a job's work that is cut into parts; it needs the results of the stage before.
struct JobStage {
  JobId job;
  std::int64_t number{};  // in the order of the work
  std::string basis;      // what the results follow from besides the request: the version and the data
};

/// The parts of running jobs in a shared store, which several nodes do. A node holds a part by a lease; a part
/// whose holder was lost can be taken again. The parts of a job are removed when it ends.
/// Threads  as the connection: one thread at a time; several connections and processes may take parts at once
class JobParts {
 public:
  /// `db`  of a shared store; other stores keep no parts
  explicit JobParts(sql::Connection& db) : db_{db} {}

  /// Offers the parts of a stage. Existing parts of the same basis stay with their results, which an earlier
  /// worker of the job has left. Parts of another basis are removed.
  void offer(const JobStage& stage, std::size_t count);
  /// Takes the first part that no worker holds, until `now + lease`. Empty if there is none.
  [[nodiscard]] std::optional<std::size_t> take(const JobStage& stage, const std::string& holder,
                                                core::UtcTime now, core::Seconds lease);
  /// Stores the result of a part. False when it now belongs to another holder, or its job has ended.
  bool finish(const JobStage& stage, std::size_t part, const std::string& holder, const std::string& result);
  /// The finished parts, in their order.
  [[nodiscard]] std::vector<std::size_t> finished(const JobStage& stage) const;
  /// Empty: the part is not finished.
  [[nodiscard]] std::optional<std::string> result(const JobStage& stage, std::size_t part) const;
  /// Renews the leases of this holder's parts. False once the job has ended; its work must then stop.
  [[nodiscard]] bool renew(const JobId& job, const std::string& holder, core::UtcTime now,
                           core::Seconds lease);
  /// Gives back the parts that this holder has not finished.
  void give_back(const JobId& job, const std::string& holder);
  /// The running job of another node that has a part to take; of several the one that began first.
  /// `node`    the beginning of the names of this node's workers
  /// `except`  jobs that this node cannot help
  [[nodiscard]] std::optional<JobId> in_need(const std::string& node, core::UtcTime now,
                                             const std::set<JobId>& except) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
