#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/geo/local_projection.hpp"
#include "engine/simulation/flight/batch_statistics.hpp"
#include "engine/simulation/flight/flight_record.hpp"

namespace floeplan::codec {

/// A simulated flight for storage and display: positions in degrees; track and sensor logs as columns; times
/// in seconds since the departure. Numbers are rounded to their useful precision (1e-7 degrees, centimetres,
/// 0.01 degrees of attitude), so that the text is the same on every processor.
/// `projection`  the projection of the frame in which the flight was simulated
[[nodiscard]] nlohmann::json flight_document(const simulation::FlightRecord& record,
                                             const geo::LocalProjection& projection, std::size_t run);

/// The summary of one run of a batch.
[[nodiscard]] nlohmann::json summary_document(const simulation::RunSummary& summary, std::size_t run);

[[nodiscard]] nlohmann::json statistics_document(const simulation::BatchStatistics& statistics);

}  // namespace floeplan::codec
