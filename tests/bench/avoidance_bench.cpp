#include <algorithm>
#include <memory>

#include "engine/avoidance/avoidance_system.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/engine/avoidance/on_board/crowded_sea.hpp"

namespace floeplan::bench {
namespace {

using avoidance::AvoidanceSystem;

constexpr int seconds = 300;

struct Steps {
  double mean_s{};
  double worst_s{};
};

/// Times consecutive steps of a vehicle in a sea where every ping has this number of echoes, with a new
/// avoidance system.
template <class Step>
Steps timed_steps(std::size_t echoes, const Step& step) {
  const auto system = std::make_unique<AvoidanceSystem>(
      std::vector<geo::PlanePoint>{{2000.0, 0.0}, {5000.0, 500.0}},
      avoidance::CarriedForecast{geo::VelocityEn{}}, avoidance::AvoidanceSettings{});
  support::CrowdedSea sea{echoes};
  Steps taken;
  for (int second = 0; second < seconds; ++second) {
    const avoidance::Sensed& sensed = sea.at(second);
    const double start = thread_seconds();
    step(*system, sensed);
    const double spent = thread_seconds() - start;
    taken.mean_s += spent / seconds;
    taken.worst_s = std::max(taken.worst_s, spent);
  }
  return taken;
}

Row within(std::string what, double ours_ms, double most_ms, std::string target) {
  return {.what = std::move(what),
          .unit = "ms",
          .ours = ours_ms,
          .comparator = {},
          .meets_target = ours_ms <= most_ms,
          .target = std::move(target)};
}

}  // namespace

std::vector<Row> avoidance_rows() {
  const auto react = [](AvoidanceSystem& system, const avoidance::Sensed& sensed) {
    (void)system.react(sensed);
  };
  const auto plan_after_react = [](AvoidanceSystem& system, const avoidance::Sensed& sensed) {
    (void)system.react(sensed);
    if (system.path_wanted()) system.plan_path();
  };
  const Steps crowded = timed_steps(avoidance::SonarPing::most_returns, react);
  double usual_mean_s = timed_steps(60, react).mean_s;
  for (int again = 0; again < 2; ++again)
    usual_mean_s = std::min(usual_mean_s, timed_steps(60, react).mean_s);
  const Steps planning = timed_steps(60, plan_after_react);
  return {within("avoidance: worst reactive step, 512 echoes a ping", 1e3 * crowded.worst_s, 100.0,
                 "a tenth of a second"),
          gauged_by(Gauge::time, within("avoidance: mean reactive step, 60 echoes a ping", 1e3 * usual_mean_s,
                                        10.0, "a hundredth of a second")),
          within("avoidance: worst step with path planning", 1e3 * planning.worst_s, 500.0, "half a second")};
}

}  // namespace floeplan::bench
