#include "engine/avoidance/vertical_room.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr double soundings_hold_s = 900.0;  // some 300 m of way
constexpr double steepest = 0.2;            // of a bed or an underside: beyond that it is taken for a wall
constexpr double noise_m = 3.0;             // of an echo's depth
constexpr double beside_m = 150.0;          // farther from a sounding nothing is concluded from it
constexpr double bed_echo_holds_s = 120.0;
constexpr double silence_tells_s = 30.0;
constexpr double heard_from_m = 40.0;  // by any altimeter, of any bed
constexpr double overhead_m = 3.0;     // the least height above the vehicle of an echo from above
constexpr double underfoot_m = 10.0;   // the same below: nearer, the altimeter tells
constexpr double seek_beds_every_s = 10.0;
constexpr double cover_width_m = 200.0;  // of the greatest bergs that are gone round without a doubt
constexpr int looks_needed = 20;         // pings
constexpr double least_slope = 0.35;     // of a glider's way: 20 degrees

}  // namespace

void VerticalRoom::sound(const OwnState& own, geo::PlanePoint own_in_water) {
  before_s_ = std::exchange(now_s_, core::unix_seconds(own.time));
  depth_m_ = own.depth.value;
  place_ = own_in_water;
  bed_.forget_before(now_s_ - soundings_hold_s);
  roof_.forget_before(now_s_ - soundings_hold_s);
  read_altimeter(own);
}

void VerticalRoom::read_altimeter(const OwnState& own) {
  if (own.altitude && std::isfinite(own.altitude->value)) {
    silent_s_ = 0.0;
    bed_.take({place_, own.depth.value + own.altitude->value, now_s_}, true);
    return;
  }
  // It looks down while the vehicle dives.
  if (own.attitude.pitch.value < 0.0) silent_s_ += now_s_ - before_s_;
  if (silent_s_ >= silence_tells_s) unlearn_bed();
}

/// Where the altimeter hears nothing the bed is far below, and no slope leads up from there to what was taken for one: the
/// foot of a berg.
void VerticalRoom::unlearn_bed() {
  const auto is_none = [&](const Sounding& bed) {
    return bed.depth_m < depth_m_ + heard_from_m - steepest * distance_m(bed.place, place_);
  };
  bed_.forget_if(is_none);
  if (shallowest_bed_ && is_none(*shallowest_bed_)) shallowest_bed_.reset();
}

void VerticalRoom::begin_ping() {
  bed_confirmation_.begin_ping();
  underfoot_confirmation_.begin_ping();
  roof_confirmation_.begin_ping();
}

bool VerticalRoom::passes(const Echo& echo) {
  return echo.depth_m > settings_.deepest.value + settings_.vertical_margin.value || is_bed(echo) ||
         is_roof(echo);
}

bool VerticalRoom::has_room_under(double ice_m) const {
  return ice_m + settings_.vertical_margin.value + settings_.least_band.value <= settings_.deepest.value;
}

bool VerticalRoom::has_room_over(double bed_m) const { return bed_m >= settings_.least_water.value; }

bool VerticalRoom::is_known_bed(geo::PlanePoint place, double depth_m) const {
  return std::ranges::any_of(bed_.all(), [&](const Sounding& bed) {
    return depth_m >= bed.depth_m - noise_m - steepest * distance_m(bed.place, place);
  });
}

void VerticalRoom::limit_by(const Sounding& bed) {
  const bool is_old = !shallowest_bed_ || now_s_ - shallowest_bed_->time_s > bed_echo_holds_s;
  if (is_old || bed.depth_m < shallowest_bed_->depth_m) shallowest_bed_ = bed;
}

bool VerticalRoom::is_bed(const Echo& echo) {
  if (!has_room_over(echo.deepest_m)) return false;
  const double below_m = echo.depth_m - depth_m_;
  if (below_m > underfoot_m && below_m > distance_m(place_, echo.place)) {
    if (const auto bed = underfoot_confirmation_.take(echo))
      bed_.take({bed->place, bed->deepest_m, now_s_}, false);
    return true;
  }
  if (!is_known_bed(echo.place, echo.deepest_m)) return false;
  if (const auto bed = bed_confirmation_.take(echo)) limit_by({bed->place, bed->deepest_m, now_s_});
  return true;
}

bool VerticalRoom::is_bed_throughout(const TrackedObject& object) const {
  for (std::size_t i = 0; i < object.size(); ++i) {
    const SurfaceCell& cell = object.cell(i);
    if (!has_room_over(cell.deepest_m) || !is_known_bed(object.place(cell), cell.deepest_m)) return false;
  }
  return true;
}

void VerticalRoom::take_beds(ObjectMap& objects) {
  if (bed_.all().empty() || (beds_sought_s_ && now_s_ - *beds_sought_s_ < seek_beds_every_s)) return;
  beds_sought_s_ = now_s_;
  for (std::size_t i = objects.size(); i-- > 0;) {
    const TrackedObject& object = objects[i];
    if (!is_bed_throughout(object)) continue;
    for (std::size_t k = 0; k < object.size(); ++k) {
      limit_by({object.place(object.cell(k)), object.cell(k).deepest_m, now_s_});
    }
    objects.remove(i);
  }
}

bool VerticalRoom::is_roof(const Echo& echo) {
  if (!has_room_under(echo.depth_m)) return false;
  const double above_m = depth_m_ - echo.depth_m;
  const bool is_overhead = above_m > overhead_m && above_m > distance_m(place_, echo.place);
  bool is_known = false;
  bool goes_on =
      false;  // at the same slope without the noise: else a wall would be walked down, noise by noise
  for (const Sounding& roof : roof_.all()) {
    const double apart_m = distance_m(roof.place, echo.place);
    if (apart_m > beside_m) continue;
    is_known |= echo.shallowest_m <= roof.depth_m + noise_m + steepest * apart_m;
    goes_on |= echo.depth_m <= roof.depth_m + steepest * apart_m;
  }
  if (!is_overhead && !is_known) return false;
  if (is_overhead || goes_on) {
    if (const auto roof = roof_confirmation_.take(echo))
      roof_.take({roof->place, roof->depth_m, now_s_}, false);
  }
  return true;
}

bool VerticalRoom::is_cover(const TrackedObject& object) const {
  if (2.0 * object.half_extent_m() < cover_width_m || object.looks_below() < looks_needed) return false;
  if (!has_room_under(object.keel_m())) return false;
  double nearest_m = beside_m;
  for (std::size_t i = 0; i < object.size(); ++i) {
    nearest_m = std::min(nearest_m, distance_m(object.place(object.cell(i)), place_));
  }
  return depth_m_ + least_slope * nearest_m > object.keel_m() + settings_.vertical_margin.value;
}

void VerticalRoom::take_covers(ObjectMap& objects) {
  for (std::size_t i = objects.size(); i-- > 0;) {
    const TrackedObject& object = objects[i];
    if (!is_cover(object)) continue;
    for (std::size_t k = 0; k < object.size(); ++k) {
      roof_.take({object.place(object.cell(k)), object.keel_m(), now_s_}, true);
    }
    objects.remove(i);
  }
}

VerticalRoom::Band VerticalRoom::band() const {
  Band band{below_ice(), above_bed()};
  if (!band.top || !band.bottom || *band.bottom - *band.top >= settings_.least_band) return band;
  const double middle_m = 0.5 * (band.top->value + band.bottom->value);
  band.top = core::Metres{std::max(middle_m - 0.5 * settings_.least_band.value, settings_.shallowest.value)};
  band.bottom = *band.top + settings_.least_band;
  return band;
}

std::optional<core::Metres> VerticalRoom::below_ice() const {
  std::optional<core::Metres> limit;
  for (const Sounding& roof : roof_.all()) {
    if (distance_m(roof.place, place_) > beside_m) continue;
    const core::Metres below{roof.depth_m + settings_.vertical_margin.value};
    if (below > settings_.shallowest && (!limit || below > *limit)) limit = below;
  }
  return limit;
}

std::optional<core::Metres> VerticalRoom::above_bed() const {
  std::optional<core::Metres> limit;
  const auto hold = [&](double bed_m) {
    const core::Metres above{std::max(bed_m - settings_.vertical_margin.value, settings_.shallowest.value)};
    if (above < settings_.deepest && (!limit || above < *limit)) limit = above;
  };
  if (shallowest_bed_ && now_s_ - shallowest_bed_->time_s <= bed_echo_holds_s) hold(shallowest_bed_->depth_m);
  for (const Sounding& bed : bed_.all()) {
    if (distance_m(bed.place, place_) < Soundings::apart_m) hold(bed.depth_m);
  }
  return limit;
}

}  // namespace floeplan::avoidance
