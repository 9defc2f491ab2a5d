#include "engine/planning/search/bounds/arrival_ladder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floeplan::planning::search {
namespace {

constexpr std::size_t most_ladder_values = 4'000'000;  // 32 MB: one double for each vertex and rung

}  // namespace

ArrivalLadder::ArrivalLadder(Foresight& foresight, const OpenGrid& open, core::Seconds depart,
                             core::Seconds last, const std::stop_token& stop, std::size_t rungs)
    : foresight_{foresight}, base_s_{depart.count()} {
  const graph::SearchTree earliest = foresight_.sweep_forth(depart, last, stop);
  has_hope_ = earliest.is_reached(open.grid.goal);
  if (!has_hope_) return;
  base_s_ = std::min(earliest.arrival_s(open.grid.goal) - rounding_of_times_s, last.count());

  // The square puts the rungs closer together at early arrivals, where the best routes lie.
  const std::size_t count = std::clamp<std::size_t>(most_ladder_values / open.graph.size(), 1, rungs);
  for (std::size_t rung = 1; rung <= count; ++rung) {
    const double share = static_cast<double>(rung) / static_cast<double>(count);
    rungs_s_.push_back(base_s_ + share * share * (last.count() - base_s_));
  }
  rungs_s_.back() = last.count();
  until_s_.resize(open.graph.size() * count);
  for (std::size_t rung = 0; rung < count && !stop.stop_requested(); ++rung) {
    const graph::SearchTree tree =
        foresight_.sweep_back(depart, core::Seconds{rungs_s_[rung]}, stop, earliest);
    for (graph::Vertex v = 0; v < open.graph.size(); ++v) {
      until_s_[v * count + rung] = rounding_of_times_s - tree.arrival_s(v);
    }
  }
}

double ArrivalLadder::earliest_s(graph::Vertex v, double t_s) const {
  const auto first = until_s_.begin() + static_cast<std::ptrdiff_t>(v * rungs_s_.size());
  const auto last = first + static_cast<std::ptrdiff_t>(rungs_s_.size());
  const auto rung = std::partition_point(first, last, [&](double until_s) { return until_s < t_s; });
  if (rung == last) return std::numeric_limits<double>::infinity();
  return rung == first ? base_s_ : rungs_s_[static_cast<std::size_t>(rung - first) - 1];
}

}  // namespace floeplan::planning::search
