#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/core/utc_text.hpp"
#include "engine/simulation/segment_comparison.hpp"
#include "server/cli/command.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;
using simulation::Compared;
using simulation::LoggedSegment;
using simulation::SegmentComparison;

struct Flags {
  std::vector<std::string> files;
  std::string vehicle{"slocum-g3-200"};
  std::string drag{"log"};
  bool json_out{false};
};

/// A dive of a file with its simulation.
struct Dive {
  std::string file;
  LoggedSegment logged;
  SegmentComparison compared;
};

core::Violations within_file(const std::string& file, core::Violations found) {
  for (core::Violation& violation : found) violation.field = file + violation.field;
  return found;
}

tl::expected<std::string, core::Violations> text_of(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || !text)
    return tl::unexpected(core::Violations{{file, "cannot be read; check its name and rights"}});
  return std::move(text).str();
}

void compare_file(const std::string& file, const Flags& flags, const vehicle::GliderProfile& vehicle,
                  std::vector<Dive>& dives, core::Violations& found) {
  const auto add = [&](core::Violations faults) { found.insert(found.end(), faults.begin(), faults.end()); };
  const auto text = text_of(file);
  if (!text) return add(text.error());
  const auto segments = simulation::read_glider_log(*text);
  if (!segments) return add(within_file(file, segments.error()));
  const auto drag = flags.drag == "log" ? simulation::DragOf::log : simulation::DragOf::profile;
  for (const LoggedSegment& segment : *segments) {
    const auto compared =
        simulation::compare_segment(segment, vehicle, simulation::hull_motion_for(vehicle), drag);
    if (!compared) {
      add(within_file(file, compared.error()));
    } else {
      dives.push_back({.file = file, .logged = segment, .compared = *compared});
    }
  }
}

std::vector<SegmentComparison> comparisons_of(const std::vector<Dive>& dives) {
  std::vector<SegmentComparison> comparisons;
  for (const Dive& dive : dives) comparisons.push_back(dive.compared);
  return comparisons;
}

void print_row(const char* what, const Compared& compared, int digits, const char* unit) {
  std::printf("  %-22s %10.*f %10.*f %-4s %+6.1f %%\n", what, digits, compared.logged, digits,
              compared.simulated, unit, 100.0 * compared.deviation_share());
}

void print(const std::vector<Dive>& dives) {
  for (const Dive& dive : dives) {
    const SegmentComparison& compared = dive.compared;
    std::printf("%s, dive of %s\n  %-22s %10s %10s\n", dive.file.c_str(),
                core::iso8601(dive.logged.dived).c_str(), "", "logged", "simulated");
    print_row("time under water", compared.under_water_s, 0, "s");
    print_row("dives", compared.dives, 0, "");
    print_row("speed through water", compared.speed_m_s, 3, "m/s");
    print_row("way over ground", compared.over_ground_m, 0, "m");
    std::printf("  %-22s %21.0f %-4s %6.1f %%\n", "positions apart", compared.apart_m, "m",
                100.0 * compared.apart_share);
    std::printf("  flown with a parasite drag of %.3f and a trim of %+.0f cm3\n", compared.parasite_drag,
                1e6 * dive.logged.trim().value);
  }
  const simulation::ComparisonSummary summary = simulation::summary_of(comparisons_of(dives));
  std::printf("median of %zu dives: time %.1f %%, dives %.1f %%, speed %.1f %%, position %.1f %%: %s\n",
              dives.size(), 100.0 * summary.under_water_share, 100.0 * summary.dives_share,
              100.0 * summary.speed_share, 100.0 * summary.apart_share,
              summary.within_a_tenth() ? "within a tenth" : "not within a tenth");
}

json pair_of(const Compared& compared) {
  return {{"logged", compared.logged},
          {"simulated", compared.simulated},
          {"deviation_pct", 100.0 * compared.deviation_share()}};
}

json document(const std::vector<Dive>& dives) {
  json listed = json::array();
  for (const Dive& dive : dives) {
    const SegmentComparison& compared = dive.compared;
    listed.push_back({{"file", dive.file},
                      {"dived", core::iso8601(dive.logged.dived)},
                      {"under_water_s", pair_of(compared.under_water_s)},
                      {"dives", pair_of(compared.dives)},
                      {"speed_through_water_m_s", pair_of(compared.speed_m_s)},
                      {"over_ground_m", pair_of(compared.over_ground_m)},
                      {"positions_apart_m", compared.apart_m},
                      {"positions_apart_pct", 100.0 * compared.apart_share},
                      {"parasite_drag", compared.parasite_drag},
                      {"trim_cm3", 1e6 * dive.logged.trim().value}});
  }
  const simulation::ComparisonSummary summary = simulation::summary_of(comparisons_of(dives));
  return {{"dives", listed},
          {"median",
           {{"under_water_pct", 100.0 * summary.under_water_share},
            {"dives_pct", 100.0 * summary.dives_share},
            {"speed_pct", 100.0 * summary.speed_share},
            {"positions_apart_pct", 100.0 * summary.apart_share},
            {"within_a_tenth", summary.within_a_tenth()}}}};
}

int run(const Flags& flags) {
  const auto vehicle = vehicle::find_profile(flags.vehicle);
  if (!vehicle) {
    std::string known;
    for (const auto& profile : vehicle::known_profiles()) known += (known.empty() ? "" : ", ") + profile.name;
    return complain(bad_data, "--vehicle " + flags.vehicle + " is not known; use " + known);
  }
  std::vector<Dive> dives;
  core::Violations found;
  for (const std::string& file : flags.files) compare_file(file, flags, *vehicle, dives, found);
  if (!found.empty()) complain(bad_data, found);
  if (dives.empty()) return bad_data;
  if (flags.json_out) {
    std::cout << document(dives).dump(2, ' ', false, json::error_handler_t::replace) << '\n';
  } else {
    print(dives);
  }
  return found.empty() ? done : bad_data;
}

}  // namespace

void add_compare_flight(CLI::App& app, Program& program) {
  auto flags = std::make_shared<Flags>();
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
                   "Whose drag to fly with: fitted to the log's own rates of depth, or the vehicle profile's")
      ->check(CLI::IsMember({"log", "profile"}))
      ->capture_default_str();
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = run(*flags); });
}

}  // namespace floeplan::cli
