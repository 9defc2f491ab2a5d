#include "engine/planning/planner/strong_currents.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/core/packed_parts.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/messages/refusal_messages.hpp"
#include "engine/planning/cost/layout.hpp"
#include "engine/planning/planner/cost_plan.hpp"
#include "engine/planning/planner/robust_plan.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::planner {
namespace {

constexpr int most_sectors = 5;

/// Room on each side, as a multiple of the distance. Routes found in the Agulhas Current, the Kuroshio, the
/// Gulf Stream and off the Falklands lead round eddies of 100 to 250 km: four times the distance if start and
/// goal are 50 km apart.
constexpr double distances_of_room = 5.0;
constexpr core::Metres least_room{50'000.0};  // eddies are as large on short routes
constexpr core::Metres most_room{250'000.0};
constexpr double most_samples = 3.2e7;  // of the currents in the area: 250 MB

/// Plans on two grids agree if their costs differ by at most this share. Plans on grids of different spacings in
/// the same currents differ by about as much. A judgement.
constexpr double agreement = 0.01;

/// Number of timed legs that counts as much work; a few seconds.
constexpr std::int64_t much_work = 5'000'000;

core::MetresPerSecond through_water(const PlanRequest& request) {
  return drive_speed(request.vehicle, drives(request.energy, request.vehicle).back());
}

/// The longest distance between consecutive stops.
core::Metres longest_stretch(const PlanRequest& request) {
  std::vector<geo::LonLat> stops = request.via;
  stops.insert(stops.begin(), request.from);
  stops.push_back(request.to);
  core::Metres longest{0.0};
  for (std::size_t i = 1; i < stops.size(); ++i)
    longest = std::max(longest, geo::geodesic_between(stops[i - 1], stops[i]).length);
  return longest;
}

/// The largest extent of the usual grids beside the straight line and beyond its ends.
core::Metres usual_room(const PlanRequest& request) {
  return std::max(cost::second_reach.across * longest_stretch(request), cost::second_reach.at_least);
}

/// Size of a box in square degrees, for comparison with another box at about the same latitude.
double size(const geo::BoundingBox& box) { return geo::width_deg(box) * (box.north_deg - box.south_deg); }

double samples_of(const ocean::Environment& environment) {
  const auto count = [](const auto& currents) { return static_cast<double>(currents->samples().u.size()); };
  double samples = environment.currents ? count(environment.currents) : 0.0;
  for (const auto& member : environment.members) samples += count(member);
  return samples;
}

PlanRequest with_more_directions(PlanRequest request) {
  request.sectors = std::max(request.sectors, most_sectors);
  return request;
}

/// Whether the request allows more grids at all.
bool allows_more_grids(const ocean::Environment& environment, const PlanRequest& request) {
  return request.method != Method::direct && !request.under_ice.max_time_without_surfacing &&
         !cost::has_uncertain_currents(environment, request);
}

bool takes_more_than_one_try(const Plan& known, const ocean::Environment& environment,
                             const PlanRequest& request) {
  return known.strongest_current >= through_water(request) && !known.search.cut_short &&
         !known.search.none_is_earlier && known.search.edge_evaluations < much_work &&
         allows_more_grids(environment, request);
}

/// Plans on further grids, and keeps the best.
class MoreGrids {
 public:
  /// `task` and `plan_once` are borrowed and must outlive this.
  MoreGrids(Result<Plan> known, const Task& task, const Planning& plan_once)
      : task_{task}, plan_once_{plan_once}, best_{std::move(known)}, is_known_{best_.has_value()} {
    if (is_known_) highest_ = cost_of(*best_, objective());
  }

  /// Whether there is no plan yet, or the plan that was known is still to be compared.
  [[nodiscard]] bool need_more() const { return is_known_ || !best_; }

  /// Plans these tasks, at the same time if the executor can. Once the stop is requested the result is incomplete.
  void try_all(const std::vector<Task>& tasks) {
    const core::ProgressCallback part = parts_.next();
    core::CountOfEnded ended{[&](std::size_t count) {
      part("more grids", static_cast<double>(count) / static_cast<double>(tasks.size()));
    }};
    part("more grids", 0.0);
    const auto plan = [&](std::size_t i) {
      const Task& to_try = tasks[i];
      return plan_once_((best_ ? to_try.to_beat(*best_) : to_try).as_piece());
    };
    const auto cost_if_found = [&](const Result<Plan>& found) {
      return found ? std::optional{cost_of(*found, objective())} : std::nullopt;
    };
    std::vector<Result<Plan>> found(tasks.size(), tl::unexpected(Infeasible{}));
    std::vector<std::optional<double>> costs(tasks.size());
    using Cost = std::optional<double>;
    core::run_packed_parts<Cost>(
        task_.executor, tasks.size(),
        [&](std::size_t i, bool is_caller) -> std::optional<Cost> {
          found[i] = plan(i);
          if (task_.stop.stop_requested()) return std::nullopt;
          ended.add(is_caller);
          return cost_if_found(found[i]);
        },
        [&](std::size_t i, Cost cost, bool elsewhere) {
          costs[i] = cost;
          if (elsewhere) ended.add(true);
        });
    if (task_.stop.stop_requested()) return;
    std::optional<std::size_t> cheapest;
    double least = best_ ? cost_of(*best_, objective()) : INFINITY;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      all_found_ = all_found_ && costs[i];
      if (!costs[i]) continue;
      highest_ = std::max(highest_, *costs[i]);
      if (*costs[i] >= least) continue;
      least = *costs[i];
      cheapest = i;
    }
    if (!cheapest) return;
    // Of a plan that another process made only the cost is known.
    best_ = found[*cheapest] ? std::move(found[*cheapest]) : plan(*cheapest);
  }

  /// `looked_for`  the request with the most room that was tried
  [[nodiscard]] Result<Plan> result(const PlanRequest& looked_for) && {
    if (!best_) return tl::unexpected(with_area_searched(std::move(best_.error()), looked_for));
    const bool agree =
        is_known_ && all_found_ && highest_ <= (1.0 + agreement) * cost_of(*best_, objective());
    best_->messages.insert(best_->messages.begin(),
                           agree ? messages::plan_message<"several-grids-agree">(100.0 * agreement)
                                 : messages::plan_message<"several-grids-tried">());
    return std::move(best_);
  }

 private:
  [[nodiscard]] Objective objective() const { return task_.request.objective(); }

  const Task& task_;
  const Planning& plan_once_;
  core::PartsOfProgress parts_{task_.progress, "more grids"};
  Result<Plan> best_;
  bool is_known_;
  bool all_found_{true};
  double highest_{0.0};
};

}  // namespace

bool any_current_may_close(const ocean::CurrentGrid& currents, const PlanRequest& request,
                           const std::stop_token& stop) {
  constexpr std::size_t between_looks = 1 << 20;  // about a millisecond of samples
  const auto fastest = static_cast<float>(through_water(request).value);
  const auto& samples = currents.samples();
  for (std::size_t i = 0; i < samples.u.size(); ++i) {
    if (i % between_looks == 0 && stop.stop_requested()) return false;
    if (samples.u[i] * samples.u[i] + samples.v[i] * samples.v[i] >= fastest * fastest) return true;
  }
  return false;
}

std::optional<Roomy> with_more_room(const ocean::Environment& environment, const PlanRequest& request,
                                    const WiderSea& wider) {
  const double usual_deg2 = size(cost::planning_area(request));
  PlanRequest roomy = with_more_directions(request);
  roomy.room = std::clamp(distances_of_room * longest_stretch(request), least_room, most_room);
  const core::Metres usual = usual_room(request);
  while (usual < *roomy.room) {
    const double grows_by = size(cost::planning_area(roomy)) / usual_deg2;
    if (!wider) return Roomy{std::move(roomy), environment};
    if (grows_by * samples_of(environment) <= most_samples) {
      auto sea = wider(roomy);
      if (!sea) return std::nullopt;
      return Roomy{std::move(roomy), std::move(*sea)};
    }
    roomy.room = 0.5 * *roomy.room;
  }
  return std::nullopt;
}

bool more_room_may_help(const Infeasible& why, const ocean::Environment& environment,
                        const PlanRequest& request, const std::stop_token& stop) {
  if (request.method == Method::direct || why.at_a_stop || why.search_cut_short) return false;
  switch (why.reason) {
    case Reason::current_too_strong: return true;
    case Reason::goal_unreachable:
    case Reason::outside_data:
    case Reason::arrival_too_early:
      return environment.currents && any_current_may_close(*environment.currents, request, stop);
    default: return false;
  }
}

Infeasible with_area_searched(Infeasible why, const PlanRequest& looked_for) {
  const core::Metres usual = usual_room(looked_for);
  why.besides.push_back(
      messages::refusal<"area-searched">(std::max(looked_for.room.value_or(usual), usual).value / 1000.0));
  return why;
}

double share_of_usual_grids(const ocean::Environment& environment, const PlanRequest& request,
                            const std::stop_token& stop) {
  const bool may_try_more = environment.currents && allows_more_grids(environment, request) &&
                            any_current_may_close(*environment.currents, request, stop);
  return may_try_more ? 0.5 : 1.0;
}

Result<Plan> best_of_more_grids(Result<Plan> known, const Task& task, const Planning& plan_once) {
  const auto& [environment, request, stop, progress, wider, shelf, executor, of_use, known_route] = task;
  if (request.method == Method::direct || stop.stop_requested()) return known;
  const bool is_worth_it = known ? takes_more_than_one_try(*known, environment, request)
                                 : more_room_may_help(known.error(), environment, request, stop);
  if (!is_worth_it) return known;
  const auto roomy = with_more_room(environment, request, wider);
  const PlanRequest dense = with_more_directions(request);
  const PlanRequest coarse = cost::on_coarser_grids(dense);
  // A known plan is compared with all others. Without one, each is tried only if those before it failed.
  std::vector<std::vector<Task>> rounds(1);
  const auto then = [&](Task other) {
    if (!known && !rounds.back().empty()) rounds.emplace_back();
    rounds.back().push_back(std::move(other));
  };
  if (roomy) then(task.in(roomy->sea).with(roomy->request));
  if (!roomy || !known) then(task.with(dense));
  if (!request.spacing_along) then(task.with(coarse));

  MoreGrids grids{std::move(known), task, plan_once};
  for (const std::vector<Task>& round : rounds) {
    if (!grids.need_more()) break;
    grids.try_all(round);
    if (stop.stop_requested()) return tl::unexpected(search::explain_cancelled(request));
  }
  return std::move(grids).result(roomy ? roomy->request : request);
}

}  // namespace floeplan::planning::planner
