#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "engine/planning/problem/iceberg_rules.hpp"
#include "engine/planning/problem/under_ice_rules.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::codec {

/// Reads the keep-out distances of icebergs, and which sightings count.
void read_iceberg_rules(InputReader& reader, planning::IcebergRules& rules,
                        repository::EnvironmentQuery& data);
/// Adds the members that `read_iceberg_rules` reads, with all defaults filled in.
void write_iceberg_rules(const planning::IcebergRules& rules, const repository::EnvironmentQuery& data,
                         nlohmann::json& inputs);

/// Reads the member `under_ice`: the rules for operating under sea ice.
void read_under_ice(InputReader& reader, planning::UnderIceRules& rules);
/// Adds the member that `read_under_ice` reads, with all defaults filled in.
void write_under_ice(const planning::UnderIceRules& rules, nlohmann::json& inputs);

/// Reads the same member for processes that plan no surfacings: only whether and for how long the vehicle may
/// pass under ice.
void read_passing_under_ice(InputReader& reader, planning::UnderIceRules& rules);
/// Adds the member that `read_passing_under_ice` reads, with all defaults filled in.
void write_passing_under_ice(const planning::UnderIceRules& rules, nlohmann::json& inputs);

}  // namespace floeplan::codec
