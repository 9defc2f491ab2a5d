#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/graph/search_tree.hpp"
#include "engine/messages/message.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// Looks for legs whose later opening breaks FIFO where it could matter: beyond which the goal might still be
/// reached earlier than it was. Open legs need no look: on one leg the later vehicle never overtakes.
/// Cost     bounded: the 128 refused legs that promise most, each tried at no more than 48 later departures
/// Returns  each one found among these; none where the currents are steady. `epoch`: of the sea's clock
[[nodiscard]] std::vector<LateOpening> find_late_openings(const cost::Sea& sea, core::UtcTime epoch,
                                                          const OpenGrid& open, const graph::SearchTree& tree,
                                                          const RefusedEdges& refused,
                                                          const StraightBound& bound,
                                                          const std::stop_token& stop);

/// The one with the larger gain; an end that was not reached at all stands above every other.
[[nodiscard]] std::optional<LateOpening> worse_of(const std::optional<LateOpening>& a,
                                                  const std::optional<LateOpening>& b);

/// What it means, for a pilot: "the current is too strong at ... until ...".
[[nodiscard]] messages::Message message_of(const LateOpening& opening);

}  // namespace floeplan::planning::search
