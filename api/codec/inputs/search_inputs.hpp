#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::codec {

/// How to search: grid, method, objective, refinement.
void read_search(InputReader& reader, planning::PlanRequest& request);
/// Adds the members that `read_search` reads, every default written out.
void write_search(const planning::PlanRequest& request, nlohmann::json& inputs);

}  // namespace floeplan::codec
