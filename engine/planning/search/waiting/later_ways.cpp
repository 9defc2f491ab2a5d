#include "engine/planning/search/waiting/later_ways.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/planning/search/bounds/arrival_ladder.hpp"
#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/waiting/openings.hpp"
#include "engine/planning/search/waiting/voyage.hpp"

namespace floeplan::planning::search {

LaterWay search_later_ways(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                           core::Seconds latest, core::Seconds slack, std::size_t most_labels,
                           const std::stop_token& stop) {
  LaterWay result;
  const auto end = sea.currents() ? sea.currents()->end() : std::nullopt;
  VertexClosures closures{sea, open.grid};
  std::optional<Foresight> foresight;
  std::optional<ArrivalLadder> ladder;
  const core::Seconds last = std::min(latest, end.value_or(latest));
  if (std::isfinite(last.count()) && foresight.emplace(sea, open).is_useful()) {
    ladder.emplace(*foresight, closures, open, depart, last, stop);
    if (!ladder->has_hope()) {
      result.cancelled = stop.stop_requested();
      return result;
    }
  }
  const Openings openings{sea, open, latest, stop, &closures, ladder ? &*ladder : nullptr};
  result.cancelled = stop.stop_requested();
  if (result.cancelled || openings.empty()) return result;

  Voyage voyage{sea, open.grid, openings, latest, ladder ? &*ladder : nullptr};
  const auto search = graph::find_best_labels(open.graph, open.grid.start, open.grid.goal, depart.count(), {},
                                              voyage, most_labels, stop, {}, slack.count());
  result.counters = search.counters;
  result.cancelled = search.stopped;
  result.cut_short = search.full;
  result.none_before = core::Seconds{search.least_key};
  if (!search.goal) return result;
  result.arrival = core::Seconds{search.labels[*search.goal].arrival_s};
  for (const auto& label : graph::way_to(search, *search.goal))
    result.path.push_back(open.grid.point(label.vertex));
  return result;
}

}  // namespace floeplan::planning::search
