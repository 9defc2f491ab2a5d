#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "engine/core/units.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/repository/work/kept_answers.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::routes {

/// A request for a job.
struct Submission {
  std::string process;
  std::string inputs_json;
  std::string owner;  // empty: a server without tokens
  // digest of everything that determines the result; empty: the result is not shared
  std::optional<std::string> digest;
  bool force{false};                                // do the work even if its result exists
  std::string reply_json{"{}"};                     // requested outputs and their form
  std::optional<repository::IdempotencyKey> key{};  // the client's own key for the request
};

/// Why no job was created.
enum class SubmissionRefused {
  queue_full,   // try again later
  key_reused,   // the key was used for another request
  job_removed,  // the key's job existed and was removed
};

/// The functions of the job system that the resources need.
/// Threads  may be called from several threads at once, each with its own connection
class JobGateway {
 public:
  virtual ~JobGateway() = default;

  /// Adds a job to the durable queue; it is on disk, with its key, when the call returns. Returns an existing
  /// job for the same key, or for the same digest if its result exists or the owner already waits for it.
  [[nodiscard]] virtual tl::expected<repository::JobRecord, SubmissionRefused> submit(
      sql::Connection& db, const Submission& submission, core::UtcTime now) = 0;
  /// Ends the job; its work stops within a second. False if it is unknown or has ended.
  virtual bool dismiss(sql::Connection& db, const repository::JobId& id, core::UtcTime now) = 0;
  /// Calls `wake` after each change of the job until the returned object is destroyed.
  [[nodiscard]] virtual std::shared_ptr<void> subscribe(const repository::JobId& id,
                                                        std::function<void()> wake) = 0;
  /// Calls `wake` after each change of any job, as `subscribe` does for one job.
  [[nodiscard]] virtual std::shared_ptr<void> subscribe_to_all(std::function<void()> wake) = 0;
};

}  // namespace floeplan::routes
