#include "engine/planning/search/voyage_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "engine/messages/refusal_messages.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::search {
namespace {

void add(SearchStatistics& sum, const SearchStatistics& part) {
  sum.vertices += part.vertices;
  sum.edges += part.edges;
  sum.edge_evaluations += part.edge_evaluations;
  sum.expansions += part.expansions;
  sum.reinsertions += part.reinsertions;
  sum.holds_may_help = sum.holds_may_help || part.holds_may_help;
  sum.possible_gain = part.possible_gain;
  sum.none_is_earlier = part.none_is_earlier;
  sum.cut_short = sum.cut_short || part.cut_short;
}

/// The points of a route between two stops; `part` 0 runs from the start to the first stop after it.
std::vector<geo::PlanePoint> part_of(const cost::Route& route, std::size_t part) {
  std::vector<geo::PlanePoint> points;
  std::size_t stops = 0;
  for (std::size_t i = 0; i < route.points.size(); ++i) {
    if (route.fixed[i]) ++stops;
    if (stops == part + 1 || (stops == part + 2 && route.fixed[i])) points.push_back(route.points[i]);
  }
  return points;
}

/// An arrival at the end of a part that is certainly possible: the time of another departure's route, with
/// room for the tolerance of its times. Infinite if that route is closed now.
core::Seconds arrival_by(const cost::Sea& sea, const FoundWay& other, std::size_t part,
                         core::Seconds depart) {
  constexpr double slack = 1e-3;
  const auto arrivals = cost::arrivals_along(sea, part_of(other.route, part), depart);
  if (!arrivals) return core::Seconds{INFINITY};
  return arrivals->back() + slack * (arrivals->back() - depart);
}

/// Travel time from a departure just after a surfacing to the next possible surfacing, to within an edge; to
/// the end of the route if there is none.
core::Seconds until_first_surfacing(const cost::Sea& sea, const std::vector<geo::PlanePoint>& way,
                                    core::Seconds depart) {
  constexpr core::Seconds just_now{0.0};
  constexpr core::Seconds whenever{INFINITY};
  constexpr core::Seconds rounding{1e-3};
  const auto arrivals = cost::arrivals_along(sea, way, depart);
  if (!arrivals) return just_now;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const std::vector<geo::PlanePoint> begun(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(i + 1));
    const core::Seconds under_way = (*arrivals)[i] - depart;
    const auto since = cost::since_surfacing_at_end(sea, begun, depart, just_now, whenever);
    if (since && *since + rounding < under_way) return under_way - *since;
  }
  return arrivals->back() - depart;
}

/// When the search of a part begins, and the time since the last possible surfacing then.
struct Beginning {
  core::Seconds depart{};
  core::Seconds since_surfacing{};
};

/// A part of the route, from one stop to the next.
struct Part {
  Beginning beginning;
  std::vector<geo::PlanePoint> path;
};

/// Searches grid after grid, from stop to stop.
class Parts {
 public:
  /// All references are borrowed.
  Parts(const cost::Sea& sea, const std::vector<OpenGrid>& grids, const PlanRequest& request,
        const std::stop_token& stop, const std::function<void(double)>& report_fraction,
        const OtherDepartures& others)
      : sea_{sea},
        grids_{grids},
        request_{request},
        stop_{stop},
        report_fraction_{report_fraction},
        others_{others} {}

  /// Searches from the first stop to the last. Returns why there is no route; empty if there is one.
  std::optional<Infeasible> search_all(core::Seconds depart) {
    end_ = {depart, core::Seconds{0.0}};
    for (std::size_t i = 0; i < grids_.size(); ++i) {
      RouteSearch search =
          i == 0 && others_.first != nullptr ? *others_.first : search_from(grids_[i], i, end_);
      if (search.path.empty() && !search.cancelled && is_for_want_of_surfacing())
        search = search_with_more_left(std::move(search), i);
      if (search.cancelled) return explain_cancelled(request_);
      if (search.path.empty()) return why_not(search, i);
      if (auto closed = append(std::move(search))) return closed;
    }
    return std::nullopt;
  }

  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  [[nodiscard]] core::Seconds arrival() const { return end_.depart; }
  [[nodiscard]] const SearchStatistics& statistics() const { return statistics_; }

 private:
  RouteSearch search_from(const OpenGrid& open, std::size_t i, const Beginning& beginning) {
    const auto search_by = [&](core::Seconds latest) {
      const auto report = [&](double fraction) {
        report_fraction_((static_cast<double>(i) + fraction) / static_cast<double>(grids_.size()));
      };
      return search_route(sea_, open, request_, beginning.depart, stop_, report, latest,
                          beginning.since_surfacing,
                          others_.foresights != nullptr ? &(*others_.foresights)[i] : nullptr);
    };
    const bool bounded = others_.way != nullptr && !sea_.domain().closures().any_timed();
    const core::Seconds of_use = i + 1 == grids_.size() ? others_.of_use : core::Seconds{INFINITY};
    const core::Seconds latest =
        bounded ? arrival_by(sea_, *others_.way, i, beginning.depart) : core::Seconds{INFINITY};
    RouteSearch search = search_by(std::min(latest, of_use));
    // Without FIFO this search may miss the route that gave the bound; a second one runs without that bound.
    if (search.path.empty() && latest < of_use && !search.cancelled) search = search_by(of_use);
    add(statistics_, search.statistics);
    return search;
  }

  /// Whether too little of the limit on the time without surfacing may be left, because the part before ends
  /// as early as possible.
  [[nodiscard]] bool is_for_want_of_surfacing() const {
    return sea_.domain().overhead().bounds_surfacing() && !parts_.empty() &&
           end_.since_surfacing.count() > 0.0;
  }

  /// Searches onward as if the vehicle had just surfaced at the stop. The time that this route needs until
  /// its next surfacing must be left on arrival at the stop, and more if the ice has changed by then. So the
  /// part before is searched again, and replaced if the route can then continue.
  /// `failed`: returned if it cannot
  RouteSearch search_with_more_left(RouteSearch failed, std::size_t i) {
    const core::Seconds longest = *sea_.domain().overhead().longest_without_surfacing();
    const RouteSearch rested = search_from(grids_[i], i, {end_.depart, core::Seconds{0.0}});
    if (rested.path.empty()) {
      failed.cancelled = rested.cancelled;
      return failed;
    }
    const core::Seconds needed = until_first_surfacing(sea_, rested.path, end_.depart);
    for (const double more : {0.02, 0.5}) {
      OpenGrid before = grids_[i - 1];
      before.left_at_goal = std::max(needed + more * (longest - needed), longest - end_.since_surfacing);
      RouteSearch earlier = search_from(before, i - 1, parts_.back().beginning);
      failed.cancelled = earlier.cancelled;
      if (earlier.path.empty()) break;
      const Part replaced = std::move(parts_.back());
      const Beginning end = end_;
      parts_.pop_back();
      end_ = replaced.beginning;
      if (!append(std::move(earlier))) {
        RouteSearch onward = search_from(grids_[i], i, end_);
        if (!onward.path.empty() || onward.cancelled) return onward;
        parts_.pop_back();
      }
      parts_.push_back(replaced);
      end_ = end;
    }
    return failed;
  }

  /// Adds the found part to the route; returns why it is closed, if it is.
  std::optional<Infeasible> append(RouteSearch search) {
    const auto arrivals = cost::arrivals_along(sea_, search.path, end_.depart, end_.since_surfacing);
    if (!arrivals) return explain_route(arrivals.error(), sea_, request_);
    parts_.push_back({end_, std::move(search.path)});
    end_ = {arrivals->back(), search.since_surfacing};
    return std::nullopt;
  }

  [[nodiscard]] Infeasible why_not(RouteSearch& search, std::size_t i) const {
    search.statistics.cut_short = search.statistics.cut_short || statistics_.cut_short;
    Infeasible why = explain_search(search, i + 1 == grids_.size() ? Stop::goal : Stop::via,
                                    grids_[i].grid.point(grids_[i].grid.goal), sea_, request_);
    if (is_for_want_of_surfacing()) why.besides.push_back(messages::refusal<"searched-from-stop-to-stop">());
    return why;
  }

  const cost::Sea& sea_;
  const std::vector<OpenGrid>& grids_;
  const PlanRequest& request_;
  const std::stop_token& stop_;
  const std::function<void(double)>& report_fraction_;
  const OtherDepartures& others_;
  std::vector<Part> parts_;
  Beginning end_;  // end of the parts found so far
  SearchStatistics statistics_;
};

}  // namespace

bool touches_rim(const std::vector<geo::PlanePoint>& path, const cost::RouteGrid& grid) {
  const double along2 = grid.along.x_m * grid.along.x_m + grid.along.y_m * grid.along.y_m;
  const double across2 = grid.across.x_m * grid.across.x_m + grid.across.y_m * grid.across.y_m;
  return std::ranges::any_of(path, [&](geo::PlanePoint p) {
    const double dx = p.x_m - grid.origin.x_m;
    const double dy = p.y_m - grid.origin.y_m;
    const double column = (dx * grid.along.x_m + dy * grid.along.y_m) / along2;
    const double row = (dx * grid.across.x_m + dy * grid.across.y_m) / across2;
    return column < 0.5 || column > grid.nx - 1.5 || row < 0.5 || row > grid.ny - 1.5;
  });
}

Result<FoundWay> search_voyage(const cost::Sea& sea, const std::vector<OpenGrid>& grids,
                               const PlanRequest& request, core::Seconds depart, const std::stop_token& stop,
                               const std::function<void(double)>& report_fraction,
                               const OtherDepartures& others) {
  Parts voyage{sea, grids, request, stop, report_fraction, others};
  if (auto why_not = voyage.search_all(depart)) return tl::unexpected(std::move(*why_not));
  FoundWay found;
  found.route.points.push_back(grids.front().grid.point(grids.front().grid.start));
  found.route.fixed.push_back(true);
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const std::vector<geo::PlanePoint>& path = voyage.parts()[i].path;
    found.touches_rim = found.touches_rim || touches_rim(path, grids[i].grid);
    for (std::size_t p = 1; p < path.size(); ++p) {
      found.route.points.push_back(path[p]);
      found.route.fixed.push_back(p + 1 == path.size());
    }
  }
  found.arrival = voyage.arrival();
  found.statistics = voyage.statistics();
  // The gain before one stop says nothing about the whole: it may be lost, or doubled, before the next stop.
  if (grids.size() > 1) found.statistics.possible_gain.reset();
  return found;
}

}  // namespace floeplan::planning::search
