#include "api/service/simulation_service.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/bytes/sha256.hpp"
#include "api/codec/documents/flight_document.hpp"
#include "api/codec/documents/plan_document.hpp"
#include "api/codec/inputs/plan_inputs.hpp"
#include "api/service/flown_runs.hpp"
#include "engine/core/random.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/core/version.hpp"
#include "engine/messages/fault.hpp"
#include "engine/messages/flight_fault_messages.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/below_ice.hpp"
#include "engine/mission/writing/ice_files.hpp"
#include "engine/mission/writing/mission_set.hpp"
#include "engine/simulation/flight/equipped_vehicle.hpp"
#include "engine/simulation/world/make_world.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/environment/environment_loader.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/repository/work/simulation_repository.hpp"

namespace floeplan::service {
namespace {

using codec::SimulateInputs;
using nlohmann::json;
using simulation::FlightRecord;

/// A plan prepared for simulation.
struct FlownPlan {
  repository::PlanRecord record;
  planning::Plan plan;
  vehicle::GliderProfile vehicle;
  repository::EnvironmentQuery data;
  planning::UnderIceRules ice;
  core::Metres hold_radius;
};

/// Moves violations of mission files to the input member that contains the files.
core::Violations of_mission_files(core::Violations violations) {
  constexpr std::string_view files = "/files";
  for (core::Violation& violation : violations) {
    const bool named = violation.field.starts_with(files);
    violation.field = "/mission_files" + (named ? violation.field.substr(files.size()) : violation.field);
  }
  return violations;
}

/// Reads the plan, with the simulation's choice of data instead of the plan's own.
tl::expected<FlownPlan, core::Violations> plan_of(sql::Connection& db, const SimulateInputs& inputs) {
  auto record = repository::PlanRepository{db}.find({inputs.plan_id});
  if (!record)
    return tl::unexpected(core::Violations{messages::fault<"no-such-plan">("/plan_id", inputs.plan_id)});
  json request = json::parse(record->request_json);
  request.update(inputs.data);
  auto planned = codec::parse_plan_inputs(request);
  if (!planned) return tl::unexpected(planned.error());
  const vehicle::GliderProfile& vehicle = planned->request.vehicle;
  if (inputs.vehicle && *inputs.vehicle != vehicle.name) {
    return tl::unexpected(core::Violations{messages::flight_fault<"plan-for-another-vehicle">(
        "/vehicle", *inputs.vehicle, inputs.plan_id, vehicle.name)});
  }
  planning::Plan plan = codec::parse_plan_document(json::parse(record->document_json));
  codec::cover_way(*planned, record->bounds);
  planned->data.depart = plan.departure;
  planned->data.until = repository::CoveredUntil{"plan_id", plan.arrival};
  planned->data.may_begin_later = false;
  return FlownPlan{std::move(*record),
                   std::move(plan),
                   vehicle,
                   std::move(planned->data),
                   planned->request.under_ice,
                   planned->request.holds.radius};
}

/// The given mission files, or those that the plan is exported as.
tl::expected<std::vector<codec::SimulatedFile>, core::Violations> files_of(
    const SimulateInputs& inputs, const FlownPlan& flown, const ocean::Environment& environment) {
  if (!inputs.mission_files.empty()) return inputs.mission_files;
  mission::MissionSetOptions options;
  options.vehicle = flown.vehicle;
  options.lists.max_waypoints = flown.vehicle.max_waypoints_per_list;
  options.lists.holds = {.radius = flown.hold_radius,
                         .currents = mission::hold_currents(environment, flown.plan, flown.vehicle)};
  options.lists.may_end_below_ice =
      true;  // allowed here: the simulation continues from there, and no vehicle can be lost
  options.lists.origin = {flown.record.id.value, flown.record.name, flown.plan.departure, "floeplan"};
  // Below ice the files need a place in open water for recovery. The simulation does not use it, so the start
  // is given.
  if (const core::Metres turn = mission::least_upper_turn(flown.plan); turn.value > 0.0)
    options.under_ice = mission::UnderIce{{flown.plan.waypoints.front().place}, turn};
  const auto set = mission::write_mission_set(flown.plan, options);
  if (!set) return tl::unexpected(set.error());
  const auto settings = options.under_ice ? mission::ice_settings_name(options) : "";
  std::vector<codec::SimulatedFile> files;
  for (const auto& file : set->files)
    if (file.name != settings) files.push_back({file.name, file.text});
  return files;
}

tl::expected<simulation::MissionOrders, core::Violations> orders_of(
    const std::vector<codec::SimulatedFile>& files, const vehicle::GliderProfile& vehicle) {
  std::vector<mission::Document> documents;
  documents.reserve(files.size());
  for (const codec::SimulatedFile& file : files)
    documents.push_back(mission::read_document(file.name, file.text));
  auto orders = simulation::read_orders(documents, vehicle);
  if (!orders) return tl::unexpected(of_mission_files(orders.error()));
  return orders;
}

/// Continues below ice after the end of a list. A real vehicle surfaces at the end of a list to get the next
/// one, which is not possible there. `orders` come from the plan's own files.
void fly_on_below_ice(simulation::MissionOrders& orders, const planning::Plan& plan) {
  if (!plan.surfacing) return;
  bool flies_on = false;
  std::size_t waypoint = 0;
  for (simulation::GotoOrders& list : orders.lists) {
    if (!list.hold) waypoint += list.waypoints.size();
    list.next_on_board =
        waypoint < plan.surfacing->waypoints.size() && !plan.surfacing->waypoints[waypoint].may_surface;
    flies_on = flies_on || (list.next_on_board && &list != &orders.lists.back());
  }
  if (flies_on)
    orders.notes.emplace_back(
        "A goto list ends below ice, where no vehicle can come up: the next one is flown at once.");
}

/// The id of a simulation: a digest of plan, inputs, data and version.
std::string simulation_id(const json& inputs, const FlownPlan& flown, const ocean::Environment& environment) {
  std::string text = std::string{core::version()} + "\n" + inputs.dump() + "\n" + flown.record.document_json;
  for (const auto& dataset : environment.datasets) text += "\n" + dataset.id + " " + dataset.sha256;
  return "s" + codec::sha256(text).substr(0, 12);
}

std::vector<geo::LonLat> places_of(const FlownPlan& flown, const simulation::MissionOrders& orders) {
  std::vector<geo::LonLat> places{flown.plan.waypoints.front().place};
  for (const simulation::GotoOrders& list : orders.lists)
    places.insert(places.end(), list.waypoints.begin(), list.waypoints.end());
  return places;
}

/// Default: three times the planned time plus a day; a vehicle that has not arrived by then has turned back
/// long before.
core::Seconds longest_of(const SimulateInputs& inputs, const planning::Plan& plan) {
  return inputs.longest.value_or(3.0 * plan.travel_time() + core::Seconds{86400.0});
}

/// The data that all runs of a batch share.
class Batch {
 public:
  Batch(const SimulateInputs& inputs, const FlownPlan& flown, const simulation::MissionOrders& orders,
        const ocean::Environment& environment, const std::stop_token& stop)
      : inputs_{inputs},
        flown_{flown},
        orders_{orders},
        environment_{environment},
        route_{places_of(flown, orders)},
        equipment_{simulation::Sonar{inputs.sonar}, simulation::Altimeter{inputs.altimeter},
                   simulation::AdcpErrorModel{inputs.adcp}},
        vehicle_{simulation::flown_vehicle(flown.vehicle).value_or(flown.vehicle)},
        settings_{inputs.flight},
        forecast_{world_of(0, {}, stop)} {
    settings_.longest = longest_of(inputs, flown.plan);
    settings_.hull = simulation::hull_motion_for(flown.vehicle);
    if (!inputs.avoidance) return;
    system_ = simulation::system_for(forecast_, orders, route_.front(), flown.plan.departure,
                                     flown.plan.travel_time());
    system_->settings = simulation::avoidance_for(flown.vehicle, orders, inputs.sonar);
  }

  /// Why no run can start.
  [[nodiscard]] core::Violations violations() const {
    core::Violations found = simulation::violations(request_in(forecast_, 0));
    if (system_ && !system_->settings.violations().empty()) {
      const core::Violation& first = system_->settings.violations().front();
      found.push_back(
          messages::flight_fault<"sonar-does-not-suit">("/sonar", first.field.substr(1), first.rule));
    }
    return found;
  }

  struct Run {
    FlightRecord record;
    simulation::RunSummary summary;
  };

  [[nodiscard]] Run fly(std::size_t run, const std::stop_token& stop) const {
    const std::uint64_t seed = core::seed_of_run(inputs_.seed, run);
    const simulation::World world = world_of(seed, inputs_.current_error, stop);
    simulation::EquippedVehicle on_board{equipment_, world, seed, system_, stop};
    FlightRecord record = simulation::fly(request_in(world, seed), on_board, stop);
    record.sensors.sonar = on_board.log().sonar;
    record.sensors.altimeter = on_board.log().altimeter;
    record.sensors.currents = on_board.log().currents;
    simulation::RunSummary summary = simulation::summary_of(record);
    if (system_) {
      summary.could_be_saved = simulation::could_be_saved(
          world, record, simulation::foresight_of(vehicle_, orders_, inputs_.sonar), stop);
    }
    return {std::move(record), std::move(summary)};
  }

  /// The projection that all simulated worlds share.
  [[nodiscard]] const geo::LocalProjection& projection() const { return forecast_.projection(); }

 private:
  [[nodiscard]] simulation::World world_of(std::uint64_t seed, const simulation::CurrentErrorSettings& error,
                                           const std::stop_token& stop) const {
    simulation::WorldSettings settings;
    settings.current_error = error;
    settings.ice = flown_.ice;
    const core::UtcTime begin = flown_.plan.departure;
    return simulation::make_world(environment_, route_, begin, begin + longest_of(inputs_, flown_.plan),
                                  settings, seed, stop);
  }

  [[nodiscard]] simulation::FlightRequest request_in(const simulation::World& world,
                                                     std::uint64_t seed) const {
    return {.world = world,
            .orders = orders_,
            .vehicle = vehicle_,
            .start = route_.front(),
            .departure = flown_.plan.departure,
            .settings = settings_,
            .seed = seed};
  }

  const SimulateInputs& inputs_;  // borrowed
  const FlownPlan& flown_;
  const simulation::MissionOrders& orders_;
  const ocean::Environment& environment_;
  std::vector<geo::LonLat> route_;
  simulation::Equipment equipment_;
  vehicle::GliderProfile vehicle_;
  simulation::FlightSettings settings_;
  simulation::World forecast_;  // without any error of currents
  std::optional<simulation::SystemOnBoard> system_;
};

struct Flown {
  std::vector<simulation::RunSummary> summaries;
  std::vector<repository::SimulatedFlight> kept;
};

/// One flight of a batch.
struct FlownRun {
  simulation::RunSummary summary;
  std::string document_json{};  // empty if the flight is not kept whole

  /// For core::packed.
  friend auto members_of(FlownRun& run) {
    auto& [summary, document_json] = run;
    return std::tie(summary, document_json);
  }
};

Flown fly_all(const Batch& batch, const SimulateInputs& inputs, const core::Executor& executor,
              const std::stop_token& stop, const core::ProgressCallback& progress) {
  const auto runs = static_cast<std::size_t>(inputs.runs);
  const auto tracks = static_cast<std::size_t>(inputs.tracks);
  Flown flown{std::vector<simulation::RunSummary>(runs), std::vector<repository::SimulatedFlight>(tracks)};
  fly_runs<FlownRun>(
      runs, executor, stop, progress,
      [&](std::size_t run) {
        Batch::Run done = batch.fly(run, stop);
        std::string document;
        if (run < tracks) document = codec::flight_document(done.record, batch.projection(), run).dump();
        return FlownRun{std::move(done.summary), std::move(document)};
      },
      [&](std::size_t run, FlownRun done) {
        flown.summaries[run] = std::move(done.summary);
        if (run < tracks) flown.kept[run] = {static_cast<std::int64_t>(run), std::move(done.document_json)};
      });
  return flown;
}

json datasets_json(const ocean::Environment& environment) {
  json datasets = json::array();
  for (const auto& dataset : environment.datasets) {
    datasets.push_back(
        {{"id", dataset.id}, {"kind", dataset.kind}, {"name", dataset.name}, {"sha256", dataset.sha256}});
  }
  return datasets;
}

/// Median of the detour of runs that arrived, relative to the plan's distance, in per cent; null if none
/// arrived.
json median_detour(const std::vector<simulation::RunSummary>& summaries, core::Metres planned) {
  std::vector<double> detours;
  for (const auto& summary : summaries) {
    if (summary.end == simulation::FlightEnd::arrived && planned.value > 0.0)
      detours.push_back(100.0 * (summary.distance_m / planned.value - 1.0));
  }
  const auto found = simulation::distribution_of(std::move(detours));
  return found ? json(std::round(100.0 * found->quantiles[2].value) / 100.0) : json();
}

json document_of(const std::string& id, const SimulateInputs& inputs, const FlownPlan& flown,
                 const Flown& batch, const std::vector<codec::SimulatedFile>& files) {
  json names = json::array();
  for (const codec::SimulatedFile& file : files) names.push_back(file.name);
  json flights = json::array();
  for (std::size_t run = 0; run < batch.summaries.size(); ++run)
    flights.push_back(codec::summary_document(batch.summaries[run], run));
  const auto ended = [&](simulation::FlightEnd end) {
    return std::ranges::count(batch.summaries, end, &simulation::RunSummary::end);
  };
  return {{"simulation_id", id},
          {"status", "ok"},
          {"plan_id", inputs.plan_id},
          {"name", inputs.name},
          {"vehicle", flown.vehicle.name},
          {"departure", core::iso8601(flown.plan.departure)},
          {"planned_arrival", core::iso8601(flown.plan.arrival)},
          {"planned_travel_time_s", flown.plan.travel_time().count()},
          {"mission_files", std::move(names)},
          {"seed", std::to_string(inputs.seed)},
          {"avoidance", inputs.avoidance},
          {"tracks", inputs.tracks},
          {"statistics", codec::statistics_document(simulation::statistics_of(batch.summaries))},
          {"runs", inputs.runs},
          {"arrived", ended(simulation::FlightEnd::arrived)},
          {"collisions", ended(simulation::FlightEnd::collided) + ended(simulation::FlightEnd::grounded)},
          {"gave_up", ended(simulation::FlightEnd::gave_up)},
          {"median_detour_pct", median_detour(batch.summaries, flown.plan.distance)},
          {"flights", std::move(flights)}};
}

}  // namespace

tl::expected<json, core::Violations> simulate_plan_document(sql::Connection& db, const SimulateInputs& inputs,
                                                            const core::Executor& executor,
                                                            const std::stop_token& stop,
                                                            const core::ProgressCallback& progress,
                                                            core::UtcTime now) {
  if (progress) progress("loading data", 0.0);
  const auto flown = plan_of(db, inputs);
  if (!flown) return tl::unexpected(flown.error());
  const auto environment = repository::load_environment(db, flown->data, {stop});
  if (!environment) return tl::unexpected(environment.error());
  const auto files = files_of(inputs, *flown, *environment);
  if (!files) return tl::unexpected(files.error());
  auto orders = orders_of(*files, flown->vehicle);
  if (!orders) return tl::unexpected(orders.error());
  if (inputs.mission_files.empty()) fly_on_below_ice(*orders, flown->plan);

  json cancelled{{"status", "cancelled"}, {"plan_id", inputs.plan_id}};
  const Batch batch{inputs, *flown, *orders, *environment, stop};
  if (stop.stop_requested()) return cancelled;
  if (auto violations = batch.violations(); !violations.empty()) return tl::unexpected(std::move(violations));

  const Flown result = fly_all(batch, inputs, executor, stop, progress);
  if (stop.stop_requested()) return cancelled;
  const json request = codec::to_json(inputs);
  const std::string id = simulation_id(request, *flown, *environment);
  json document = document_of(id, inputs, *flown, result, *files);
  document["datasets"] = datasets_json(*environment);
  std::vector<messages::Message> told = environment->messages;
  for (const std::string& note : orders->notes)
    told.push_back(messages::plan_message<"mission-file-note">(note));
  if (!simulation::flown_vehicle(flown->vehicle)) told.push_back(messages::plan_message<"speed-not-made">());
  codec::tell(document, std::move(told));
  repository::SimulationRepository{db}.insert({.row = 0,
                                               .id = {id},
                                               .plan_id = inputs.plan_id,
                                               .name = inputs.name,
                                               .created = now,
                                               .request_json = request.dump(),
                                               .document_json = document.dump()},
                                              result.kept);
  return document;
}

}  // namespace floeplan::service
