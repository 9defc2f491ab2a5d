#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace floeplan::codec {

/// Simulated flights as one NetCDF file: true and estimated track, attitude, velocity, energy, and the mode
/// that steered.
/// Format   CF-1.8, featureType trajectory, contiguous ragged arrays (CF-1.8, H.4.3); one trajectory for each
///          flight
/// `flights`    documents from codec::flight_document; at least one
/// `simulation` the document of the simulation to which they belong
[[nodiscard]] std::string simulation_netcdf(const nlohmann::json& simulation,
                                            const std::vector<nlohmann::json>& flights);

/// The simulation as GeoJSON. Each flight has two lines, its true and its estimated track, and points for its
/// events and its closest approaches. Lines are cut at the antimeridian.
[[nodiscard]] nlohmann::json simulation_geojson(const nlohmann::json& simulation,
                                                const std::vector<nlohmann::json>& flights);

}  // namespace floeplan::codec
