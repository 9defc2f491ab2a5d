#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>

#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/layout.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::search {

/// The search area of a request in its plane, with everything that a search needs. It is made once and used
/// for every departure and every attempt. Times count from the departure of the request.
struct Chart {
  cost::Layout layout;
  cost::Sea sea;
};

/// Whether to look for places to which an unusable stop could be moved. This takes time, so callers that plan
/// many variants leave it out.
enum class Moves : std::uint8_t { looked_for, left_out };

/// If the departure is open (a window or a wanted arrival), a start that is closed for a while is not an
/// error here: `closed_start` checks it for each departure.
/// Errors   Reason::too_large for a grid beyond the memory limit (a direct route needs no grid); why a stop
///          cannot be used; Reason::cancelled once `stop` is requested
/// `environment` and `request` are borrowed and must outlive the search area; `shelf`: see `Sea`.
[[nodiscard]] Result<Chart> draw_chart(const ocean::Environment& environment, const PlanRequest& request,
                                       cost::GridReach reach, const std::stop_token& stop,
                                       cost::SeaShelf* shelf = nullptr, Moves moves = Moves::looked_for);

/// Why the vehicle cannot be at its start at the time `after`, counted from the departure of the request;
/// empty if it can.
[[nodiscard]] std::optional<Infeasible> closed_start(const Chart& chart, const PlanRequest& request,
                                                     core::Seconds after);

/// The search area of a request on a leg cost model made for this or a similar request. The safety map is
/// opened around the stops and, for a direct route, along it.
/// `environment`  the one that the model was made from; messages name its data
/// Errors   why a stop cannot be used
[[nodiscard]] Result<Chart> chart_on(cost::Sea sea, const ocean::Environment& environment,
                                     cost::Layout layout, const PlanRequest& request,
                                     const std::stop_token& stop = {}, Moves moves = Moves::left_out);

/// The refusal if the search area would be too large for memory; otherwise empty.
[[nodiscard]] std::optional<Infeasible> too_much_to_lay_out(const ocean::Environment& environment,
                                                            const PlanRequest& request);

}  // namespace floeplan::planning::search
