#include "storage/ingest/readers/currents/current_survey.hpp"

#include <algorithm>
#include <cmath>

#include "storage/ingest/common/in_blocks.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/velocity/velocity_component.hpp"

namespace floeplan::ingest {
namespace {

/// The strongest mean winds that were measured at sea level are below 90 m/s.
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
std::string too_fast(const VelocitySource& source, Moving what, bool states_unit, const VelocitySlice& slice,
                     double most_m_s) {
  const std::string way_out =
      "; ask the producer, or name the number that marks them with --missing, for example --missing -99.99";
  std::size_t point = 0;
  while (!(squared_speed(slice, point) > most_m_s * most_m_s)) ++point;
  const double speed = std::sqrt(squared_speed(slice, point));
  const geo::LonLat place = source.place(point);
  const std::string where = "longitude " + number(place.lon_deg) + ", latitude " + number(place.lat_deg);
  if (what == Moving::air)
    return "the wind reaches " + number(speed, 4) + (states_unit ? " m/s at " : " at ") + where +
           "; no wind is that strong; " +
           (states_unit ? "the unit is wrong or the file marks missing values without declaring "
                          "them" +
                              way_out
                        : "the file states no unit, and it is probably not m/s; ask the producer");
  if (!states_unit)
    return "the current reaches " + number(speed, 4) + " at " + where +
           " and the file states no unit; in m/s no ocean is that fast, so the unit is probably cm/s; ask "
           "the producer, or add the units attribute";
  return "the current reaches " + number(speed, 4) + " m/s at " + where +
         "; no ocean is that fast; the unit is wrong or the file marks missing values without declaring "
         "them" +
         way_out;
}

/// A number that both components have at many points and that none exceeds: water does not move so, but a mark within
/// the range of possible speeds looks so, as -99.99 among cm/s.
std::string doubt_in_marks(const VelocitySlice& slice) {
  constexpr std::size_t fewest_points = 9;
  constexpr double smallest_share = 0.01;
  float least = INFINITY;
  float greatest = -INFINITY;
  for (const float east : slice.east) {
    if (east < least) least = east;
    if (east > greatest) greatest = east;
  }
  const auto enough = static_cast<std::size_t>(smallest_share * static_cast<double>(slice.east.size()));
  if (least == greatest) return "";
  for (const float extreme : {least, greatest}) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < slice.east.size(); ++i)
      count += slice.east[i] == extreme && slice.north[i] == extreme ? 1U : 0U;
    if (extreme == 0.0F || count < std::max(fewest_points, enough)) continue;
    return "at " + std::to_string(count) + " points both components are exactly " +
           number(static_cast<double>(extreme)) + " m/s and none is " +
           (extreme == least ? "less" : "greater") +
           "; this looks like a mark of missing values that the file does not declare; if it is one, remove "
           "the dataset "
           "and ingest the file again with --missing and the number as the file has it";
  }
  return "";
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
