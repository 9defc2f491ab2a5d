#include "storage/demo/stream_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "storage/demo/flat_earth.hpp"

namespace floeplan::demo::stream_function_test {
namespace {

constexpr RasterFrame channel{-51.0, 60.0, 0.02, 0.01, 41, 21};

std::vector<bool> banks() {
  std::vector<bool> land(channel.size());
  for (std::size_t c = 0; c < channel.columns; ++c) {
    land[channel.index(c, 0)] = true;
    land[channel.index(c, channel.rows - 1)] = true;
  }
  return land;
}

const Gate west_end{{-51.0, 60.0, -50.981, 60.21}, 1.0};
const Gate east_end{{-50.199, 60.0, -50.18, 60.21}, -1.0};

/// The transport across a meridian, eastwards.
double transport(const Flow& flow, std::size_t column) {
  double sum = 0.0;
  for (std::size_t r = 0; r < channel.rows; ++r) sum += flow.east[channel.index(column, r)];
  return sum * channel.step_lat_deg * metres_per_degree_lat;
}

TEST(StreamFlow, CarriesTheSameThroughEveryCrossSection) {
  std::vector<bool> land = banks();
  for (std::size_t r = 8; r < 13; ++r) {
    for (std::size_t c = 18; c < 24; ++c) land[channel.index(c, r)] = true;
  }

  const Flow flow = stream_flow(channel, land, std::vector<double>(channel.size(), 1.0), {west_end, east_end},
                                std::vector<double>(channel.size()));

  for (const std::size_t column : {8U, 14U, 20U, 27U, 33U})
    EXPECT_NEAR(transport(flow, column), 1.0, 0.08) << column;
  EXPECT_EQ(flow.east[channel.index(20, 10)], 0.0);
}

TEST(StreamFlow, TurnsAnticlockwiseWhereItIsSpun) {
  std::vector<double> spin(channel.size());
  spin[channel.index(20, 10)] = 1.0;

  const Flow flow = stream_flow(channel, banks(), std::vector<double>(channel.size(), 1.0), {}, spin);

  EXPECT_GT(flow.north[channel.index(25, 10)], 0.0);
  EXPECT_LT(flow.north[channel.index(15, 10)], 0.0);
  EXPECT_LT(flow.east[channel.index(20, 14)], 0.0);
  EXPECT_GT(flow.east[channel.index(20, 6)], 0.0);
}

TEST(StreamFlow, RefusesGatesThatLetInMoreThanOut) {
  EXPECT_THROW(static_cast<void>(stream_flow(channel, banks(), std::vector<double>(channel.size(), 1.0),
                                             {west_end}, std::vector<double>(channel.size()))),
               std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::demo::stream_function_test
