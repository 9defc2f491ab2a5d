#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/geo/local_projection.hpp"
#include "engine/simulation/flight/batch_statistics.hpp"
#include "engine/simulation/flight/flight_record.hpp"

namespace floeplan::codec {

/// A simulated flight as it is stored and shown: places in degrees, track and sensors' log column by column, times as
/// seconds since the departure. Numbers are rounded to what they can mean (1e-7 degrees, centimetres, 0.01 degrees of
/// attitude), so that the text is the same on every processor.
/// `projection` is that of the frame that the flight was simulated in.
[[nodiscard]] nlohmann::json flight_document(const simulation::FlightRecord& record,
                                             const geo::LocalProjection& projection, std::size_t run);

/// One row of a batch.
[[nodiscard]] nlohmann::json summary_document(const simulation::RunSummary& summary, std::size_t run);

[[nodiscard]] nlohmann::json statistics_document(const simulation::BatchStatistics& statistics);

}  // namespace floeplan::codec
