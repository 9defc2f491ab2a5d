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

/// Work that somebody asks for.
struct Submission {
  std::string process;
  std::string inputs_json;
  std::string owner;                  // empty: nobody in particular
  std::optional<std::string> digest;  // of all that the result follows from; empty: never shared
  bool force{false};                  // do it again even if the result is there
  std::string reply_json{"{}"};       // which outputs, in which form
  std::optional<repository::IdempotencyKey> key{};  // the client's own name of the request
};

/// Why there is no job.
enum class SubmissionRefused {
  queue_full,   // come again
  key_reused,   // another request had the key
  job_removed,  // the key's job was there, and is gone
};

/// What the resources need of the job system.
/// Threads  may be called from several threads at once, each with its own connection
class JobGateway {
 public:
  virtual ~JobGateway() = default;

  /// Puts a job into the durable queue; it is on disk, with its key, when the call returns. The same key again gives
  /// the same job; so does a submission with the digest of a job whose result is there, or that the owner waits for.
  [[nodiscard]] virtual tl::expected<repository::JobRecord, SubmissionRefused> submit(
      sql::Connection& db, const Submission& submission, core::UtcTime now) = 0;
  /// Ends the job, stopping its work within a second. False when it is unknown or already ended.
  virtual bool dismiss(sql::Connection& db, const repository::JobId& id, core::UtcTime now) = 0;
  /// Calls `wake` after every change of the job until the returned object is gone.
  [[nodiscard]] virtual std::shared_ptr<void> subscribe(const repository::JobId& id,
                                                        std::function<void()> wake) = 0;
  /// The same for every job.
  [[nodiscard]] virtual std::shared_ptr<void> subscribe_to_all(std::function<void()> wake) = 0;
};

}  // namespace floeplan::routes
