#include "api/codec/exports/simulation_exports.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "api/codec/bytes/netcdf_classic.hpp"
#include "api/codec/documents/flight_document.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::codec::simulation_exports_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

simulation::FlightRecord flight(std::uint64_t seed, double east_m) {
  simulation::FlightRecord record;
  record.seed = seed;
  record.end = simulation::FlightEnd::arrived;
  record.departure = core::from_unix_seconds(1'795'200'000.0);
  record.finished = record.departure + core::Seconds{7200.0};
  for (int i = 0; i < 3; ++i) {
    simulation::TrackPoint point;
    point.time = record.departure + core::Seconds{3600.0 * i};
    point.position = {east_m * i, 100.0 * i, 12.345678 * i};
    point.believed = point.position + simulation::Vector{5.0 * i, 0.0, 0.0};
    point.attitude.heading_rad = -0.1;
    point.mode = i == 1 ? avoidance::Mode::given_up : avoidance::Mode::mission;
    point.at_surface = i == 0;
    record.track.push_back(point);
  }
  record.events.push_back({record.departure, simulation::EventKind::departure, {}, ""});
  record.approaches.push_back({"sea bed", 33.333, record.finished, {east_m, 0.0, 10.0}});
  record.sensors.sonar.push_back({record.departure, 3, 55.5});
  return record;
}

json simulation_of() { return {{"simulation_id", "s0123"}, {"plan_id", "p4567"}, {"seed", "7"}}; }

std::vector<json> flights(geo::LonLat origin = {-53.0, 69.0}) {
  const geo::LocalProjection projection{origin};
  return {flight_document(flight(1, 1000.0), projection, 0),
          flight_document(flight(2, -900.0), projection, 1)};
}

std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 4096> part{};
  while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe))
    text.append(part.data(), read);
  pclose(pipe);
  return text;
}

TEST(FlightDocument, RoundsToWhatItsNumbersCanMean) {
  const json document = flights().front();

  EXPECT_EQ(document.at("track").at("depth_m"), json::parse("[0.0, 12.35, 24.69]"));
  EXPECT_EQ(document.at("track").at("heading_deg").front(), 354.27);
  EXPECT_EQ(document.at("track").at("time_s"), json::parse("[0.0, 3600.0, 7200.0]"));
  EXPECT_EQ(document.at("track").at("lon").front(), -53.0);
  EXPECT_EQ(document.at("approaches")[0].at("distance_m"), 33.33);
  EXPECT_EQ(document.at("sensors").at("sonar").at("returns"), json::parse("[3]"));
  EXPECT_EQ(document.at("sensors").at("altimeter").at("altitude_m"), json::array());
}

TEST(SimulationNetcdf, IsReadByTheReferenceLibraryAsTrajectories) {
  if (std::system("command -v ncdump > /dev/null") != 0) GTEST_SKIP() << "install the package netcdf-bin";
  const support::TemporaryFolder folder;
  const std::string file = (folder.path() / "tracks.nc").string();
  std::ofstream{file, std::ios::binary} << simulation_netcdf(simulation_of(), flights());

  const std::string dump = output_of("ncdump -p 9,12 " + file);

  for (const char* expected :
       {":featureType = \"trajectory\"", ":Conventions = \"CF-1.8\"",
        "trajectory:cf_role = \"trajectory_id\"", "row_size:sample_dimension = \"obs\"", "obs = 6",
        "row_size = 3, 3", "\"s0123-0\"", "\"s0123-1\"", "depth:positive = \"down\"",
        "depth = 0, 12.35, 24.69, 0, 12.35, 24.69", "time = 1795200000, 1795203600, 1795207200",
        "mode = 0, 3, 0, 0, 3, 0", "at_surface = 1, 0, 0, 1, 0, 0",
        "mode:flag_meanings = \"mission path reactive given_up\"", "lon:standard_name = \"longitude\""}) {
    EXPECT_THAT(dump, HasSubstr(expected));
  }
}

TEST(SimulationNetcdf, HasTheSameBytesForTheSameFlights) {
  EXPECT_EQ(simulation_netcdf(simulation_of(), flights()), simulation_netcdf(simulation_of(), flights()));
}

TEST(NetcdfClassic, RefusesValuesThatDoNotFillTheirDimensions) {
  NetcdfClassic file;
  const auto dimension = file.add_dimension("x", 3);
  const std::array<double, 2> two{};

  EXPECT_THROW(file.add_doubles("v", {dimension}, two, {}), std::invalid_argument);
}

TEST(SimulationGeojson, HasBothTracksEventsAndApproachesOfEveryFlight) {
  const json document = simulation_geojson(simulation_of(), flights());

  ASSERT_EQ(document.at("features").size(), 8U);
  EXPECT_EQ(document.at("features")[0].at("geometry").at("type"), "LineString");
  EXPECT_EQ(document.at("features")[0].at("geometry").at("coordinates").size(), 3U);
  EXPECT_EQ(document.at("features")[1].at("properties").at("role"), "estimated track");
  EXPECT_EQ(document.at("features")[2].at("properties").at("kind"), "departure");
  EXPECT_EQ(document.at("features")[3].at("properties").at("to"), "sea bed");
  EXPECT_EQ(document.at("features")[7].at("properties").at("run"), 1);
}

TEST(SimulationGeojson, CutsATrackAtTheAntimeridian) {
  const json document = simulation_geojson(simulation_of(), flights({179.99, 70.0}));

  EXPECT_EQ(document.at("features")[0].at("geometry").at("type"), "MultiLineString");
}

TEST(SimulationGeojson, GivesAFlightThatNeverMovedALineAllTheSame) {
  simulation::FlightRecord record = flight(3, 0.0);
  record.track.resize(1);
  const json document =
      simulation_geojson(simulation_of(), {flight_document(record, geo::LocalProjection{{0.0, 60.0}}, 0)});

  EXPECT_EQ(document.at("features")[0].at("geometry").at("coordinates").size(), 2U);
}

}  // namespace
}  // namespace floeplan::codec::simulation_exports_test
