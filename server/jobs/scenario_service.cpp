#include "server/jobs/scenario_service.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/codec/flight_document.hpp"
#include "engine/core/random.hpp"
#include "engine/simulation/equipped_vehicle.hpp"
#include "engine/simulation/random_icebergs.hpp"
#include "server/jobs/parallel_runs.hpp"

namespace floeplan::jobs {
namespace {

using nlohmann::json;
using simulation::FlightEnd;
using simulation::RunSummary;

/// In Disko Bay, on a day in the season; the field itself is the same anywhere.
constexpr geo::LonLat start{-53.0, 69.0};
constexpr core::UtcTime departure = core::from_unix_seconds(1'795'327'200.0);

RunSummary fly_field(std::uint64_t seed, bool avoidance, const simulation::Equipment& equipment,
                     const std::stop_token& stop) {
  const simulation::IcebergFieldSettings settings;
  const simulation::IcebergField field = simulation::random_icebergs(settings, start, departure, seed);
  const core::Seconds longest = simulation::longest_flight(settings, field.vehicle);
  std::optional<simulation::SystemOnBoard> system;
  if (avoidance) {
    system = simulation::system_for(field.world, field.orders, start, departure, longest);
    system->settings = simulation::avoidance_for(field.vehicle, field.orders, equipment.sonar.settings());
  }
  simulation::EquippedVehicle on_board{equipment, field.world, seed, system, stop};
  return simulation::summary_of(
      simulation::fly({.world = field.world,
                       .orders = field.orders,
                       .vehicle = field.vehicle,
                       .start = start,
                       .departure = departure,
                       .settings = {.longest = longest, .known_current = field.forecast},
                       .seed = seed},
                      on_board, stop));
}

/// Of the runs that arrived, over the straight way; null when none did.
json median_detour(const std::vector<RunSummary>& runs) {
  const double straight_m = simulation::IcebergFieldSettings{}.route.value;
  std::vector<double> detours;
  for (const RunSummary& run : runs) {
    if (run.end == FlightEnd::arrived) detours.push_back(100.0 * (run.distance_m / straight_m - 1.0));
  }
  const auto found = simulation::distribution_of(std::move(detours));
  return found ? json(std::round(100.0 * found->quantiles[2].value) / 100.0) : json();
}

}  // namespace

json random_icebergs_document(const ScenarioRuns& asked, const std::stop_token& stop,
                              const core::ProgressCallback& progress) {
  const simulation::Equipment equipment;
  std::vector<RunSummary> runs(static_cast<std::size_t>(asked.runs));
  run_in_parallel(
      runs.size(), asked.workers, stop,
      [&](std::size_t run, const std::stop_token& run_stop) {
        runs[run] = fly_field(core::seed_of_run(asked.seed, run), asked.avoidance, equipment, run_stop);
      },
      [&](std::size_t done) {
        if (progress) progress("flying", static_cast<double>(done) / static_cast<double>(runs.size()));
      });
  if (stop.stop_requested()) return {{"status", "cancelled"}, {"scenario", "random-icebergs"}};
  const auto ended = [&](FlightEnd end) { return std::ranges::count(runs, end, &RunSummary::end); };
  json flights = json::array();
  for (std::size_t run = 0; run < runs.size(); ++run)
    flights.push_back(codec::summary_document(runs[run], run));
  return {{"scenario", "random-icebergs"},
          {"runs", asked.runs},
          {"seed", std::to_string(asked.seed)},
          {"avoidance", asked.avoidance},
          {"arrived", ended(FlightEnd::arrived)},
          {"collisions", ended(FlightEnd::collided) + ended(FlightEnd::grounded)},
          {"gave_up", ended(FlightEnd::gave_up) + ended(FlightEnd::time_up)},
          {"median_detour_pct", median_detour(runs)},
          {"statistics", codec::statistics_document(simulation::statistics_of(runs))},
          {"flights", std::move(flights)}};
}

}  // namespace floeplan::jobs
