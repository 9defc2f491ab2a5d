#include "engine/planning/obstacles/iceberg_track.hpp"

#include <algorithm>
#include <cmath>

#include "engine/ocean/iceberg_drift.hpp"

namespace floeplan::planning::obstacles {
namespace {

/// Interpolates along straight lines between fixes; before the first and after the last the berg stays.
class TrackLine {
 public:
  TrackLine(const std::vector<ocean::IcebergFix>& fixes, const geo::LocalProjection& projection,
            core::UtcTime epoch) {
    for (const ocean::IcebergFix& fix : fixes) {
      times_s_.push_back((fix.time - epoch).count());
      points_.push_back(projection.to_plane(fix.place));
    }
  }

  [[nodiscard]] const std::vector<double>& times_s() const { return times_s_; }
  [[nodiscard]] geo::PlanePoint at(double t_s) const {
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(times_s_, t_s) - times_s_.begin());
    if (after == 0) return points_.front();
    if (after == points_.size()) return points_.back();
    const geo::PlanePoint a = points_[after - 1];
    const geo::PlanePoint b = points_[after];
    const double share = (t_s - times_s_[after - 1]) / (times_s_[after] - times_s_[after - 1]);
    return {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
  }

 private:
  std::vector<double> times_s_;
  std::vector<geo::PlanePoint> points_;
};

/// The times of the sighting, and before and after it when the position error reaches its limit.
std::vector<double> kinks_s(const ocean::Iceberg& iceberg, core::Metres most, core::UtcTime epoch) {
  const double sighted_s = (iceberg.observed - epoch).count();
  const double stated_m = iceberg.position_uncertainty.value_or(core::Metres{0.0}).value;
  const double until_s = (most.value - stated_m) / ocean::error_growth.value;
  if (until_s <= 0.0) return {sighted_s};
  return {sighted_s - until_s, sighted_s, sighted_s + until_s};
}

}  // namespace

std::vector<TrackPoint> track_of(const ocean::Iceberg& iceberg, const ocean::Environment& environment,
                                 const IcebergRules& rules, const geo::LocalProjection& projection,
                                 core::UtcTime epoch, core::Seconds horizon, const std::stop_token& stop) {
  const auto point = [&](double t_s, geo::PlanePoint centre, core::Metres error) {
    return TrackPoint{t_s, centre, std::min(error, rules.max_inflation),
                      projection.at(projection.to_lon_lat(centre)).scale};
  };
  if (!rules.drift) {
    return {point(0.0, projection.to_plane(iceberg.place),
                  iceberg.position_uncertainty.value_or(core::Metres{0.0}))};
  }

  const TrackLine line{ocean::forecast_drift(iceberg, environment, epoch + horizon, stop), projection, epoch};
  std::vector<double> times_s = line.times_s();
  const auto kinks = kinks_s(iceberg, rules.max_inflation, epoch);
  times_s.insert(times_s.end(), kinks.begin(), kinks.end());
  times_s.insert(times_s.end(), {0.0, horizon.count()});
  std::ranges::sort(times_s);
  const auto repeated = std::ranges::unique(times_s);
  times_s.erase(repeated.begin(), repeated.end());

  std::vector<TrackPoint> track;
  for (const double t_s : times_s) {
    if (t_s < 0.0 || t_s > horizon.count()) continue;
    track.push_back(point(t_s, line.at(t_s), ocean::expected_error(iceberg, epoch + core::Seconds{t_s})));
  }
  return track;
}

}  // namespace floeplan::planning::obstacles
