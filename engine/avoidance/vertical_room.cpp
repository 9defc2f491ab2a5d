#include "engine/avoidance/vertical_room.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr double right_angle = std::numbers::pi / 2.0;
constexpr double soundings_hold_s = 900.0;   // validity of soundings: some 300 m of way
constexpr double steepest = 0.2;             // of a bed or an underside; steeper surfaces count as walls
constexpr double noise_m = 3.0;              // error of an echo's depth
constexpr double sounding_radius_m = 150.0;  // farther from a sounding nothing is concluded from it
constexpr double bed_echo_holds_s = 120.0;
constexpr double silence_tells_s = 30.0;
constexpr double heard_from_m = 40.0;    // range at which any altimeter hears any bed
constexpr double overhead_m = 3.0;       // least height of an echo above the vehicle to count as overhead
constexpr double below_within_m = 15.0;  // horizontal, of what a wall stands on, for echoes from above
constexpr double underfoot_m = 10.0;     // horizontal, for echoes from below; nearer, the altimeter measures
constexpr double seek_beds_every_s = 10.0;
constexpr double cover_width_m = 200.0;  // larger than any berg, which is always gone round
constexpr int looks_needed = 20;         // pings
constexpr double least_slope = 0.35;     // of a glider's path: 20 degrees
constexpr double turning_way_m =
    15.0;  // flown between the order to climb and the climb, in half a minute of pumping
constexpr double rise_over_m = 15.0;  // distance over which the bed's rise is measured
constexpr double rise_within_s = 300.0;
/// Pitch in a dive at which the altimeter looks straight down. In a climb it looks ahead, and the near edge
/// of its beam makes the bed seem an eighth shallower.
constexpr double straight_down_pitch = -0.35;
constexpr double least_rise = 0.03;  // the altimeter's noise alone gives 0.01
constexpr double shoal_watch_m = 80.0;
constexpr double nearest_shoal_m = 40.0;  // distance needed for a turn
constexpr double shoal_patches_apart_m = 12.0;

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
    const Sounding below{place_, own.depth.value + own.altitude->value, now_s_};
    bed_.take(below, true);
    if (own.attitude.pitch.value < straight_down_pitch) look_for_shoal(below);
    return;
  }
  // The altimeter looks down only in a dive.
  if (own.attitude.pitch.value < 0.0) silent_s_ += now_s_ - before_s_;
  if (silent_s_ >= silence_tells_s) unlearn_bed();
}

/// Looks for a shoal ahead, as far as the measured rise of the bed can be extrapolated.
void VerticalRoom::look_for_shoal(const Sounding& below) {
  const double way_m = sounded_ ? distance_m(sounded_->place, below.place) : 0.0;
  const bool is_of_use = sounded_ && below.time_s - sounded_->time_s < rise_within_s;
  if (is_of_use && way_m < rise_over_m) return;
  const auto before = std::exchange(sounded_, below);
  if (!is_of_use) return;
  const double rise = (before->depth_m - below.depth_m) / way_m;
  if (rise < least_rise) return;
  const double edge_m = (below.depth_m - settings_.least_water.value) / rise;
  if (edge_m > shoal_watch_m) return;
  const double course = direction_rad(before->place, below.place);
  const geo::PlanePoint middle = moved(below.place, course, std::max(edge_m, nearest_shoal_m));
  const double depth_m = settings_.least_water.value - noise_m;
  ShoalEdge edge;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const double aside_m = shoal_patches_apart_m * (static_cast<double>(i) - 0.5 * (edge.size() - 1));
    const geo::PlanePoint place = moved(middle, course + right_angle, aside_m);
    edge[i] = {place, depth_m, distance_m(place_, place), depth_m, depth_m};
  }
  shoal_ = edge;
}

/// Removes wrong soundings of the bed. If the altimeter hears nothing, the bed is far below. A sounding so high
/// that no slope leads up to it from there was the foot of a berg.
void VerticalRoom::unlearn_bed() {
  const auto is_none = [&](const Sounding& bed) {
    return bed.depth_m < depth_m_ + heard_from_m - steepest * distance_m(bed.place, place_);
  };
  bed_.forget_if(is_none);
  if (shallowest_bed_ && is_none(*shallowest_bed_)) shallowest_bed_.reset();
}

void VerticalRoom::begin_ping(std::span<const Echo> ping) {
  ping_ = ping;
  bed_confirmation_.begin_ping();
  underfoot_confirmation_.begin_ping();
  roof_confirmation_.begin_ping();
}

VerticalRoom::Pass VerticalRoom::passes(const Echo& echo) {
  if (echo.depth_m > settings_.deepest.value + settings_.vertical_margin.value || is_bed(echo))
    return Pass::above;
  return is_roof(echo) ? Pass::below : Pass::no;
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

/// Whether the vehicle clears the bed there if it begins to climb now. Half the margin is for the turn.
bool VerticalRoom::is_passed_above(geo::PlanePoint place, double bed_m) const {
  const double way_m = std::max(0.0, distance_m(place, place_) - turning_way_m);
  return depth_m_ - (bed_m - 0.5 * settings_.vertical_margin.value) <= least_slope * way_m;
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
  if (!is_known_bed(echo.place, echo.deepest_m) || !is_passed_above(echo.place, echo.deepest_m)) return false;
  if (const auto bed = bed_confirmation_.take(echo)) limit_by({bed->place, bed->deepest_m, now_s_});
  return true;
}

bool VerticalRoom::is_bed_throughout(const TrackedObject& object) const {
  for (std::size_t i = 0; i < object.size(); ++i) {
    const SurfaceCell& cell = object.cell(i);
    const geo::PlanePoint place = object.place(cell);
    if (!has_room_over(cell.deepest_m) || !is_known_bed(place, cell.deepest_m) ||
        !is_passed_above(place, cell.deepest_m))
      return false;
  }
  return true;
}

/// Whether the object ends below the vehicle's path. Ice never does: it reaches the surface.
bool VerticalRoom::ends_below(const TrackedObject& object) const {
  if (object.looks_above() < looks_needed || !has_room_over(object.top_m())) return false;
  for (std::size_t i = 0; i < object.size(); ++i) {
    if (!is_passed_above(object.place(object.cell(i)), object.cell(i).depth_m)) return false;
  }
  return true;
}

void VerticalRoom::take_beds(ObjectMap& objects) {
  if (beds_sought_s_ && now_s_ - *beds_sought_s_ < seek_beds_every_s) return;
  beds_sought_s_ = now_s_;
  for (std::size_t i = objects.size(); i-- > 0;) {
    const TrackedObject& object = objects[i];
    const bool is_top_known = ends_below(object);
    if (!is_top_known && !is_bed_throughout(object)) continue;
    for (std::size_t k = 0; k < object.size(); ++k) {
      if (is_top_known) bed_.take({object.place(object.cell(k)), object.top_m(), now_s_}, false);
      const double bed_m = is_top_known ? object.top_m() : object.cell(k).deepest_m;
      limit_by({object.place(object.cell(k)), bed_m, now_s_});
    }
    objects.remove(i);
  }
}

/// Whether the echo comes from steeply above and not from a wall. For a wall, lower beams have echoes below
/// it that are no farther away.
bool VerticalRoom::is_overhead(const Echo& echo) const {
  const double above_m = depth_m_ - echo.depth_m;
  const double away_m = distance_m(place_, echo.place);
  if (above_m <= overhead_m || above_m <= away_m) return false;
  return std::ranges::none_of(ping_, [&](const Echo& lower) {
    const bool is_joined =
        lower.depth_m > echo.depth_m + noise_m && lower.shallowest_m <= echo.deepest_m + noise_m;
    return is_joined && distance_m(place_, lower.place) <= away_m + noise_m &&
           distance_m(lower.place, echo.place) <= below_within_m;
  });
}

bool VerticalRoom::is_roof(const Echo& echo) {
  if (!has_room_under(echo.depth_m)) return false;
  const bool overhead = is_overhead(echo);
  bool is_known = false;
  bool goes_on =
      false;  // at the same slope without the noise: with the noise a wall would count as bed, step by step
  for (const Sounding& roof : roof_.all()) {
    const double apart_m = distance_m(roof.place, echo.place);
    if (apart_m > sounding_radius_m) continue;
    is_known |= echo.shallowest_m <= roof.depth_m + noise_m + steepest * apart_m;
    goes_on |= echo.depth_m <= roof.depth_m + steepest * apart_m;
  }
  if (!overhead && !is_known) return false;
  if (overhead || goes_on) {
    if (const auto roof = roof_confirmation_.take(echo))
      roof_.take({roof->place, roof->depth_m, now_s_}, false);
  }
  return true;
}

bool VerticalRoom::is_cover(const TrackedObject& object) const {
  if (2.0 * object.half_extent_m() < cover_width_m || object.looks_below() < looks_needed) return false;
  if (!has_room_under(object.keel_m())) return false;
  double nearest_m = sounding_radius_m;
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
    if (distance_m(roof.place, place_) > sounding_radius_m) continue;
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
