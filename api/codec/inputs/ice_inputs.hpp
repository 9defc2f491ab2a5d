#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "engine/planning/problem/iceberg_rules.hpp"
#include "engine/planning/problem/under_ice_rules.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::codec {

/// How icebergs are kept clear of, and which sightings count.
void read_iceberg_rules(InputReader& reader, planning::IcebergRules& rules,
                        repository::EnvironmentQuery& data);
/// Adds the members that `read_iceberg_rules` reads, every default written out.
void write_iceberg_rules(const planning::IcebergRules& rules, const repository::EnvironmentQuery& data,
                         nlohmann::json& inputs);

/// The member `under_ice`: how the vehicle may work where there is sea ice.
void read_under_ice(InputReader& reader, planning::UnderIceRules& rules);
/// Adds the member that `read_under_ice` reads, every default written out.
void write_under_ice(const planning::UnderIceRules& rules, nlohmann::json& inputs);

/// The same member where surfacings are not planned: what the ice lets pass, and for how long.
void read_passing_under_ice(InputReader& reader, planning::UnderIceRules& rules);
/// Adds the member that `read_passing_under_ice` reads, every default written out.
void write_passing_under_ice(const planning::UnderIceRules& rules, nlohmann::json& inputs);

}  // namespace floeplan::codec
