#include "engine/avoidance/vertical_room.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::avoidance {
namespace {

constexpr double sounding_holds_s = 600.0;  // some 200 m of way
constexpr double soundings_apart_m = 10.0;
constexpr double steepest_bed = 0.2;  // beyond that it is taken for a wall
constexpr double bed_noise_m = 3.0;   // of a sonar echo's depth against the altimeter's
constexpr double bed_echo_holds_s = 120.0;
constexpr double cover_width_m =
    250.0;                        // wider than a berg of the size that is met off Greenland and Newfoundland
constexpr int looks_needed = 20;  // pings
constexpr double under_reach_m = 120.0;  // a glider sinks or rises by a good third of that on the way

double distance(geo::PlanePoint a, geo::PlanePoint b) { return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m); }

}  // namespace

void VerticalRoom::sound(const OwnState& own, geo::PlanePoint own_in_water) {
  if (!own.altitude || !std::isfinite(own.altitude->value)) return;
  const Sounding found{own_in_water, own.depth.value + own.altitude->value, core::unix_seconds(own.time)};
  const std::size_t last = (next_ + soundings_.size() - 1) % soundings_.size();
  if (sounded_ > 0 && distance(soundings_[last].place, own_in_water) < soundings_apart_m) {
    soundings_[last] = found;
    return;
  }
  soundings_[next_] = found;
  next_ = (next_ + 1) % soundings_.size();
  sounded_ = std::min(sounded_ + 1, soundings_.size());
}

bool VerticalRoom::passes_over(const Echo& echo, double now_s) {
  if (echo.depth_m > settings_.deepest.value + settings_.vertical_margin.value) return true;
  const auto bed_m = bed_near(echo.place, now_s);
  if (!bed_m || echo.depth_m < *bed_m) return false;
  if (echo.depth_m - settings_.vertical_margin.value - settings_.shallowest.value <
      settings_.least_band.value) {
    return false;
  }
  const bool is_old = now_s - shallowest_bed_.time_s > bed_echo_holds_s;
  if (is_old || echo.depth_m < shallowest_bed_.depth_m) shallowest_bed_ = {echo.place, echo.depth_m, now_s};
  return true;
}

/// The least depth at which a sea bed may lie there, by the soundings; empty: none near in time.
std::optional<double> VerticalRoom::bed_near(geo::PlanePoint place, double now_s) const {
  std::optional<double> least;
  for (std::size_t i = 0; i < sounded_; ++i) {
    if (now_s - soundings_[i].time_s > sounding_holds_s) continue;
    const double bed_m =
        soundings_[i].depth_m - bed_noise_m - steepest_bed * distance(soundings_[i].place, place);
    if (!least || bed_m > *least) least = bed_m;
  }
  return least;
}

bool VerticalRoom::passes_under(const TrackedObject& object) const {
  return 2.0 * object.half_extent_m() > cover_width_m && object.looks_below() >= looks_needed &&
         object.keel_m() + settings_.vertical_margin.value + settings_.least_band.value <
             settings_.deepest.value;
}

std::optional<core::Metres> VerticalRoom::shallowest(const ObjectMap& objects,
                                                     geo::PlanePoint own_in_water) const {
  std::optional<core::Metres> limit;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!passes_under(objects[i])) continue;
    for (std::size_t k = 0; k < objects[i].size(); ++k) {
      const SurfaceCell& cell = objects[i].cell(k);
      if (distance(objects[i].place(cell), own_in_water) > under_reach_m) continue;
      const core::Metres below{cell.depth_m + settings_.vertical_margin.value};
      if (below > settings_.shallowest && (!limit || below > *limit)) limit = below;
    }
  }
  return limit;
}

std::optional<core::Metres> VerticalRoom::deepest(double now_s) const {
  std::optional<core::Metres> limit;
  const auto hold = [&](double bed_m) {
    const core::Metres above{std::max(bed_m - settings_.vertical_margin.value, settings_.shallowest.value)};
    if (above < settings_.deepest && (!limit || above < *limit)) limit = above;
  };
  if (shallowest_bed_.time_s > 0.0 && now_s - shallowest_bed_.time_s <= bed_echo_holds_s)
    hold(shallowest_bed_.depth_m);
  if (sounded_ > 0) {
    const Sounding& last = soundings_[(next_ + soundings_.size() - 1) % soundings_.size()];
    if (now_s - last.time_s <= bed_echo_holds_s) hold(last.depth_m);
  }
  return limit;
}

}  // namespace floeplan::avoidance
