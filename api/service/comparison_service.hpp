#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "api/codec/documents/flight_comparison.hpp"
#include "engine/core/progress.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::service {

struct ComparedFlights {
  std::vector<codec::ComparedDive> dives;
  core::Violations violations;  // of dives that cannot be flown again, by the file's name
};

/// Flies the dives of logs again in the simulator and sets both side by side; one function for API and command line.
/// Stops    between two dives, with those that are done
[[nodiscard]] ComparedFlights compare_flights(std::span<const codec::GliderLog> logs,
                                              const vehicle::GliderProfile& vehicle, simulation::DragOf drag,
                                              const std::stop_token& stop = {},
                                              const core::ProgressCallback& progress = {});

}  // namespace floeplan::service
