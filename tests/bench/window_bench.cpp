#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/planning/plan_route.hpp"
#include "engine/planning/planner/departure.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::bench {
namespace {

constexpr int departures = 121;      // every hour of five days
constexpr int hours = 12 * 24;       // of currents: also the last departure must arrive
constexpr int one_by_one_step = 12;  // every twelfth departure is planned alone: planning all takes minutes

/// A tide that turns twice a day and is stronger at springs, and drifting eddies of 30 km. Eddies of one sense of rotation are
/// 60 km apart.
geo::VelocityEn tide_and_eddies(geo::LonLat place, double hour) {
  const double springs = 1.0 + 0.3 * std::cos(2.0 * std::numbers::pi * hour / (14.76 * 24.0));
  const double tide = 0.1 * springs * std::sin(2.0 * std::numbers::pi * hour / 12.42 + place.lon_deg);
  const double eddy = 0.08 * std::sin(4.2 * place.lon_deg + 0.01 * hour) * std::cos(11.0 * place.lat_deg);
  return {{tide + eddy}, {0.5 * tide - eddy}};
}

/// 100 km on a grid of 151 x 151 vertices.
planning::PlanRequest request() {
  planning::PlanRequest result = support::eastward_request();
  result.from = {-54.25, 69.0};
  result.to = {-51.75, 69.0};
  result.spacing_along = core::Metres{1000.0};
  result.spacing_across = core::Metres{668.0};
  result.refine = false;
  result.optimality_gap = false;
  return result;
}

}  // namespace

std::vector<Row> window_rows() {
  const ocean::Environment sea{.currents = support::currents_from(tide_and_eddies, hours)};
  planning::PlanRequest window = request();
  window.departures.until = window.depart + (departures - 1) * window.departures.step;
  std::vector<planning::DepartureOutcome> curve;
  const double seconds =
      least_seconds(1, [&] { curve = planning::planner::compare_departures(sea, window, {}, {}).value(); });

  int planned = 0;
  const double alone_s = least_seconds(1, [&] {
    for (std::size_t i = 0; i < curve.size(); i += one_by_one_step) {
      planning::PlanRequest alone = request();
      alone.depart = curve[i].departure;
      const auto plan = planning::plan_route(sea, alone, {}, {});
      // In a plan, straight runs of legs are joined and therefore integrated in fewer pieces.
      const double apart_s = (plan->travel_time() - curve[i].travel_time.value()).count();
      if (std::abs(apart_s) > 2e-4 * plan->travel_time().count()) {
        throw std::runtime_error{"a departure of the window differs from a plan for it alone"};
      }
      ++planned;
    }
  });
  Row row = less_is_better("window of 121 departures, 151 x 151 vertices, 3-sector", "s", seconds,
                           "planning each alone, from every twelfth", alone_s / planned * departures);
  row.target = "< 5 s";
  row.meets_target = row.ours < 5.0;
  row.gauge = Gauge::time;
  return {row};
}

}  // namespace floeplan::bench
