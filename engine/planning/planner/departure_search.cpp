#include "engine/planning/planner/departure_search.hpp"

#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "engine/core/packed_parts.hpp"
#include "engine/planning/cost/driven_route.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/planner/cost_plan.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "engine/planning/search/chart.hpp"
#include "engine/planning/search/energy/cost_search.hpp"
#include "engine/planning/search/explanation.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/voyage_grids.hpp"
#include "engine/planning/search/voyage_search.hpp"

namespace floeplan::planning::planner {
namespace {

/// A search area of one size, gridded for all departures.
struct Ground {
  PlanRequest request;
  search::Chart chart;
  std::vector<search::OpenGrid> grids;           // empty for a straight route
  std::vector<search::FavourableBounds> bounds;  // on the grids, if the objective is time
  std::vector<Ground> fastest;                   // for each propulsion alone, if the objective is not time
};

/// Errors   as draw_chart
Result<Ground> lay_out(const ocean::Environment& environment, const PlanRequest& request,
                       cost::GridReach reach, cost::SeaShelf& shelf, const std::stop_token& stop) {
  // A search for the least cost plans no holds; only a search for the fastest route does.
  PlanRequest drawn = request;
  if (!request.energy.objective.is_time()) drawn.holds.longest = core::Seconds{0.0};
  auto chart = search::draw_chart(environment, drawn, reach, stop, &shelf);
  if (!chart) return tl::unexpected(chart.error());
  Ground ground{request, std::move(*chart), {}, {}, {}};
  if (request.method != Method::direct)
    ground.grids = search::open_grids(ground.chart.sea, ground.chart.layout.grids, request.sectors, stop);
  if (request.energy.objective.is_time()) {
    for (const search::OpenGrid& open : ground.grids)
      ground.bounds.emplace_back(ground.chart.sea, open, stop);
    return ground;
  }
  for (const vehicle::Drive drive : drives(request.energy, request.vehicle)) {
    auto other = lay_out(environment, fastest_request(request, drive), reach, shelf, stop);
    if (!other) return other;
    ground.fastest.push_back(std::move(*other));
  }
  return ground;
}

/// The search areas of a request. Each is gridded when it is first needed.
/// Threads  members may be called from several threads at once
class Grounds {
 public:
  /// All references are borrowed and must outlive this.
  Grounds(const ocean::Environment& environment, const PlanRequest& request, const std::stop_token& stop)
      : environment_{environment}, request_{request}, stop_{stop} {}

  [[nodiscard]] const Result<Ground>& near() { return laid_out(near_, cost::reaches(request_).front()); }
  [[nodiscard]] const Result<Ground>& wide() { return laid_out(wide_, cost::reaches(request_).back()); }

 private:
  const Result<Ground>& laid_out(std::optional<Result<Ground>>& ground, cost::GridReach reach) {
    const std::lock_guard lock{mutex_};
    if (!ground) ground.emplace(lay_out(environment_, request_, reach, shelf_, stop_));
    return *ground;
  }

  const ocean::Environment& environment_;
  const PlanRequest& request_;
  const std::stop_token& stop_;
  std::mutex mutex_;
  cost::SeaShelf shelf_;
  std::optional<Result<Ground>> near_;
  std::optional<Result<Ground>> wide_;
};

/// Searches the grids of one search area for one departure after another.
class DepartureSweep {
 public:
  /// `ground` is borrowed and must outlive this.
  explicit DepartureSweep(const Ground& ground) : ground_{ground} {
    const PlanRequest& request = ground.request;
    const core::Seconds window = request.departures.departures(request.depart).back() - request.depart;
    for (std::size_t i = 0; i < ground.grids.size(); ++i) {
      const search::OpenGrid& open = ground.grids[i];
      if (request.energy.objective.is_time()) {
        foresights_.emplace_back(ground.chart.sea, open, &ground.bounds[i]);
      } else {
        guides_.emplace_back(ground.chart.sea, open, window);
      }
    }
    for (const Ground& each : ground.fastest) fastest_.emplace_back(each);
  }

  /// The route of least cost for the departure `after`, as a plan for this departure alone would choose it.
  Result<Journey> leave(core::Seconds after, const std::stop_token& stop) {
    const PlanRequest& request = ground_.request;
    if (auto closed = search::closed_start(ground_.chart, request, after))
      return tl::unexpected(std::move(*closed));
    if (request.energy.objective.is_time()) return earliest(after, stop);
    Result<Journey> best = request.method == Method::direct ? straight(after) : cheapest(after, stop);
    for (DepartureSweep& sweep : fastest_) {
      if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
      auto other = sweep.leave(after, stop);
      if (!other) continue;
      other->cost = cost(other->arrival - after, other->energy);
      if (!best || other->cost < best->cost) best = std::move(other);
    }
    return best;
  }

 private:
  Result<Journey> earliest(core::Seconds after, const std::stop_token& stop) {
    if (ground_.request.method == Method::direct) return straight(after);
    auto found =
        search::search_voyage(ground_.chart.sea, ground_.grids, ground_.request, after, stop, [](double) {},
                              {.way = last_ ? &*last_ : nullptr, .foresights = &foresights_});
    if (!found) return tl::unexpected(std::move(found.error()));
    last_ = std::move(*found);
    return on_first_drive(last_->route.points, last_->touches_rim, after);
  }

  Result<Journey> straight(core::Seconds after) const {
    return on_first_drive(ground_.chart.layout.points, false, after);
  }

  Result<Journey> cheapest(core::Seconds after, const std::stop_token& stop) {
    const cost::Sea& sea = ground_.chart.sea;
    const auto found =
        search::search_least_cost(sea, ground_.grids, ground_.request, after, stop, [](double) {}, &guides_);
    if (!found) return tl::unexpected(found.error());
    const auto times = cost::drive_along(sea, found->route, after);
    if (!times) {
      const cost::RouteClosed closed{.reason = times.error(), .at = found->route.points.front()};
      return tl::unexpected(search::explain_route(closed, sea, ground_.request));
    }
    return journey(times->arrivals, times->energy, found->touches_rim);
  }

  Result<Journey> on_first_drive(const std::vector<geo::PlanePoint>& points, bool touches_rim,
                                 core::Seconds after) const {
    const cost::Sea& sea = ground_.chart.sea;
    const auto arrivals = cost::arrivals_along(sea, points, after);
    if (!arrivals) return tl::unexpected(search::explain_route(arrivals.error(), sea, ground_.request));
    EnergyUse energy;
    for (std::size_t i = 1; i < points.size(); ++i) {
      energy += sea.energy_along(points[i - 1], points[i], (*arrivals)[i - 1],
                                 (*arrivals)[i] - (*arrivals)[i - 1], sea.drives().front());
    }
    return journey(*arrivals, energy, touches_rim);
  }

  [[nodiscard]] Journey journey(const std::vector<core::Seconds>& arrivals, const EnergyUse& energy,
                                bool touches_rim) const {
    const core::Seconds time = arrivals.back() - arrivals.front();
    return {arrivals.back(), energy.total(), cost(time, energy.total()), touches_rim};
  }

  [[nodiscard]] double cost(core::Seconds time, core::Joules energy) const {
    return ground_.request.energy.objective.cost(time, energy);
  }

  const Ground& ground_;
  std::vector<search::Foresight> foresights_;  // one for each grid, if the objective is time
  std::vector<search::CostGuide> guides_;      // one for each grid, for other objectives
  std::optional<search::FoundWay> last_;       // route of the departure before
  std::vector<DepartureSweep> fastest_;        // with each propulsion alone
};

/// Whether a larger search area may hold a route although this one does not.
bool may_be_mended(Reason why) {
  return why != Reason::cancelled && why != Reason::start_near_iceberg && why != Reason::start_in_zone;
}

/// Searches departures, each in the smaller or the larger area, as a plan for that departure alone would
/// choose.
class Comparison {
 public:
  /// `grounds` and `request` are borrowed and must outlive this.
  Comparison(Grounds& grounds, const PlanRequest& request) : grounds_{grounds}, request_{request} {}

  Result<Journey> leave(core::Seconds after, const std::stop_token& stop) {
    auto first = on(near_, grounds_.near(), after, stop);
    const bool wider_may_help = first ? first->touches_rim : may_be_mended(first.error().reason);
    if (!wider_may_help || cost::reaches(request_).size() == 1 || request_.method == Method::direct)
      return first;
    auto second = on(wide_, grounds_.wide(), after, stop);
    if (first && (!second || first->cost <= second->cost)) return first;
    return second;
  }

 private:
  static Result<Journey> on(std::optional<DepartureSweep>& sweep, const Result<Ground>& ground,
                            core::Seconds after, const std::stop_token& stop) {
    if (!ground) return tl::unexpected(ground.error());
    if (!sweep) sweep.emplace(*ground);
    return sweep->leave(after, stop);
  }

  Grounds& grounds_;
  const PlanRequest& request_;
  std::optional<DepartureSweep> near_;
  std::optional<DepartureSweep> wide_;
};

/// Departures per piece of work. The first of a piece takes twice the time of the others: no earlier route
/// bounds it.
constexpr std::size_t departures_a_piece = 8;

}  // namespace

std::vector<Result<Journey>> leave_all(const std::vector<core::UtcTime>& departures,
                                       const ocean::Environment& environment, const PlanRequest& request,
                                       const std::stop_token& stop, const core::Executor& executor,
                                       const std::function<void(std::size_t)>& ended) {
  Grounds grounds{environment, request, stop};
  std::vector<Result<Journey>> journeys(departures.size(),
                                        tl::unexpected(search::explain_cancelled(request)));
  const std::size_t pieces = (departures.size() + departures_a_piece - 1) / departures_a_piece;
  const auto first_of = [&](std::size_t piece) { return piece * departures.size() / pieces; };
  core::CountOfEnded count{ended};
  using Journeys = std::vector<Result<Journey>>;
  const auto leave = [&](std::size_t piece, bool is_caller) -> std::optional<Journeys> {
    Comparison comparison{grounds, request};
    Journeys left;
    for (std::size_t i = first_of(piece); i < first_of(piece + 1); ++i) {
      left.push_back(comparison.leave(departures[i] - request.depart, stop));
      if (stop.stop_requested()) return std::nullopt;
      count.add(is_caller);
    }
    return left;
  };
  const auto take = [&](std::size_t piece, Journeys left, bool elsewhere) {
    for (std::size_t i = 0; i < left.size(); ++i) {
      journeys[first_of(piece) + i] = std::move(left[i]);
      if (elsewhere) count.add(true);
    }
  };
  core::run_packed_parts<Journeys>(executor, pieces, leave, take);
  return journeys;
}

}  // namespace floeplan::planning::planner
