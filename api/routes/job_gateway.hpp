#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "engine/core/units.hpp"
#include "storage/repository/job_repository.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::routes {

/// What the resources need of the job system.
/// Threads  may be called from several threads at once, each with its own connection
class JobGateway {
 public:
  virtual ~JobGateway() = default;

  /// Puts a job into the durable queue; it is on disk when the call returns. nullopt: the queue is full, come
  /// again.
  [[nodiscard]] virtual std::optional<repository::JobRecord> submit(sqlite::Connection& db,
                                                                    const std::string& process,
                                                                    const std::string& inputs_json,
                                                                    core::UtcTime now) = 0;
  /// Ends the job, stopping its work within a second. False when it is unknown or already ended.
  virtual bool dismiss(sqlite::Connection& db, const repository::JobId& id, core::UtcTime now) = 0;
  /// Calls `wake` after every change of the job until the returned object is gone.
  [[nodiscard]] virtual std::shared_ptr<void> subscribe(const repository::JobId& id,
                                                        std::function<void()> wake) = 0;
};

}  // namespace floeplan::routes
