#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <utility>

#include "api/codec/documents/flight_comparison.hpp"
#include "api/service/comparison_service.hpp"
#include "engine/core/shown_text.hpp"
#include "engine/core/utc_text.hpp"
#include "server/cli/program/command.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;
using simulation::Compared;
using simulation::SegmentComparison;

struct CompareFlightFlags {
  std::vector<std::string> files;
  std::string vehicle{codec::usual_compared_vehicle};
  std::string drag{"log"};
  bool json_out{false};
};

tl::expected<std::string, core::Violations> text_of(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || !text)
    return tl::unexpected(
        core::Violations{messages::violation_of(file, messages::command_message<"log-not-readable">())});
  return std::move(text).str();
}

/// Reads the dives in a file.
tl::expected<codec::GliderLog, core::Violations> read_log(const std::string& file) {
  const auto text = text_of(file);
  if (!text) return tl::unexpected(text.error());
  auto dives = simulation::read_glider_log(*text);
  if (dives) return codec::GliderLog{.name = file, .dives = std::move(*dives)};
  for (core::Violation& violation : dives.error()) violation.field = file + violation.field;
  return tl::unexpected(std::move(dives.error()));
}

void print_compared(const char* what, const Compared& compared, int digits, const char* unit) {
  std::printf("  %-22s %10.*f %10.*f %-4s %+6.1f %%\n", what, digits, compared.logged, digits,
              compared.simulated, unit, 100.0 * compared.deviation_share());
}

void print_dives(const std::vector<codec::ComparedDive>& dives) {
  for (const codec::ComparedDive& dive : dives) {
    const SegmentComparison& compared = dive.compared;
    std::printf("%s, dive of %s\n  %-22s %10s %10s\n", dive.file.c_str(),
                core::iso8601(dive.logged.dived).c_str(), "", "logged", "simulated");
    print_compared("time under water", compared.under_water_s, 0, "s");
    print_compared("dives", compared.dives, 0, "");
    print_compared("speed through water", compared.speed_m_s, 3, "m/s");
    print_compared("distance over ground", compared.over_ground_m, 0, "m");
    std::printf("  %-22s %21.0f %-4s %6.1f %%\n", "positions apart", compared.apart_m, "m",
                100.0 * compared.apart_share);
    std::printf("  flown with a parasite drag of %.3f and a trim of %+.0f cm3\n", compared.parasite_drag,
                1e6 * dive.logged.trim().value);
    std::printf("  currents turned from %s\n", ocean::words_of(dive.logged.turned_from).c_str());
    if (!dive.logged.positions_read.empty()) std::printf("  %s\n", dive.logged.positions_read.c_str());
  }
  const simulation::ComparisonSummary summary = codec::summary_of(dives);
  std::printf("median of %s: time %.1f %%, dives %.1f %%, speed %.1f %%, position %.1f %%: %s\n",
              core::counted(dives.size(), "dive").c_str(), 100.0 * summary.under_water_share,
              100.0 * summary.dives_share, 100.0 * summary.speed_share, 100.0 * summary.apart_share,
              summary.within_a_tenth() ? "within a tenth" : "not within a tenth");
}

int run_compare_flight(const CompareFlightFlags& flags) {
  const auto vehicle = codec::compared_vehicle(flags.vehicle);
  if (!vehicle) return complain(bad_data, "--vehicle " + vehicle.error().rule);
  const auto drag = flags.drag == "log" ? simulation::DragOf::log : simulation::DragOf::profile;
  std::vector<codec::GliderLog> logs;
  core::Violations found;
  for (const std::string& file : flags.files) {
    auto log = read_log(file);
    if (log) {
      logs.push_back(std::move(*log));
    } else {
      found.insert(found.end(), log.error().begin(), log.error().end());
    }
  }
  const service::ComparedFlights compared = service::compare_flights(logs, *vehicle, drag);
  found.insert(found.end(), compared.violations.begin(), compared.violations.end());
  if (!found.empty()) complain(bad_data, found);
  if (compared.dives.empty()) return bad_data;
  if (flags.json_out) {
    std::cout
        << codec::comparison_document(compared.dives).dump(2, ' ', false, json::error_handler_t::replace)
        << '\n';
  } else {
    print_dives(compared.dives);
  }
  return found.empty() ? done : bad_data;
}

}  // namespace

void add_compare_flight(CLI::App& app, Program& program) {
  auto flags = std::make_shared<CompareFlightFlags>();
  auto* command = app.add_subcommand(
      "compare-flight", "Fly the dives of a Slocum's log again in the simulator and set both side by side");
  command
      ->add_option(
          "FILE", flags->files,
          "Logs as text: of dbd2asc, or with commas: a line of sensor names, a line of units, rows by time")
      ->required();
  command->add_option("--vehicle", flags->vehicle, "Kind of the vehicle")->capture_default_str();
  command
      ->add_option("--drag", flags->drag,
                   "Drag: log, fitted to the vertical speeds of the log, or profile, that of the vehicle")
      ->check(CLI::IsMember({"log", "profile"}))
      ->capture_default_str();
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = run_compare_flight(*flags); });
}

}  // namespace floeplan::cli
