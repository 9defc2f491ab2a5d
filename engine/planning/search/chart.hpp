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

/// A request laid out in its plane: everything a search needs, made once and used for every departure and every
/// try. Times are counted from the request's departure.
struct Chart {
  cost::Layout layout;
  cost::Sea sea;
};

/// Whether places are looked for to which a stop that cannot be used may be moved: whoever asks again and again does
/// without.
enum class Moves : std::uint8_t { looked_for, left_out };

/// Where the departure is left open, by a window or a wanted arrival, a start that is closed for a while is no error:
/// see `closed_start`.
/// Errors   Reason::too_large for a grid beyond bounded memory (a direct way needs none); why a stop cannot be
///          used; Reason::cancelled once `stop` is requested
/// `environment` and `request` are borrowed and outlive the chart; `shelf` as in `Sea`.
[[nodiscard]] Result<Chart> draw_chart(const ocean::Environment& environment, const PlanRequest& request,
                                       cost::GridReach reach, const std::stop_token& stop,
                                       cost::CurrentsShelf* shelf = nullptr, Moves moves = Moves::looked_for);

/// Why the vehicle cannot be at its start so long after the request's departure, because something keeps it
/// from there at that time; empty: it can.
[[nodiscard]] std::optional<Infeasible> closed_start(const Chart& chart, const PlanRequest& request,
                                                     core::Seconds after);

/// The chart of a request on a sea that was laid out for it or for one like it: opened where the request's stops lie
/// and, for a direct way, along it.
/// Errors   why a stop cannot be used
[[nodiscard]] Result<Chart> chart_on(cost::Sea sea, cost::Layout layout, const PlanRequest& request,
                                     const std::stop_token& stop = {}, Moves moves = Moves::left_out);

/// Why nothing can be laid out; empty: it can.
[[nodiscard]] std::optional<Infeasible> too_much_to_lay_out(const ocean::Environment& environment,
                                                            const PlanRequest& request);

}  // namespace floeplan::planning::search
