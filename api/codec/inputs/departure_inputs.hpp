#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::codec {

/// Earliest departure when a request asks for an arrival and names none: the longest mission of a glider that was
/// asked for in practice (Eichhorn 2010, doi:10.1109/OCEANS.2010.5664082).
inline constexpr core::Seconds longest_mission{30.0 * 86400.0};

/// "depart", which is required.
void read_departure(InputReader& reader, planning::PlanRequest& request);

/// "depart" with "depart_until" and "depart_step" for a window, or "arrive_by", with which "depart" is the earliest
/// departure and may be left out.
void read_departures(InputReader& reader, planning::PlanRequest& request);
void write_departures(const planning::PlanRequest& request, nlohmann::json& inputs);

/// The period that the data of the request have to cover.
void fill_period(const planning::PlanRequest& request, repository::EnvironmentQuery& data);

}  // namespace floeplan::codec
