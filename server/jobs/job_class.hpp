#pragma once

#include <string>

#include "engine/core/units.hpp"
#include "storage/repository/work/job_repository.hpp"

namespace floeplan::jobs {

/// The class of a job of this process with these inputs. Flights, a window of departures and an ensemble of currents make
/// a batch: each of their parts may take as long as a plan. Inputs that cannot be read are refused in no time.
[[nodiscard]] repository::JobClass class_of(const std::string& process, const std::string& inputs_json);

/// The longest that a job of each class may run. They keep a worker from being lost, not a pilot from asking for much:
/// the dearest request seen, 10,000 flights of half a minute, takes four days on one core.
struct TimeLimits {
  core::Seconds interactive{3600.0};
  core::Seconds batch{14.0 * 86'400.0};
  core::Seconds ingest{6.0 * 3600.0};

  [[nodiscard]] core::Seconds of(repository::JobClass job_class) const;
};

/// Why a job failed that ran beyond its limit, what that means, and what to do.
[[nodiscard]] std::string overdue_message(repository::JobClass job_class, core::Seconds limit);

}  // namespace floeplan::jobs
