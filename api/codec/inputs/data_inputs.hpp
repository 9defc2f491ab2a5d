#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::codec {

/// Reads which stored data to use: "newest", "none", an id, or (except for ice, wind and coastline) an array
/// of ids. Area, departure and dive depth of the query are set elsewhere.
void read_data(InputReader& reader, repository::EnvironmentQuery& data);
/// Adds the members that `read_data` reads, with all defaults filled in.
void write_data(const repository::EnvironmentQuery& data, nlohmann::json& inputs);

}  // namespace floeplan::codec
