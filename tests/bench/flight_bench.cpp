#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "api/service/threads.hpp"
#include "engine/planning/plane/plane_box.hpp"
#include "engine/simulation/flight/equipped_vehicle.hpp"
#include "engine/simulation/flight/random_icebergs.hpp"
#include "tests/bench/benchmarks.hpp"

namespace floeplan::bench {
namespace {

using namespace simulation;

constexpr core::UtcTime departure = core::from_unix_seconds(1.7e9);
constexpr geo::LonLat start{-52.0, 47.5};
constexpr std::uint64_t fields = 4;
constexpr double wanted = 2000.0;
constexpr unsigned most_workers = 8;  // more would only take longer alone
constexpr std::size_t runs_for_each_worker = 4;
constexpr double least_share_of_cores = 0.8;

/// A route of 5 km over hills between 65 and 135 m deep, always within range of the sonar.
IcebergField bank() {
  IcebergFieldSettings settings;
  settings.km2_for_each = 1e6;  // no icebergs
  settings.dive_depth = core::Metres{100.0};
  IcebergField field = random_icebergs(settings, start, departure, 1);
  std::vector<double> lon;
  std::vector<double> lat;
  std::vector<float> depth_m;
  for (int i = 0; i <= 60; ++i) {
    lon.push_back(start.lon_deg - 0.3 + 0.01 * i);
    lat.push_back(start.lat_deg - 0.3 + 0.01 * i);
  }
  for (const double y : lat) {
    for (const double x : lon)
      depth_m.push_back(static_cast<float>(100.0 + 30.0 * std::sin(60.0 * y) * std::cos(70.0 * x) +
                                           5.0 * std::sin(400.0 * x + 300.0 * y)));
  }
  const auto bathymetry = std::make_shared<const ocean::Bathymetry>(
      ocean::HorizontalGrid{geo::GridFrame{}, ocean::Axis{lon}, ocean::Axis{lat}}, depth_m);
  WorldParts parts{.origin = start};
  parts.bed = SeaBed{bathymetry, geo::LocalProjection{start},
                     planning::plane::PlaneBox{{-15'000.0, -15'000.0}, {15'000.0, 15'000.0}}};
  return {World{std::move(parts)}, field.orders, field.vehicle, {}};
}

/// Simulated duration of a flight in its sea; a contact does not end it.
template <class OnBoardFor>
core::Seconds flown_through(const IcebergField& sea, std::uint64_t seed, const OnBoardFor& on_board_for) {
  FlightRequest request{.world = sea.world,
                        .orders = sea.orders,
                        .vehicle = sea.vehicle,
                        .start = start,
                        .departure = departure,
                        .settings = {},
                        .seed = seed};
  request.settings.ends_at_contact = false;
  request.settings.longest = longest_flight({}, sea.vehicle);
  auto on_board = on_board_for(request);
  return fly(request, on_board).duration();
}

/// Elapsed time while this number of workers simulate each sea a few times.
template <class OnBoardFor>
double seconds_passed(std::size_t workers, std::size_t runs, const std::vector<IcebergField>& seas,
                      const OnBoardFor& on_board_for) {
  const auto begin = std::chrono::steady_clock::now();
  service::Threads{workers}.run(
      runs, [&](std::size_t run, bool) { (void)flown_through(seas[run % seas.size()], run, on_board_for); });
  return core::Seconds{std::chrono::steady_clock::now() - begin}.count();
}

/// A Monte-Carlo batch on all cores compared with one worker, in elapsed time; other programs on the machine
/// slow it down.
template <class OnBoardFor>
Row scaling_row(const std::vector<IcebergField>& seas, const OnBoardFor& on_board_for) {
  const std::size_t workers = std::clamp(std::thread::hardware_concurrency(), 1U, most_workers);
  const std::size_t runs = runs_for_each_worker * workers;
  const double alone_s = seconds_passed(1, runs, seas, on_board_for);
  const double together_s = seconds_passed(workers, runs, seas, on_board_for);
  Row row = less_is_better("batch of flights on " + std::to_string(workers) + " workers", "s", together_s,
                           "one worker", alone_s);
  const double least = least_share_of_cores * static_cast<double>(workers);
  row.meets_target = row.ratio >= least;
  row.target = "four fifths of the cores";
  return row;
}

/// Ratio of simulated time to processor time, over all fields.
template <class OnBoardFor>
Row row_of(std::string what, const std::vector<IcebergField>& seas, const OnBoardFor& on_board_for) {
  core::Seconds flown{};
  const double seconds = least_seconds(2, [&] {
    flown = core::Seconds{0.0};
    for (std::uint64_t i = 0; i < seas.size(); ++i) flown += flown_through(seas[i], i, on_board_for);
  });
  if (flown < core::Seconds{3600.0} * static_cast<double>(seas.size()))
    throw std::runtime_error{"the flights of the benchmark ended early"};
  Row row{.what = std::move(what), .unit = "x real time", .ours = flown.count() / seconds, .comparator = {}};
  row.target = ">= 2000";
  row.meets_target = row.ours >= wanted;
  row.gauge = Gauge::rate;
  return row;
}

}  // namespace

std::vector<Row> flight_rows() {
  std::vector<IcebergField> seas;
  for (std::uint64_t seed = 1; seed <= fields; ++seed)
    seas.push_back(random_icebergs({}, start, departure, seed));
  std::vector<IcebergField> over_bank;
  over_bank.push_back(bank());
  const Equipment equipment;
  const auto bare = [](const FlightRequest&) { return BareVehicle{}; };
  const auto equipped = [&](const FlightRequest& request) {
    SystemOnBoard system =
        system_for(request.world, request.orders, start, departure, request.settings.longest);
    system.settings = avoidance_for(request.vehicle, request.orders, equipment.sonar.settings());
    return EquippedVehicle{equipment, request.world, request.seed, std::move(system)};
  };
  return {row_of("flights through random icebergs, no sonar", seas, bare),
          row_of("the same with sonar at 1 Hz, ADCP and avoidance", seas, equipped),
          row_of("over a bank, with sonar at 1 Hz, ADCP and avoidance", over_bank, equipped),
          scaling_row(seas, equipped)};
}

}  // namespace floeplan::bench
