#pragma once

#include <string>

#include "engine/core/units.hpp"
#include "storage/repository/work/job_repository.hpp"

namespace floeplan::jobs {

/// The class of a job. Flights, a window of departures and an ensemble of currents are a batch, because each
/// of their parts may take as long as a plan. If the inputs cannot be read, the class does not matter,
/// because the job fails at once.
[[nodiscard]] repository::JobClass class_of(const std::string& process, const std::string& inputs_json);

/// Longest duration of a job, by class. The limits only prevent the loss of a worker; they do not restrict
/// what pilots request. The longest request seen, 10,000 flights of half a minute, takes four days on one
/// core.
struct TimeLimits {
  core::Seconds interactive{3600.0};
  core::Seconds batch{14.0 * 86'400.0};
  core::Seconds ingest{6.0 * 3600.0};

  [[nodiscard]] core::Seconds of(repository::JobClass job_class) const;
};

/// The message of a job that exceeded its limit: what it means, and what to do.
[[nodiscard]] std::string overdue_message(repository::JobClass job_class, core::Seconds limit);

}  // namespace floeplan::jobs
