#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/input_reader.hpp"
#include "engine/planning/problem/iceberg_rules.hpp"
#include "storage/repository/environment_loader.hpp"

namespace floeplan::codec {

/// How icebergs are kept clear of, and which sightings count.
void read_iceberg_rules(InputReader& reader, planning::IcebergRules& rules,
                        repository::EnvironmentQuery& data);
/// Adds the members that `read_iceberg_rules` reads, every default written out.
void write_iceberg_rules(const planning::IcebergRules& rules, const repository::EnvironmentQuery& data,
                         nlohmann::json& inputs);

}  // namespace floeplan::codec
