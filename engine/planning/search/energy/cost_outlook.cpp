#include "engine/planning/search/energy/cost_outlook.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace floeplan::planning::search {
namespace {

using graph::Edge;
using graph::Vertex;

constexpr float unknown = std::numeric_limits<float>::infinity();
/// A twentieth of a semidiurnal tide: linear interpolation between slices then errs by little more than a
/// hundredth at the peaks.
constexpr core::Seconds least_step{2240.0};
constexpr std::size_t most_outlook_values = 8'000'000;  // 32 MB for each grid
constexpr std::size_t outlook_check_interval = 64;
/// The last slice keeps its currents for this many crossings of the grid: enough for routes that turn back.
constexpr int passes_of_last = 6;

/// Cost per second on an edge, for each kind of propulsion, from the vertices along the edge.
class Rates {
 public:
  Rates(const cost::Sea& sea, const OpenGrid& open, const Objective& objective)
      : sea_{sea}, grid_{open.grid}, objective_{objective}, of_(open.graph.size() * sea.drives().size()) {
    for (const graph::Offset offset : open.graph.offsets())
      halves_.push_back(offset.dx / 2 + offset.dy / 2 * open.grid.nx);
  }

  void look(Vertex v, core::Seconds time) {
    constexpr core::Seconds second{1.0};
    const geo::PlanePoint point = grid_.point(v);
    const core::Metres upper_turn = sea_.domain().overhead().least_upper_turn(point, time);
    for (std::size_t d = 0; d < sea_.drives().size(); ++d) {
      const core::Joules drawn =
          sea_.energy().use(point, point, second, sea_.drives()[d], upper_turn).total();
      of_[v * sea_.drives().size() + d] = static_cast<float>(objective_.cost(second, drawn));
    }
  }
  /// Mean of the rates at both ends of the edge and at two vertices near its middle.
  [[nodiscard]] float along(const Edge& edge, std::size_t drive) const {
    const auto half = static_cast<Vertex>(halves_[edge.step]);  // modulo 2^32, as vertex numbers wrap
    return 0.25F * (at(edge.tail, drive) + at(edge.tail + half, drive) + at(edge.head - half, drive) +
                    at(edge.head, drive));
  }

 private:
  [[nodiscard]] float at(Vertex v, std::size_t drive) const { return of_[v * sea_.drives().size() + drive]; }

  const cost::Sea& sea_;
  const cost::RouteGrid& grid_;
  Objective objective_;
  std::vector<int> halves_;  // by step: half an edge as a difference of vertex numbers, rounded down
  std::vector<float> of_;    // [vertex][propulsion]
};

/// Edges that are closed at all times.
class ClosedEdges {
 public:
  /// Incomplete once `stop` is requested; must then not be used.
  ClosedEdges(const cost::Sea& sea, const OpenGrid& open, const std::vector<Vertex>& tails,
              const std::stop_token& stop)
      : steps_{open.graph.offsets().size()}, closed_(open.graph.size() * steps_) {
    const core::Metres reach = reach_of(open.grid, open.graph);
    for (std::size_t i = 0; i < tails.size(); ++i) {
      if (i % outlook_check_interval == 0 && stop.stop_requested()) return;
      const Vertex v = tails[i];
      const geo::PlanePoint tail = open.grid.point(v);
      if (sea.domain().closures().open_about(tail, reach)) continue;
      open.graph.for_each_edge(v, [&](const Edge& edge) {
        closed_[v * steps_ + edge.step] =
            sea.domain().closures().closed_between(tail, open.grid.point(edge.head)).has_value();
      });
    }
  }
  [[nodiscard]] bool has(const Edge& edge) const { return closed_[edge.tail * steps_ + edge.step]; }

 private:
  std::size_t steps_;
  std::vector<bool> closed_;  // [vertex][step]
};

bool is_closed_at(VertexClosures& closures, Vertex v, core::Seconds time) {
  return std::ranges::any_of(closures.at(v),
                             [&](const TimeSpan& span) { return span.from < time && time < span.until; });
}

}  // namespace

CostOutlook::Moment CostOutlook::Slices::at(double t_s) const {
  const double position = std::clamp((t_s - first_s) / step_s, 0.0, static_cast<double>(count - 1));
  const auto before = std::min(static_cast<std::size_t>(position), count - 2);
  return {before, static_cast<float>(position - static_cast<double>(before))};
}

CostOutlook::Slices CostOutlook::lay_slices(core::Seconds depart, core::Seconds last, std::size_t vertices) {
  const double wanted = std::ceil((last - depart) / least_step);
  const std::size_t most = most_outlook_values / vertices;
  const double steps = std::clamp(wanted, 1.0, std::max(1.0, static_cast<double>(most) - 1.0));
  return {depart.count(), std::max(1.0, (last - depart).count() / steps),
          static_cast<std::size_t>(steps) + 1};
}

float CostOutlook::between(Moment moment, Vertex v) const {
  const float first = rest_[moment.before * vertices_ + v];
  const float second = rest_[(moment.before + 1) * vertices_ + v];
  if (first == unknown || moment.share == 1.0F) return second;
  return second == unknown ? first : first + moment.share * (second - first);
}

CostOutlook::CostOutlook(const cost::Sea& sea, const OpenGrid& open, const Objective& objective,
                         Foresight& foresight, const ArrivalLadder& use, core::Seconds depart,
                         core::Seconds last, const std::stop_token& stop)
    : vertices_{open.graph.size()},
      slices_{lay_slices(depart, last, vertices_)},
      rest_(slices_.count * vertices_, unknown) {
  const cost::RouteGrid& grid = open.grid;
  std::vector<Vertex> order;  // the useful vertices, those nearest to the goal first
  std::vector<double> earliest_s(vertices_);
  for (Vertex v = 0; v < vertices_; ++v) {
    if (v % outlook_check_interval == 0 && stop.stop_requested()) return;
    if (!open.graph.is_open(v) || use.latest_use_s(v) == -std::numeric_limits<double>::infinity()) continue;
    order.push_back(v);
    earliest_s[v] = (depart + sea.least_time(grid.point(grid.start), grid.point(v))).count();
  }
  std::ranges::sort(order, {}, [&](Vertex v) {
    return std::pair{geo::distance_m(grid.point(v), grid.point(grid.goal)), v};
  });
  const ClosedEdges closed{sea, open, order, stop};
  Rates rates{sea, open, objective};
  for (Vertex v = 0; v < vertices_; ++v) {
    if (v % outlook_check_interval == 0 && stop.stop_requested()) return;
    rates.look(v, last);
  }

  for (std::size_t k = slices_.count; k-- > 0;) {
    const bool is_last = k + 1 == slices_.count;
    const core::Seconds now = slices_.time(k);
    float* const here = &rest_[k * vertices_];
    if (!is_last) std::copy_n(here + vertices_, vertices_, here);
    here[grid.goal] = 0.0F;
    const auto is_closed = [&](Vertex v) { return is_closed_at(foresight.closures(), v, now); };
    for (const Vertex v : order) {
      if (is_closed(v)) here[v] = unknown;
    }
    const auto rest_at_head = [&](const Edge& edge, float time_s) {
      return is_last ? here[edge.head]
                     : between(slices_.at(now.count() + static_cast<double>(time_s)), edge.head);
    };
    const auto least_from = [&](Vertex v) {
      float least = unknown;
      for (std::size_t d = 0; d < sea.drives().size(); ++d) {
        const motion::FanTimes* times = foresight.estimates(v, now, sea.drives()[d]);
        if (times == nullptr) continue;
        open.graph.for_each_edge(v, [&](const Edge& edge) {
          if (closed.has(edge)) return;
          const float time_s = times->time_s[edge.step];
          least = std::min(least, rates.along(edge, d) * time_s + rest_at_head(edge, time_s));
        });
      }
      return least;
    };

    if (!is_last && (sea.domain().ice() || sea.domain().icebergs().may_pass_under())) {
      for (const Vertex v : order) rates.look(v, now);
    }
    for (int pass = 0; pass < (is_last ? passes_of_last : 1); ++pass) {
      for (std::size_t i = 0; i < order.size(); ++i) {
        if (i % outlook_check_interval == 0 && stop.stop_requested()) return;
        const Vertex v = order[i];
        const bool is_of_use = earliest_s[v] - slices_.step_s <= now.count() &&
                               now.count() <= use.latest_use_s(v) + slices_.step_s;
        if (v == grid.goal || !(is_of_use || is_last) || is_closed(v)) continue;
        const float least = least_from(v);
        if (least < unknown) here[v] = least;
      }
    }
    std::ranges::sort(order, {}, [&](Vertex v) { return std::pair{here[v], v}; });
  }
}

}  // namespace floeplan::planning::search
