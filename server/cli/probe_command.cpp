#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <vector>

#include "api/service/probe_service.hpp"
#include "engine/core/shown_text.hpp"
#include "engine/core/utc_text.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/flag_values.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

struct ProbeFlags {
  std::string at;
  std::optional<std::string> time;
  std::optional<double> depth_m;
  std::vector<std::string> datasets;
  bool json_out{false};
};

void print_probe(const codec::Probe& probe) {
  std::cout << std::fixed << std::setprecision(4) << "place     " << probe.place.lon_deg << ", "
            << probe.place.lat_deg << " at " << core::iso8601(probe.time) << '\n';
  if (probe.depth) {
    std::cout << "depth     " << std::setprecision(1) << probe.depth->value << " m";
    if (probe.shoalest_depth && probe.shoalest_depth->value < probe.depth->value)
      std::cout << ", " << probe.shoalest_depth->value << " m at the shoalest around";
    std::cout << '\n';
  } else {
    std::cout << "depth     - (" << probe.depth_reason << ")\n";
  }
  if (!probe.coastline.empty())
    std::cout << "land      the coastline " << probe.coastline << " has land here, so plans do not pass\n";
  if (probe.currents.velocity) {
    std::cout << std::setprecision(3) << "current   " << probe.currents.velocity->east.value << " m/s east, "
              << probe.currents.velocity->north.value << " m/s north (" << probe.currents.dataset_name
              << (probe.currents.run ? ", run of " + core::iso8601(*probe.currents.run) : "") << ")\n";
  } else {
    std::cout << "current   - (" << probe.currents.reason << ")\n";
  }
  if (probe.wind.velocity) {
    const geo::VelocityEn& wind = *probe.wind.velocity;
    std::cout << std::setprecision(1) << "wind      " << geo::strength(wind).value << " m/s, "
              << wind.east.value << " east, " << wind.north.value << " north (" << probe.wind.dataset_name
              << ")\n";
  } else {
    std::cout << "wind      - (" << probe.wind.reason << ")\n";
  }
  if (probe.ice.state) {
    std::cout << std::setprecision(2) << "sea ice   " << probe.ice.state->concentration << " covered";
    if (probe.ice.state->thickness) std::cout << ", " << probe.ice.state->thickness->value << " m thick";
    std::cout << " (" << probe.ice.dataset_name << ")\n";
  } else {
    std::cout << "sea ice   - (" << probe.ice.reason << ")\n";
  }
  const codec::Probe::Tide& tide = probe.tide;
  if (tide.elevation)
    std::cout << std::setprecision(3) << "tide      " << tide.elevation->value << " m above the mean"
              << (tide.station.empty() ? "" : " (" + tide.station + ")") << '\n';
  if (tide.velocity)
    std::cout << std::setprecision(3) << "tide      " << tide.velocity->east.value << " m/s east, "
              << tide.velocity->north.value << " m/s north\n";
  if (!tide.reason.empty()) std::cout << "tide      - (" << tide.reason << ")\n";
  if (const codec::Probe::WaterLevel& level = probe.water_level; level.height) {
    std::cout << std::setprecision(2) << "water     " << std::abs(level.height->value) << " m "
              << (level.height->value < 0.0 ? "below" : "above") << " the datum (" << level.datum << ") by "
              << level.dataset_name << (level.station.empty() ? "" : ", " + level.station) << '\n';
  }
  for (const auto& near : probe.icebergs) {
    std::cout << "iceberg   " << near.iceberg.id << ", " << core::distance_text(near.distance)
              << " away, seen " << core::iso8601(near.iceberg.observed) << '\n';
  }
  for (const auto& here : probe.zones) {
    const ocean::Zone& zone = here.zone;
    std::cout << "zone      " << (zone.name.empty() ? "without a name" : zone.name) << ", "
              << ocean::zone_kind_name(zone.kind) << (here.in_force ? ", in force" : ", not in force now")
              << (zone.from ? ", from " + core::iso8601(*zone.from) : "")
              << (zone.until ? ", until " + core::iso8601(*zone.until) : "") << " (" << here.dataset_name
              << ")\n";
  }
}

int run_probe(const ProbeFlags& flags, const Program& program) {
  const auto place = parse_place(flags.at);
  if (!place) throw flag_fault<"not-lon-lat">("--at", flags.at, "--at");
  if (!geo::is_valid(*place)) return complain<"not-on-earth">(bad_data, flags.at);
  service::ProbeQuery query{.place = *place, .time = now(), .depth = {}, .dataset_ids = flags.datasets};
  if (flags.time) {
    const auto time = core::parse_iso8601(*flags.time);
    if (!time) throw flag_fault<"no-moment">("--time", *flags.time);
    query.time = *time;
  }
  if (flags.depth_m) query.depth = core::Metres{*flags.depth_m};

  auto db = open_existing_store(program);
  const auto probe = service::probe(db, query);
  if (!probe) return complain(bad_data, probe.error());
  if (flags.json_out) {
    std::cout << codec::probe_document(*probe).dump(2) << '\n';
  } else {
    print_probe(*probe);
  }
  return done;
}

}  // namespace

void add_probe(CLI::App& app, Program& program) {
  auto flags = std::make_shared<ProbeFlags>();
  auto* command = app.add_subcommand(
      "probe",
      "Show depth, current, tide, water level, wind, sea ice, icebergs and zones at a place and a time");
  command->add_option("--at", flags->at, "Longitude and latitude in degrees; for example --at=-53.20,69.20")
      ->required();
  command->add_option("--time", flags->time,
                      "Time, ISO 8601 with its zone, for example 2026-11-20T06:00:00Z; default: now");
  command->add_option("--depth", flags->depth_m,
                      "Depth of the current, metres below the surface; for example 50");
  command
      ->add_option("--dataset", flags->datasets,
                   "Dataset to ask of its kind, may be repeated; default: the newest that covers it")
      ->allow_extra_args(false);
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = run_probe(*flags, program); });
}

}  // namespace floeplan::cli
