#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::codec {

/// Which stored data to use: "newest", "none", an id, or (of all but ice, wind and coastline) an array of ids. Area,
/// departure and dive depth of the query are not read here.
void read_data(InputReader& reader, repository::EnvironmentQuery& data);
/// Adds the members that `read_data` reads, every default written out.
void write_data(const repository::EnvironmentQuery& data, nlohmann::json& inputs);

}  // namespace floeplan::codec
