#include "engine/planning/search/surfacing/surfacing_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <vector>

#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/surfacing/surfacing_voyage.hpp"

namespace floeplan::planning::search {
namespace {

using graph::Edge;

/// Limit on labels if the vehicle may hold: each takes some hundred microseconds. After this search a second
/// one without holds follows; the low limit lets it begin soon.
constexpr std::size_t most_waiting_labels = 20'000;

/// Resolution of last surfacings while any route is sought, as a share of the limit on the time without
/// surfacing.
constexpr double any_share = 1.0 / 4.0;

/// One pass of the search. Each pass looks for a better route than all passes before.
struct Pass {
  double share_of_bound;  // resolution of last surfacings, as a share of the limit
  double weight;          // of the remaining time, see SurfacingVoyage
};
/// Passes with finer and finer resolution, all quick except the last. With forty leads in 75 km of ice and limits of
/// 12 to 24 h they come within 1 % of the best route. Passes with full accuracy alone run out of memory up to 7 %
/// from it.
constexpr Pass passes[] = {{1.0 / 6.0, 1.2}, {1.0 / 24.0, 1.1}, {1.0 / 100.0, 1.0}};

/// Limit of labels of the search that shows where routes end if no route keeps the limit. Labels nearest to the
/// goal come first.
constexpr std::size_t most_futile_labels = 10'000;

using Labels = graph::LabelSearch<SurfacingVoyage::State>;

/// The arrival nearest to the goal, the earliest of equals; null if there is none.
const SurfacingVoyage::Label* nearest_to_goal(const cost::RouteGrid& grid, const Labels& search) {
  const geo::PlanePoint goal = grid.point(grid.goal);
  const SurfacingVoyage::Label* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& label : search.labels) {
    const geo::PlanePoint point = grid.point(label.vertex);
    const double distance = geo::distance_m(point, goal);
    if (distance >= least) continue;
    least = distance;
    nearest = &label;
  }
  return nearest;
}

void describe_bounded_end(RouteSearch& result, const cost::Sea& sea, const OpenGrid& open,
                          const Labels& search) {
  const auto* nearest = nearest_to_goal(open.grid, search);
  result.nearest = open.grid.point(nearest != nullptr ? nearest->vertex : open.grid.start);
  if (nearest == nullptr) return;
  result.nearest_arrival = core::Seconds{nearest->arrival_s};
  open.graph.for_each_edge(nearest->vertex, [&](const Edge& edge) {
    const geo::PlanePoint head = open.grid.point(edge.head);
    const auto leg = sea.leg(result.nearest, head, result.nearest_arrival,
                             core::Seconds{nearest->arrival_s - nearest->state.surfaced_s});
    if (leg) return;
    result.closed_at_nearest.push_back(leg.error());
    result.out_of_time =
        result.out_of_time || (leg.error() == motion::EdgeClosed::outside_data &&
                               sea.domain().currents_known_to_end(head, result.nearest_arrival));
  });
}

/// Searches one grid for one departure, in passes with finer and finer resolution of last surfacings.
class Searches {
 public:
  Searches(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart, core::Seconds since_surfacing,
           const std::stop_token& stop, const std::function<void(double)>& report_fraction)
      : sea_{sea},
        depart_{depart},
        since_surfacing_{since_surfacing},
        stop_{stop},
        report_fraction_{report_fraction},
        reach_{sea, open, depart, since_surfacing, stop},
        foresight_{sea, reach_.grid()},
        has_hope_{reach_.has_hope()} {
    const auto end = sea.domain().currents() ? sea.domain().currents()->end() : std::nullopt;
    if (end && has_hope_) look_ahead(*end);
  }

  /// Whether any route may keep the limit and reach the goal in time.
  [[nodiscard]] bool has_hope() const { return has_hope_; }

  /// Computes bounds for routes that reach the goal by `last`. Clears `has_hope_` if there can be no such
  /// route.
  void look_ahead(core::Seconds last) {
    if (!foresight_.is_useful()) return;
    ladder_ = std::make_unique<ArrivalLadder>(foresight_, reach_.grid(), depart_, last, stop_);
    if (ladder_->has_hope()) return;
    ladder_.reset();
    has_hope_ = false;
  }

  /// A route that is found soon but need not be fast. Reopenings near a place are ignored.
  [[nodiscard]] Labels find_any(std::size_t most_labels) {
    return find({.pass = {any_share, 1.0}, .aim = SurfacingVoyage::Aim::any_way}, Openings{}, most_labels);
  }
  /// A route close to the best that reaches the goal before `before`.
  [[nodiscard]] Labels find_best(Pass pass, core::Seconds before, std::size_t most_labels) {
    const Openings openings =
        sea_.domain().closures().any_timed()
            ? Openings{sea_, reach_.grid(), before, stop_, &foresight_.closures(), ladder_.get()}
            : Openings{};
    return find({.pass = pass, .slack = sea_.edge_tolerance(), .before = before}, openings, most_labels);
  }

 private:
  struct Wanted {
    Pass pass;
    double slack{0.0};  // tolerance: a later arrival by this share of the least travel time counts as equal
    core::Seconds before{INFINITY};
    SurfacingVoyage::Aim aim{SurfacingVoyage::Aim::best_way};
  };
  [[nodiscard]] Labels find(const Wanted& wanted, const Openings& openings, std::size_t most_labels) {
    const core::Seconds resolution =
        wanted.pass.share_of_bound * *sea_.domain().overhead().longest_without_surfacing();
    const OpenGrid& open = reach_.grid();
    SurfacingVoyage voyage{sea_,
                           open,
                           {foresight_.closures(), openings, reach_, ladder_.get()},
                           resolution,
                           wanted.before,
                           wanted.aim,
                           wanted.pass.weight};
    const std::size_t affordable =
        voyage.may_wait() ? std::min(most_labels, most_waiting_labels) : most_labels;
    const auto report = [&, before = searches_++](std::int64_t expansions) {
      const double share = static_cast<double>(expansions) / static_cast<double>(affordable);
      report_fraction_((before + std::min(1.0, share)) / most_searches);
    };
    const cost::RouteGrid& grid = open.grid;
    const double least_s = sea_.least_time(grid.point(grid.start), grid.point(grid.goal)).count();
    const SurfacingVoyage::State start{.surfaced_s = (depart_ - since_surfacing_).count()};
    return graph::find_best_labels(open.graph, grid.start, grid.goal, depart_.count(), start, voyage,
                                   affordable, stop_, report, wanted.slack * least_s);
  }

  const cost::Sea& sea_;
  core::Seconds depart_;
  core::Seconds since_surfacing_;
  const std::stop_token& stop_;
  const std::function<void(double)>& report_fraction_;
  static constexpr double most_searches = 1.0 + std::size(passes);  // search for any route, then the passes
  int searches_{0};                                                 // number of searches begun
  SurfacingReach reach_;
  Foresight foresight_;
  bool has_hope_;
  std::unique_ptr<ArrivalLadder> ladder_;  // null: only the bound of a straight line is known
};

void add(SearchStatistics& statistics, const graph::LabelCounters& counters) {
  statistics.expansions += counters.expansions;
  statistics.edge_evaluations += counters.edge_evaluations;
}

}  // namespace

RouteSearch search_with_surfacings(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                                   core::Seconds since_surfacing, const std::stop_token& stop,
                                   const std::function<void(double)>& report_fraction,
                                   SurfacingBudget budget) {
  RouteSearch result;
  result.statistics.vertices = open.vertices;
  result.statistics.edges = open.edges;
  Searches search{sea, open, depart, since_surfacing, stop, report_fraction};
  const auto adopt = [&](const Labels& found) {
    add(result.statistics, found.counters);
    result.cancelled = found.stopped;
    if (!found.goal) return;
    result.path.clear();
    for (const auto& label : graph::way_to(found, *found.goal))
      result.path.push_back(open.grid.point(label.vertex));
    result.arrival = core::Seconds{found.labels[*found.goal].arrival_s};
    result.since_surfacing = result.arrival - core::Seconds{found.labels[*found.goal].state.surfaced_s};
  };

  if (!search.has_hope()) {
    const Labels futile = search.find_any(std::min(budget.any_way, most_futile_labels));
    adopt(futile);
    if (!result.cancelled) describe_bounded_end(result, sea, open, futile);
    return result;
  }
  adopt(search.find_any(budget.any_way));
  if (result.cancelled) return result;
  core::Seconds before{INFINITY};
  for (const Pass pass : passes) {
    if (!result.path.empty()) {
      before = result.arrival;
      search.look_ahead(before);
      if (!search.has_hope()) break;
    }
    const Labels found = search.find_best(pass, before, budget.best_way);
    adopt(found);
    result.statistics.cut_short = found.full;
    if (result.path.empty() && !result.cancelled) describe_bounded_end(result, sea, open, found);
    // A finer search keeps more labels for each place, so it would stop even farther from the goal.
    if (result.cancelled || found.full) break;
  }
  return result;
}

}  // namespace floeplan::planning::search
