#include "engine/avoidance/object_map.hpp"

#include <algorithm>
#include <cmath>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr std::size_t one_looks_past =
    4;  // only every fourth echo is tested for having passed through a cell: enough to find cells with nothing there

constexpr double least_row_height = 0.1;  // for beams without a height of their own: 6 degrees

/// Whether a larger object would have given more echoes: it is near enough, ahead, and was seen in this ping.
bool is_in_view(const TrackedObject& object, double now_s, double apart_m, const SonarView& sonar) {
  return object.seen_s() == now_s && apart_m < 0.75 * sonar.reach.value;
}

}  // namespace

void ObjectMap::advance(double now_s) {
  now_s_ = now_s;
  for (std::size_t i = size_; i-- > 0;) {
    objects_[i].advance(now_s);
    objects_[i].forget_before(now_s - settings_.forget.count());
    if (objects_[i].size() == 0) remove(i);
  }
}

void ObjectMap::remove(std::size_t i) {
  --size_;
  if (i != size_) objects_[i] = objects_[size_];
}

void ObjectMap::take(std::span<const Echo> ping, const OwnState& own, geo::PlanePoint own_in_water) {
  confirmation_.begin_ping();
  ++pings_;
  for (std::size_t k = 0; k < ping.size(); ++k) {
    const Echo& echo = ping[k];
    const bool looks_past = (k + pings_) % one_looks_past == 0;
    bool on_surface = false;
    for (std::size_t i = 0; i < size_; ++i) {
      TrackedObject& object = objects_[i];
      on_surface |= object.take(echo, settings_.sonar) == TrackedObject::Match::on_surface;
      if (looks_past) object.contradict(echo, own_in_water, own.depth.value);
    }
    if (on_surface) continue;
    if (const auto confirmed = confirmation_.take(echo)) add(*confirmed, own_in_water);
  }
  for (std::size_t i = 0; i < size_; ++i) objects_[i].correct();
  look_past(own, own_in_water);
}

/// Counts looks below keels and above tops. A top is looked over if the highest row of beams is a row's
/// height above it: an echo of that row may still be the foot of a part that goes on above.
void ObjectMap::look_past(const OwnState& own, geo::PlanePoint own_in_water) {
  const SonarView& view = settings_.sonar;
  const double pitch = own.attitude.pitch.value;
  const double lowest = view.half_height.value - view.tilt.value - pitch;
  const double highest = view.edge.value + view.tilt.value + pitch;
  const double row_height = std::max(2.0 * view.beam_half_height.value, least_row_height);
  const auto rise = [](double angle) { return std::tan(std::clamp(angle, -1.4, 1.4)); };
  for (std::size_t i = 0; i < size_; ++i) {
    const double apart_m = distance_m(objects_[i].centre(), own_in_water);
    if (!is_in_view(objects_[i], now_s_, apart_m, view)) continue;
    const double near_m = std::max(apart_m - objects_[i].half_extent_m(), 0.0);
    objects_[i].look_below(own.depth.value + near_m * rise(lowest));
    objects_[i].look_above(own.depth.value - near_m * rise(highest - row_height));
  }
}

void ObjectMap::stand_on(const Echo& bed) {
  for (std::size_t i = 0; i < size_; ++i) objects_[i].stand_on(bed);
}

void ObjectMap::add(const Echo& confirmed, geo::PlanePoint vehicle) {
  for (std::size_t i = 0; i < size_; ++i) {
    if (objects_[i].take(confirmed, settings_.sonar) == TrackedObject::Match::none) continue;
    objects_[i].add(confirmed, vehicle);
    return;
  }
  std::size_t place = size_;
  if (size_ == most_objects) {
    place = 0;
    for (std::size_t i = 1; i < size_; ++i) {
      if (objects_[i].seen_s() < objects_[place].seen_s()) place = i;
    }
  } else {
    ++size_;
  }
  objects_[place] = TrackedObject{next_id_++, confirmed, now_s_, settings_.drift_sigma};
  objects_[place].add(confirmed, vehicle);
}

}  // namespace floeplan::avoidance
