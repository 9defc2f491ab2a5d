#include "storage/ingest/readers/currents/current_survey.hpp"

#include <algorithm>
#include <cmath>

#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/common/in_blocks.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/velocity/velocity_component.hpp"

namespace floeplan::ingest {
namespace {

/// The strongest mean winds measured at sea level are below 90 m/s.
constexpr double max_wind_m_s = 100.0;

struct SpeedCount {
  std::int64_t known{};
  std::int64_t moving{};
  std::int64_t too_fast{};
};

double squared_speed(const VelocitySlice& slice, std::size_t point) {
  const auto east = static_cast<double>(slice.east[point]);
  const auto north = static_cast<double>(slice.north[point]);
  return east * east + north * north;
}

SpeedCount count_speeds(const VelocitySlice& slice, double most_m_s) {
  SpeedCount all;
  in_blocks(slice.east.size(), [&](std::size_t first, auto count) {
    SpeedCount some;
    for (std::size_t i = 0; i < count; ++i) {
      const double squared = squared_speed(slice, first + i);  // NaN where missing
      some.known += std::int64_t{squared >= 0.0};
      some.moving += std::int64_t{squared > 0.0};
      some.too_fast += std::int64_t{squared > most_m_s * most_m_s};
    }
    all.known += some.known;
    all.moving += some.moving;
    all.too_fast += some.too_fast;
  });
  return all;
}

/// Why a slice is refused in which a speed is beyond `most_m_s`.
messages::Message too_fast(const VelocitySource& source, Moving what, bool states_unit,
                           const VelocitySlice& slice, double most_m_s) {
  std::size_t point = 0;
  while (!(squared_speed(slice, point) > most_m_s * most_m_s)) ++point;
  const double speed = std::sqrt(squared_speed(slice, point));
  const geo::LonLat place = source.place(point);
  const std::string where = "longitude " + number(place.lon_deg) + ", latitude " + number(place.lat_deg);
  const std::string reached = number(speed, 4);
  if (what == Moving::air)
    return states_unit ? messages::ingest_current_message<"wind-too-strong">(reached, where)
                       : messages::ingest_current_message<"wind-too-strong-without-unit">(reached, where);
  return states_unit ? messages::ingest_current_message<"current-too-fast">(reached, where)
                     : messages::ingest_current_message<"current-too-fast-without-unit">(reached, where);
}

/// A number that both components have at many points and that none exceeds: water does not move so, but a mark within
/// the range of possible speeds looks so, as -99.99 among cm/s.
std::optional<messages::Message> doubt_in_marks(const VelocitySlice& slice) {
  constexpr std::size_t fewest_points = 9;
  constexpr double smallest_share = 0.01;
  float least = INFINITY;
  float greatest = -INFINITY;
  for (const float east : slice.east) {
    if (east < least) least = east;
    if (east > greatest) greatest = east;
  }
  const auto enough = static_cast<std::size_t>(smallest_share * static_cast<double>(slice.east.size()));
  if (least == greatest) return std::nullopt;
  for (const float extreme : {least, greatest}) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < slice.east.size(); ++i)
      count += slice.east[i] == extreme && slice.north[i] == extreme ? 1U : 0U;
    if (extreme == 0.0F || count < std::max(fewest_points, enough)) continue;
    return messages::ingest_current_message<"possible-marker">(count, number(static_cast<double>(extreme)),
                                                               extreme == least ? "less" : "greater");
  }
  return std::nullopt;
}

}  // namespace

Checked<CurrentSurvey> survey(const VelocitySource& source, Moving what, bool states_unit,
                              const core::ProgressCallback& progress) {
  const SourceShape& shape = source.shape();
  CurrentSurvey result;
  const double most_m_s = what == Moving::sea ? max_speed_m_s : max_wind_m_s;
  const bool in_rows = shape.rows > 1 && what == Moving::sea;
  const auto land = in_rows ? std::make_shared<ZeroLand>(shape.columns, shape.rows, shape.levels) : nullptr;
  for (std::size_t time = 0; time < shape.times_s.size(); ++time) {
    for (std::size_t level = 0; level < shape.levels; ++level) {
      const auto slice = source.read(time, level);
      if (!slice) return refuse(slice.error());
      const SpeedCount speeds = count_speeds(*slice, most_m_s);
      if (speeds.too_fast > 0) return refuse(too_fast(source, what, states_unit, *slice, most_m_s));
      result.valid += speeds.known;
      if (speeds.moving > 0) result.everything_is_zero = false;
      result.undeclared_fill += slice->undeclared_fill;
      result.flagged.bad += slice->flagged.bad;
      result.flagged.doubtful += slice->flagged.doubtful;
      if (time == 0 && level == 0) result.doubt = doubt_in_marks(*slice);
      if (land) land->add(level, slice->east, slice->north);
    }
    if (progress)
      progress("checking", 0.5 * static_cast<double>(time + 1) / static_cast<double>(shape.times_s.size()));
  }
  if (land && land->found()) result.land = land;
  return result;
}

}  // namespace floeplan::ingest
