#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/find_isochrones.hpp"
#include "engine/planning/plan_arrival.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/plan_window.hpp"
#include "engine/planning/planner/departure.hpp"
#include "engine/planning/search/latest_departure.hpp"
#include "tests/support/small_sea.hpp"

/// Every kind of request is stopped at each of its stages.
namespace floeplan::planning::cancellation_test {
namespace {

using support::eastward_request;

geo::VelocityEn tide(geo::LonLat place, double hour) {
  const double c = 0.12 * std::sin(hour / 1.97 + place.lon_deg);
  return {{c}, {0.4 * c}};
}

ocean::Environment bay() {
  ocean::Environment environment{.currents = support::currents_from(tide, 96)};
  environment.icebergs = {support::iceberg_at({-53.1, 69.02}, 300.0),
                          support::iceberg_at({-52.8, 68.97}, 200.0)};
  return environment;
}

PlanRequest coarse_request() {
  PlanRequest request = eastward_request();
  request.spacing_along = core::Metres{4000.0};
  request.icebergs.max_inflation = core::Metres{0.0};
  request.refine = false;
  request.optimality_gap = false;
  return request;
}

/// Why there is no result; empty where there is one.
using Work =
    std::function<std::optional<Reason>(const std::stop_token& stop, const core::ProgressCallback& progress)>;

template <class T>
std::optional<Reason> reason_of(const Result<T>& result) {
  return result ? std::nullopt : std::optional{result.error().reason};
}

Work planned(PlanRequest request, const ocean::Environment& environment = bay()) {
  return [=](const std::stop_token& stop, const core::ProgressCallback& progress) {
    return reason_of(plan_route(environment, request, stop, progress));
  };
}

struct Kind {
  std::string name;
  Work work;
};

std::vector<Kind> kinds_of_request() {
  std::vector<Kind> kinds;
  kinds.push_back({"a plan", planned(coarse_request())});

  PlanRequest refined = coarse_request();
  refined.refine = refined.optimality_gap = true;
  kinds.push_back({"a refined plan", planned(refined)});

  PlanRequest cheapest = coarse_request();
  cheapest.energy.objective = energy_objective;
  kinds.push_back({"the cheapest plan", planned(cheapest)});

  PlanRequest careful = coarse_request();
  careful.icebergs.encounter_weight = core::Seconds{36'000.0};
  kinds.push_back({"a plan with fewer encounters", planned(careful)});

  PlanRequest waiting = coarse_request();
  waiting.holds.longest = core::Seconds{7200.0};
  kinds.push_back({"a plan that may wait", planned(waiting)});

  PlanRequest survey = coarse_request();
  survey.via = {{-53.3, 68.95}, {-52.9, 69.06}, {-52.7, 69.04}};
  survey.via_in_best_order = true;
  kinds.push_back({"a survey", planned(survey)});

  PlanRequest robust = coarse_request();
  robust.uncertainty.objective = RobustObjective::mean;
  ocean::Environment members = bay();
  members.members = {
      members.currents,
      support::currents_from([](geo::LonLat place, double hour) { return tide(place, hour + 2.0); }, 96)};
  kinds.push_back({"members", planned(robust, members)});

  PlanRequest slow = coarse_request();
  slow.vehicle.speed_through_water = {0.1};
  kinds.push_back(
      {"an explanation",
       planned(slow, {.currents = support::currents_from(
                          [](geo::LonLat, double) { return geo::VelocityEn{{-0.2}, {0.0}}; }, 96)})});

  PlanRequest window = coarse_request();
  window.departures.until = window.depart + core::Seconds{3.0 * 3600.0};
  kinds.push_back({"a window", [window](const auto& stop, const auto& progress) {
                     return reason_of(plan_window(bay(), window, stop, progress, {}).plan);
                   }});

  PlanRequest arrival = coarse_request();
  arrival.departures.arrive_by = arrival.depart + core::Seconds{72.0 * 3600.0};
  kinds.push_back({"a latest departure", [arrival](const auto& stop, const auto& progress) {
                     return reason_of(plan_arrival(bay(), arrival, stop, progress, {}));
                   }});

  IsochroneRequest reach;
  reach.place = coarse_request().from;
  reach.time = coarse_request().depart;
  reach.vehicle = coarse_request().vehicle;
  reach.spans = {core::Seconds{6.0 * 3600.0}, core::Seconds{12.0 * 3600.0}};
  kinds.push_back({"a reach", [reach](const auto& stop, const auto& progress) {
                     return reason_of(find_isochrones(bay(), reach, stop, progress));
                   }});

  kinds.push_back({"an evaluation", [](const auto& stop, const auto& progress) {
                     if (progress) progress("evaluation", 0.0);
                     const PlanRequest request = coarse_request();
                     return reason_of(
                         evaluate_route(bay(), {request.from, {-53.0, 68.93}, request.to}, request, stop));
                   }});
  return kinds;
}

TEST(Cancellation, EndsEveryKindOfRequestThatIsStoppedBeforeItBegins) {
  std::stop_source source;
  source.request_stop();
  for (const Kind& kind : kinds_of_request()) {
    EXPECT_EQ(kind.work(source.get_token(), {}), Reason::cancelled) << kind.name;
  }
}

TEST(Cancellation, EndsEveryKindOfRequestAtWhateverStageItIsStopped) {
  constexpr int most_reports_after = 3;  // a thousand expansions of a search, its refinement and its end
  for (const Kind& kind : kinds_of_request()) {
    std::vector<std::string> stages;
    static_cast<void>(kind.work({}, [&](std::string_view stage, double) {
      if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
    }));
    if (!stages.empty() && stages.back() == "done") stages.pop_back();
    ASSERT_FALSE(stages.empty()) << kind.name;

    for (std::size_t stage = 0; stage < stages.size(); ++stage) {
      std::stop_source source;
      std::size_t begun = 0;
      std::string latest;
      int reports_after = 0;
      const auto reason = kind.work(source.get_token(), [&](std::string_view name, double) {
        if (source.stop_requested()) ++reports_after;
        if (latest != name) ++begun;
        latest = name;
        if (begun == stage + 1) source.request_stop();
      });
      EXPECT_EQ(reason, Reason::cancelled) << kind.name << ", stopped at: " << stages[stage];
      EXPECT_LE(reports_after, most_reports_after) << kind.name << ", stopped at: " << stages[stage];
    }
  }
}

}  // namespace
}  // namespace floeplan::planning::cancellation_test
