#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include "api/codec/inputs/simulate_inputs.hpp"
#include "api/routes/plans/simulation_exports.hpp"
#include "api/service/scenario_service.hpp"
#include "api/service/simulation_service.hpp"
#include "api/service/threads.hpp"
#include "engine/core/shown_text.hpp"
#include "engine/core/utc_text.hpp"
#include "server/cli/output/file_set.hpp"
#include "server/cli/output/plan_output.hpp"
#include "server/cli/output/violation_output.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/flag_values.hpp"
#include "server/cli/program/input_flags.hpp"
#include "server/cli/program/interruption.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/repository/work/simulation_repository.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

struct SimulateFlags {
  std::string plan_id;
  std::string scenario;
  std::optional<std::string> request_file;
  std::optional<int> runs;
  std::optional<int> seed;
  std::optional<int> tracks;
  std::optional<double> current_error_m_s;
  std::optional<double> record_every_s;
  std::optional<std::string> vehicle;
  std::vector<std::string> missions;
  std::optional<std::string> currents;
  std::optional<std::string> bathymetry;
  std::optional<std::string> ice;
  std::optional<std::string> icebergs;
  std::optional<std::string> name;
  bool no_avoidance{false};
  std::size_t workers{std::max(1U, std::thread::hardware_concurrency())};
  std::optional<std::filesystem::path> out;
  bool force{false};
  bool json_out{false};
};

const std::vector<InputFlag> input_flags{{"/plan_id", "PLAN"},
                                         {"/runs", "--runs"},
                                         {"/seed", "--seed"},
                                         {"/tracks", "--tracks"},
                                         {"/vehicle", "--vehicle"},
                                         {"/record_every_s", "--record-every"},
                                         {"/currents", "--currents"},
                                         {"/bathymetry", "--bathymetry"},
                                         {"/ice", "--ice"},
                                         {"/icebergs", "--icebergs"},
                                         {"/name", "--name"},
                                         {"/avoidance", "--no-avoidance"},
                                         {"/current_error/rms_m_s", "--current-error"},
                                         {"/mission_files", "--mission"}};

template <class Value>
void set(json& inputs, const char* key, const std::optional<Value>& value) {
  if (value) inputs[key] = *value;
}

/// The inputs in the request file, with members replaced by flags.
json inputs_of(const SimulateFlags& flags) {
  json inputs = flags.request_file ? read_object(*flags.request_file, "request file") : json::object();
  inputs["plan_id"] = flags.plan_id;
  set(inputs, "runs", flags.runs);
  set(inputs, "seed", flags.seed);
  set(inputs, "tracks", flags.tracks);
  set(inputs, "vehicle", flags.vehicle);
  set(inputs, "record_every_s", flags.record_every_s);
  set(inputs, "currents", flags.currents);
  set(inputs, "bathymetry", flags.bathymetry);
  set(inputs, "ice", flags.ice);
  set(inputs, "icebergs", flags.icebergs);
  set(inputs, "name", flags.name);
  if (flags.no_avoidance) inputs["avoidance"] = false;
  // If the request file has a member of another type, it stays, so that the check of all inputs refuses it.
  if (json& error = inputs["current_error"];
      flags.current_error_m_s && (error.is_null() || error.is_object()))
    error["rms_m_s"] = *flags.current_error_m_s;
  if (json& files = inputs["mission_files"]; files.is_null() || files.is_array())
    for (const std::string& file : flags.missions) files.push_back(file_member(file));
  return inputs;
}

void print_distribution(const char* what, const json& distribution, double unit, const char* unit_name) {
  if (distribution.is_null()) return;
  std::printf("%-24s", what);
  for (const json& quantile : distribution.at("quantiles"))
    std::printf(" %9.2f", quantile.at("value").get<double>() / unit);
  std::printf("  %s\n", unit_name);
}

void print_statistics(const json& document) {
  const json& statistics = document.at("statistics");
  for (const json& end : statistics.at("ends")) {
    const json& interval = end.at("share_interval_95");
    std::printf("%-24s %9d  %5.1f %% (95 %% confidence: %.1f to %.1f)\n",
                end.at("end").get<std::string>().c_str(), end.at("runs").get<int>(),
                100.0 * end.at("share").get<double>(), 100.0 * interval[0].get<double>(),
                100.0 * interval[1].get<double>());
  }
  std::printf("%-24s %9s %9s %9s %9s %9s\n", "quantiles", "5 %", "25 %", "50 %", "75 %", "95 %");
  print_distribution("travel time, arrived", statistics.at("travel_time_s"), 3600.0, "h");
  print_distribution("position error, end", statistics.at("final_position_error_m"), 1.0, "m");
  print_distribution("position error, worst", statistics.at("worst_position_error_m"), 1.0, "m");
  print_distribution("clearance", statistics.at("clearance_m"), 1.0, "m");
  print_distribution("energy, arrived", statistics.at("energy_j"), 1000.0, "kJ");
  if (const json& detour = document.at("median_detour_pct"); !detour.is_null())
    std::printf("median detour %.1f %%\n", detour.get<double>());
  std::printf("simulated %.0f times faster than real time\n", document.at("real_time_factor").get<double>());
}

void print_listed(const char* what, const json& runs) {
  for (const json& run : runs) {
    std::printf("%s: run %d, seed %s: %s\n", what, run.at("run").get<int>(),
                run.at("seed").get<std::string>().c_str(), run.at("why").get<std::string>().c_str());
  }
}

/// Prints the flights that did not arrive; at most twenty, to fit on a screen.
void print_not_there(const json& flights) {
  constexpr int most_told = 20;
  int told = 0;
  for (const json& flight : flights) {
    if (flight.at("why").is_null() || told++ >= most_told) continue;
    const json& saved = flight.at("could_be_saved");
    std::printf("not there: run %d: %s%s\n", flight.at("run").get<int>(),
                flight.at("why").get<std::string>().c_str(),
                saved == false ? " Full knowledge could not have saved it." : "");
  }
  if (told > most_told) std::printf("and %d more; --json lists all\n", told - most_told);
}

void print_simulate_table(const json& document) {
  std::printf("simulation %s of plan %s: %s, seed %s, obstacle avoidance %s\n",
              document.at("simulation_id").get<std::string>().c_str(),
              document.at("plan_id").get<std::string>().c_str(),
              core::counted(document.at("runs").get<std::size_t>(), "run").c_str(),
              document.at("seed").get<std::string>().c_str(),
              document.at("avoidance").get<bool>() ? "on" : "off");
  print_statistics(document);
  print_not_there(document.at("flights"));
  std::printf("planned travel time %s\n",
              core::hours_minutes(core::Seconds{document.at("planned_travel_time_s").get<double>()}).c_str());
  print_messages(document);
}

/// Simulated time of all runs divided by the time that the simulation took.
double real_time_factor(const json& document, std::chrono::steady_clock::time_point begin) {
  double simulated_s = 0.0;
  for (const json& flight : document.at("flights")) simulated_s += flight.at("travel_time_s").get<double>();
  const core::Seconds took = std::chrono::steady_clock::now() - begin;
  return std::round(simulated_s / std::max(1e-3, took.count()));
}

int write_files(sql::Connection& db, const json& document, const SimulateFlags& flags) {
  const std::string id = document.at("simulation_id").get<std::string>();
  const auto record = repository::SimulationRepository{db}.find({id});
  std::vector<OutputFile> files;
  for (const auto& format : routes::simulation_formats())
    files.push_back({id + "." + format.name, *routes::export_simulation(db, *record, format, {})});
  if (const auto there = first_existing(*flags.out, files); there && !flags.force)
    return complain<"flight-file-exists">(could_not, there->string());
  for (const auto& file : write_set(*flags.out, files)) std::cerr << "wrote " << file.string() << '\n';
  return done;
}

bool was_interrupted(const json& document) { return document.value("status", "") == "cancelled"; }

int complain_of_interruption() { return complain<"flights-interrupted">(could_not); }

int run_simulate(const SimulateFlags& flags, const Program& program) {
  const auto inputs = codec::parse_simulate_inputs(inputs_of(flags));
  if (!inputs) return print_violations(inputs.error(), flags.json_out, input_flags);
  if (flags.out && inputs->tracks == 0) throw flag_fault<"no-flights-to-write">("--out");

  auto db = open_existing_store(program);
  if (!repository::PlanRepository{db}.find({inputs->plan_id})) return complain_of_no_plan(inputs->plan_id);
  const auto begin = std::chrono::steady_clock::now();
  const Interruption interruption;
  auto document = service::simulate_plan_document(db, *inputs, service::Threads{flags.workers},
                                                  interruption.token(), terminal_progress(), now());
  if (!document) return print_violations(document.error(), flags.json_out, input_flags);
  if (was_interrupted(*document)) return complain_of_interruption();
  (*document)["real_time_factor"] = real_time_factor(*document, begin);
  if (flags.json_out) {
    std::cout << document->dump(2) << '\n';
  } else {
    print_simulate_table(*document);
  }
  return flags.out ? write_files(db, *document, flags) : done;
}

int run_scenario(const SimulateFlags& flags) {
  const codec::ScenarioInputs asked{.scenario = flags.scenario,
                                    .runs = flags.runs.value_or(1),
                                    .seed = static_cast<std::uint64_t>(flags.seed.value_or(1)),
                                    .avoidance = !flags.no_avoidance};
  const auto begin = std::chrono::steady_clock::now();
  const Interruption interruption;
  json document = service::fly_scenario_document(asked, service::Threads{flags.workers}, interruption.token(),
                                                 terminal_progress());
  if (was_interrupted(document)) return complain_of_interruption();
  document["real_time_factor"] = real_time_factor(document, begin);
  if (flags.json_out) {
    std::cout << document.dump(2) << '\n';
    return done;
  }
  std::printf("%s: %s, seed %s, obstacle avoidance %s\n", flags.scenario.c_str(),
              core::counted(static_cast<std::size_t>(asked.runs), "run").c_str(),
              document.at("seed").get<std::string>().c_str(), asked.avoidance ? "on" : "off");
  print_statistics(document);
  print_listed("lost even with full knowledge", document.at("runs_beyond_help"));
  print_listed("not there", document.at("runs_given_up"));
  return done;
}

}  // namespace

void add_simulate(CLI::App& app, Program& program) {
  auto flags = std::make_shared<SimulateFlags>();
  auto* command = app.add_subcommand("simulate", "Fly a stored plan in the test bed, once or many times");
  command->add_option("PLAN", flags->plan_id, "The plan's id");
  command
      ->add_option("--scenario", flags->scenario,
                   "Instead of a plan: random-icebergs, 5 km through unknown icebergs; works with "
                   "--runs, --seed, "
                   "--no-avoidance, --workers and --json")
      ->check(CLI::IsMember({codec::random_icebergs}));
  command->add_option("--request", flags->request_file,
                      "JSON file with inputs of the process simulate-plan, also those without a flag; for "
                      "example request.json");
  command->add_option("--runs", flags->runs, "Flights, each with errors and icebergs of its own; default 1")
      ->check(CLI::Range(1, codec::most_runs));
  command
      ->add_option("--seed", flags->seed,
                   "Seed of all random numbers; the same seed gives the same flights; default 1")
      ->check(CLI::Range(0, 2'000'000'000));
  command->add_option("--tracks", flags->tracks, "Flights to keep whole, the first ones; default 10");
  command->add_option("--current-error", flags->current_error_m_s,
                      "Error of the currents, m/s rms of each component; default 0");
  command->add_flag("--no-avoidance", flags->no_avoidance,
                    "Without sonar, ADCP and the obstacle avoidance system on board");
  command
      ->add_option("--mission", flags->missions,
                   "Mission file to fly instead of the exported plan, for example plan.mi; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--vehicle", flags->vehicle,
                      "Refuse a plan for another vehicle than this, for example slocum-g3-200");
  command->add_option("--currents", flags->currents,
                      "True currents: an id, newest or none; default the plan's choice");
  command->add_option("--bathymetry", flags->bathymetry,
                      "Sea bed: an id, newest or none; default the plan's choice");
  command->add_option("--ice", flags->ice, "Sea ice: an id, newest or none; default the plan's choice");
  command->add_option("--icebergs", flags->icebergs,
                      "Icebergs: an id, newest or none; default the plan's choice");
  command->add_option("--record-every", flags->record_every_s,
                      "Seconds between two points of a track; default 60");
  command->add_option("--name", flags->name, "Name of the simulation, for example \"second try\"");
  command->add_option("--workers", flags->workers, "Flights at the same time; does not change the result")
      ->check(CLI::Range(1, 256));
  command->add_option("--out", flags->out, "Folder to write the kept flights into, as NetCDF and GeoJSON");
  command->add_flag("--force", flags->force, "Replace files that exist");
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] {
    if (flags->plan_id.empty() == flags->scenario.empty()) throw flag_fault<"plan-or-scenario">("simulate");
    program.exit_code = flags->scenario.empty() ? run_simulate(*flags, program) : run_scenario(*flags);
  });
}

}  // namespace floeplan::cli
