#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "engine/avoidance/obstacles.hpp"
#include "engine/motion/disc_encounter.hpp"

namespace floeplan::avoidance {

/// A query to the obstacles: place, period, clearance, and how far a vehicle can get in that period.
struct LookAhead {
  geo::PlanePoint from{};
  double now_s{};
  double until_s{};
  double clearance_m{};
  double reach_m{std::numeric_limits<double>::infinity()};
  bool takes_guesses{};  // includes surfaces that may exist behind those seen
};

/// The obstacles' discs for one look ahead, computed once for all moves tested in it. Neighbouring discs of
/// one object, in groups of up to eight, have a common outer disc, so that most are skipped as a group. Discs
/// out of reach are left out.
/// Memory   fixed; no member allocates
/// Threads  one at a time
class DiscSet {
 public:
  DiscSet(std::span<const Obstacle> obstacles, const LookAhead& look);

  /// The first time at which a vehicle on `move` is within a disc; empty: never.
  [[nodiscard]] std::optional<double> first_touch(const motion::EvenMove& move) const;
  /// Whether a move touches any disc; faster than `first_touch`.
  [[nodiscard]] bool is_touched(const motion::EvenMove& move) const;

 private:
  static constexpr std::size_t most_in_group = 8;

  /// Discs [begin, end), all with the same drift, and a disc that contains them.
  struct Group {
    motion::MovingDisc about{};
    std::size_t begin{};
    std::size_t end{};
  };

  void add(const motion::MovingDisc& disc);
  void close_groups();

  std::array<motion::MovingDisc, Obstacles::most> discs_;
  std::array<Group, Obstacles::most> groups_;
  std::size_t discs_count_{};
  std::size_t groups_count_{};
  mutable std::size_t touched_last_{};  // similar moves mostly touch the same disc
};

}  // namespace floeplan::avoidance
