#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "storage/repository/work/simulation_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::routes {

/// A file format for the flights of a simulation. API and command line share the table of formats.
struct SimulationFormat {
  std::string name;  // ends the file's name and the address: "nc", "geojson"
  std::string content_type;
};

[[nodiscard]] std::span<const SimulationFormat> simulation_formats();

/// One kept flight, or all of them. Empty when that run is not kept, or none is.
[[nodiscard]] std::optional<std::string> export_simulation(sql::Connection& db,
                                                           const repository::SimulationRecord& record,
                                                           const SimulationFormat& format,
                                                           std::optional<std::int64_t> run);

}  // namespace floeplan::routes
