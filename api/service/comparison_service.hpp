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
  core::Violations violations;  // faults of dives that cannot be simulated, by the name of their file
};

/// Simulates the dives of logs and compares the simulation with each log. Common to API and command line.
/// Stops    between two dives, and returns the finished ones
[[nodiscard]] ComparedFlights compare_flights(std::span<const codec::GliderLog> logs,
                                              const vehicle::GliderProfile& vehicle, simulation::DragOf drag,
                                              const std::stop_token& stop = {},
                                              const core::ProgressCallback& progress = {});

}  // namespace floeplan::service
