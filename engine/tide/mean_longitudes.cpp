#include "engine/tide/mean_longitudes.hpp"

#include <cmath>

namespace floeplan::tide {
namespace {

constexpr double seconds_a_day = 86'400.0;
constexpr double j2000_unix_s = 946'728'000.0;  // 2000-01-01T12:00:00Z
constexpr double days_a_century = 36'525.0;

}  // namespace

MeanLongitudes mean_longitudes(core::UtcTime time) {
  const double unix_s = core::unix_seconds(time);
  const double t = (unix_s - j2000_unix_s) / (seconds_a_day * days_a_century);
  const double of_day = unix_s / seconds_a_day - std::floor(unix_s / seconds_a_day);

  MeanLongitudes result;
  result.moon_deg = 218.3164477 + t * (481267.88123421 + t * (-0.0015786 + t / 538841.0));
  result.sun_deg = 280.46646 + t * (36000.76983 + t * 0.0003032);
  result.lunar_perigee_deg = 83.3532465 + t * (4069.0137287 + t * (-0.0103200 - t / 80053.0));
  result.lunar_node_deg = 125.0445479 + t * (-1934.1362891 + t * (0.0020754 + t / 467441.0));
  result.solar_perigee_deg = 282.93735 + t * (1.71946 + t * 0.00046);
  result.lunar_time_deg = 360.0 * of_day - result.moon_deg + result.sun_deg;
  return result;
}

}  // namespace floeplan::tide
