#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "storage/repository/work/simulation_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::routes {

/// A file format for the flights of a simulation. The table is common to API and command line.
struct SimulationFormat {
  std::string name;  // "nc", "geojson": end of the file's name and of the URL
  std::string content_type;
};

[[nodiscard]] std::span<const SimulationFormat> simulation_formats();

/// Writes one stored flight, or all of them. nullopt if that run is not stored, or none is.
[[nodiscard]] std::optional<std::string> export_simulation(sql::Connection& db,
                                                           const repository::SimulationRecord& record,
                                                           const SimulationFormat& format,
                                                           std::optional<std::int64_t> run);

}  // namespace floeplan::routes
