#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/equipped_vehicle.hpp"
#include "engine/simulation/random_icebergs.hpp"
#include "tests/bench/benchmarks.hpp"

namespace floeplan::bench {
namespace {

using namespace simulation;

constexpr core::UtcTime departure = core::from_unix_seconds(1.7e9);
constexpr geo::LonLat start{-52.0, 47.5};
constexpr std::uint64_t fields = 4;
constexpr double wanted = 2000.0;

/// Simulated time over processor time, all fields together; a contact does not end a flight.
template <class OnBoardFor>
Row row_of(std::string what, const std::vector<IcebergField>& seas, const OnBoardFor& on_board_for) {
  core::Seconds flown{};
  const double seconds = least_seconds(2, [&] {
    flown = core::Seconds{0.0};
    for (std::uint64_t i = 0; i < seas.size(); ++i) {
      FlightRequest request{.world = seas[i].world,
                            .orders = seas[i].orders,
                            .vehicle = seas[i].vehicle,
                            .start = start,
                            .departure = departure,
                            .settings = {},
                            .seed = i};
      request.settings.ends_at_contact = false;
      request.settings.longest = longest_flight({}, seas[i].vehicle);
      auto on_board = on_board_for(request);
      flown += fly(request, on_board).duration();
    }
  });
  if (flown < core::Seconds{3600.0} * static_cast<double>(seas.size()))
    throw std::runtime_error{"the flights of the benchmark ended early"};
  Row row{.what = std::move(what), .unit = "x real time", .ours = flown.count() / seconds, .comparator = {}};
  row.target = ">= 2000";
  row.meets_target = row.ours >= wanted;
  return row;
}

}  // namespace

std::vector<Row> flight_rows() {
  std::vector<IcebergField> seas;
  for (std::uint64_t seed = 1; seed <= fields; ++seed)
    seas.push_back(random_icebergs({}, start, departure, seed));
  const Equipment equipment;
  const auto bare = [](const FlightRequest&) { return BareVehicle{}; };
  const auto equipped = [&](const FlightRequest& request) {
    return EquippedVehicle{
        equipment, request.world, request.seed,
        system_for(request.world, request.orders, start, departure, request.settings.longest)};
  };
  return {row_of("flights through random icebergs, no sonar", seas, bare),
          row_of("the same with sonar at 1 Hz, ADCP and avoidance", seas, equipped)};
}

}  // namespace floeplan::bench
