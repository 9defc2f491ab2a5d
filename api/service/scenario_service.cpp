#include "api/service/scenario_service.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/codec/documents/flight_document.hpp"
#include "api/service/flown_runs.hpp"
#include "engine/core/random.hpp"
#include "engine/simulation/flight/equipped_vehicle.hpp"
#include "engine/simulation/flight/hindsight.hpp"
#include "engine/simulation/flight/random_icebergs.hpp"
#include "storage/json/json.hpp"

namespace floeplan::service {
namespace {

using nlohmann::json;
using simulation::FlightEnd;
using simulation::RunSummary;

/// Chosen: in Disko Bay, on a day in the season. The iceberg field does not depend on it.
constexpr geo::LonLat start{-53.0, 69.0};
constexpr core::UtcTime departure = core::from_unix_seconds(1'795'327'200.0);

simulation::FlightRecord fly_through(const simulation::IcebergField& field, std::uint64_t seed,
                                     const std::optional<simulation::SystemOnBoard>& system,
                                     const simulation::Equipment& equipment, const std::stop_token& stop) {
  simulation::EquippedVehicle on_board{equipment, field.world, seed, system, stop};
  return simulation::fly({.world = field.world,
                          .orders = field.orders,
                          .vehicle = field.vehicle,
                          .start = start,
                          .departure = departure,
                          .settings = {.longest = simulation::longest_flight({}, field.vehicle),
                                       .known_current = field.forecast},
                          .seed = seed},
                         on_board, stop);
}

/// Tells whether the icebergs or the current alone kept a vehicle from its goal.
std::string told_by_an_empty_sea(std::uint64_t seed, const simulation::Equipment& equipment,
                                 const std::stop_token& stop) {
  const simulation::IcebergFieldSettings no_bergs{.km2_for_each = 1e9};
  const auto field = simulation::random_icebergs(no_bergs, start, departure, seed);
  const auto record = fly_through(field, seed, {}, equipment, stop);
  if (record.end == FlightEnd::arrived) return " In the same water without icebergs it arrives.";
  return " In the same water without icebergs it does not arrive either: the current is too strong.";
}

bool has_touched(const RunSummary& run) {
  return run.end == FlightEnd::collided || run.end == FlightEnd::grounded;
}

RunSummary fly_field(std::uint64_t seed, bool avoidance, const simulation::Equipment& equipment,
                     const std::stop_token& stop) {
  const simulation::IcebergField field = simulation::random_icebergs({}, start, departure, seed);
  std::optional<simulation::SystemOnBoard> system;
  if (avoidance) {
    system = simulation::system_for(field.world, field.orders, start, departure,
                                    simulation::longest_flight({}, field.vehicle));
    system->settings = simulation::avoidance_for(field.vehicle, field.orders, equipment.sonar.settings());
  }
  const simulation::FlightRecord record = fly_through(field, seed, system, equipment, stop);
  RunSummary summary = simulation::summary_of(record);
  if (avoidance) {
    summary.could_be_saved = simulation::could_be_saved(
        field.world, record,
        simulation::foresight_of(field.vehicle, field.orders, equipment.sonar.settings()), stop);
  }
  if (record.end != FlightEnd::arrived && !has_touched(summary))
    summary.why += told_by_an_empty_sea(seed, equipment, stop);
  return summary;
}

/// A list of the runs for which `is` is true, with their seeds and reasons.
template <class Is>
json listed(const std::vector<RunSummary>& runs, const Is& is) {
  json list = json::array();
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (is(runs[run])) {
      list.push_back({{"run", run}, {"seed", std::to_string(runs[run].seed)}, {"why", runs[run].why}});
    }
  }
  return list;
}

/// Median detour of the runs that arrived, in per cent of the straight line; null if none arrived.
json median_detour_of_runs(const std::vector<RunSummary>& runs) {
  const double straight_m = simulation::IcebergFieldSettings{}.route.value;
  std::vector<double> detours;
  for (const RunSummary& run : runs) {
    if (run.end == FlightEnd::arrived) detours.push_back(100.0 * (run.distance_m / straight_m - 1.0));
  }
  const auto found = simulation::distribution_of(std::move(detours));
  return found ? json(std::round(100.0 * found->quantiles[2].value) / 100.0) : json();
}

}  // namespace

json fly_scenario_document(const codec::ScenarioInputs& asked, const core::Executor& executor,
                           const std::stop_token& stop, const core::ProgressCallback& progress) {
  const simulation::Equipment equipment;
  std::vector<RunSummary> runs(static_cast<std::size_t>(asked.runs));
  fly_runs<RunSummary>(
      runs.size(), executor, stop, progress,
      [&](std::size_t run) {
        return fly_field(core::seed_of_run(asked.seed, run), asked.avoidance, equipment, stop);
      },
      [&](std::size_t run, RunSummary summary) { runs[run] = std::move(summary); });
  if (stop.stop_requested()) return {{"status", "cancelled"}, {"scenario", asked.scenario}};
  const auto is_beyond_help = [](const RunSummary& run) { return run.could_be_saved == false; };
  const auto has_given_up = [](const RunSummary& run) {
    return run.end != FlightEnd::arrived && !has_touched(run);
  };
  const auto touched = std::ranges::count_if(runs, has_touched);
  const auto beyond_help = std::ranges::count_if(runs, is_beyond_help);
  json flights = json::array();
  for (std::size_t run = 0; run < runs.size(); ++run)
    flights.push_back(codec::summary_document(runs[run], run));
  return {{"scenario", asked.scenario},
          {"runs", asked.runs},
          {"seed", std::to_string(asked.seed)},
          {"avoidance", asked.avoidance},
          {"arrived", std::ranges::count(runs, FlightEnd::arrived, &RunSummary::end)},
          {"collisions", touched - beyond_help},
          {"beyond_help", beyond_help},
          {"gave_up", std::ranges::count_if(runs, has_given_up)},
          {"runs_beyond_help", listed(runs, is_beyond_help)},
          {"runs_given_up", listed(runs, has_given_up)},
          {"median_detour_pct", median_detour_of_runs(runs)},
          {"statistics", codec::statistics_document(simulation::statistics_of(runs))},
          {"flights", std::move(flights)}};
}

}  // namespace floeplan::service
