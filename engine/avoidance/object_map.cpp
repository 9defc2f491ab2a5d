#include "engine/avoidance/object_map.hpp"

#include <algorithm>
#include <cmath>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr std::size_t one_looks_past =
    4;  // of so many echoes: a cell that is not there is seen through often enough

/// Whether the object's keel would have echoed, had it been deeper: near enough, ahead, and seen in this ping.
bool shows_its_keel(const TrackedObject& object, double now_s, double apart_m, const SonarView& sonar) {
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
  look_below(own, own_in_water);
}

void ObjectMap::look_below(const OwnState& own, geo::PlanePoint own_in_water) {
  for (std::size_t i = 0; i < size_; ++i) {
    const double apart_m = distance_m(objects_[i].centre(), own_in_water);
    if (!shows_its_keel(objects_[i], now_s_, apart_m, settings_.sonar)) continue;
    const double lowest =
        settings_.sonar.half_height.value - settings_.sonar.tilt.value - own.attitude.pitch.value;
    const double near_m = std::max(apart_m - objects_[i].half_extent_m(), 0.0);
    objects_[i].look_below(own.depth.value + near_m * std::tan(std::clamp(lowest, -1.4, 1.4)));
  }
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
