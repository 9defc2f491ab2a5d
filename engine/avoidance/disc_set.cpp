#include "engine/avoidance/disc_set.hpp"

#include <algorithm>
#include <cmath>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr double leave_m = 0.5;

/// The obstacle's disc; reduced so that it does not contain the vehicle, if the vehicle is inside.
motion::MovingDisc disc_left_by(const Obstacle& obstacle, const LookAhead& look) {
  motion::MovingDisc disc = disc_of(obstacle, look.now_s, look.until_s, look.clearance_m);
  const double east_m = look.from.x_m - disc.centre0.x_m;
  const double north_m = look.from.y_m - disc.centre0.y_m;
  const double apart_m2 = east_m * east_m + north_m * north_m;
  const double within_m = disc.radius0_m + leave_m;
  if (apart_m2 > within_m * within_m) return disc;  // the usual case, without a square root
  disc.radius0_m = std::max(std::sqrt(apart_m2) - leave_m, 0.0);
  disc.growth_m_s = 0.0;
  return disc;
}

bool is_out_of_reach(const motion::MovingDisc& disc, const LookAhead& look) {
  const double speed_m_s = std::abs(disc.velocity.x_m_s) + std::abs(disc.velocity.y_m_s) + disc.growth_m_s;
  const double meets_m = look.reach_m + disc.radius0_m + speed_m_s * (look.until_s - look.now_s);
  const double east_m = look.from.x_m - disc.centre0.x_m;
  const double north_m = look.from.y_m - disc.centre0.y_m;
  return east_m * east_m + north_m * north_m > meets_m * meets_m;
}

bool drift_alike(const motion::MovingDisc& a, const motion::MovingDisc& b) {
  return a.velocity.x_m_s == b.velocity.x_m_s && a.velocity.y_m_s == b.velocity.y_m_s;
}

/// A disc that contains all these discs, which have the same drift, at all times.
motion::MovingDisc disc_about(std::span<const motion::MovingDisc> discs) {
  motion::MovingDisc about = discs.front();
  const auto count = static_cast<double>(discs.size());
  about.centre0 = {};
  for (const motion::MovingDisc& disc : discs) {
    about.centre0.x_m += disc.centre0.x_m / count;
    about.centre0.y_m += disc.centre0.y_m / count;
  }
  about.radius0_m = 0.0;
  for (const motion::MovingDisc& disc : discs) {
    about.radius0_m = std::max(about.radius0_m, distance_m(about.centre0, disc.centre0) + disc.radius0_m);
    about.growth_m_s = std::max(about.growth_m_s, disc.growth_m_s);
  }
  return about;
}

}  // namespace

DiscSet::DiscSet(std::span<const Obstacle> obstacles, const LookAhead& look) {
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.is_guess && !look.takes_guesses) continue;
    const motion::MovingDisc disc = disc_left_by(obstacle, look);
    if (!is_out_of_reach(disc, look)) add(disc);
  }
  close_groups();
}

void DiscSet::add(const motion::MovingDisc& disc) {
  const bool goes_on = groups_count_ > 0 && discs_count_ - groups_[groups_count_ - 1].begin < most_in_group &&
                       drift_alike(discs_[discs_count_ - 1], disc);
  if (!goes_on) groups_[groups_count_++].begin = discs_count_;
  discs_[discs_count_++] = disc;
}

void DiscSet::close_groups() {
  for (std::size_t i = 0; i < groups_count_; ++i) {
    Group& group = groups_[i];
    group.end = i + 1 < groups_count_ ? groups_[i + 1].begin : discs_count_;
    group.about = disc_about({&discs_[group.begin], group.end - group.begin});
  }
}

std::optional<double> DiscSet::first_touch(const motion::EvenMove& move) const {
  std::optional<double> first;
  for (const Group& group : std::span{groups_.data(), groups_count_}) {
    const auto earliest = motion::first_touch(move, group.about);
    if (!earliest || (first && *earliest >= *first)) continue;
    for (std::size_t i = group.begin; i < group.end; ++i) {
      const auto touch = motion::first_touch(move, discs_[i]);
      if (touch && (!first || *touch < *first)) first = touch;
    }
  }
  return first;
}

bool DiscSet::is_touched(const motion::EvenMove& move) const {
  if (touched_last_ < discs_count_ && motion::first_touch(move, discs_[touched_last_])) return true;
  for (const Group& group : std::span{groups_.data(), groups_count_}) {
    if (!motion::first_touch(move, group.about)) continue;
    for (std::size_t i = group.begin; i < group.end; ++i) {
      if (!motion::first_touch(move, discs_[i])) continue;
      touched_last_ = i;
      return true;
    }
  }
  return false;
}

}  // namespace floeplan::avoidance
