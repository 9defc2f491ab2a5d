#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "engine/avoidance/obstacles.hpp"
#include "engine/motion/disc_encounter.hpp"

namespace floeplan::avoidance {

/// What someone at a place asks of the obstacles: for how long, how far off, and how far they may get by then.
struct LookAhead {
  geo::PlanePoint from{};
  double now_s{};
  double until_s{};
  double clearance_m{};
  double reach_m{std::numeric_limits<double>::infinity()};
  bool takes_guesses{};  // what may lie behind the surfaces seen, too
};

/// The obstacles' discs during one look ahead, made once for all the moves that are tried in it. Neighbours of one
/// object are held by a disc about them, so that most are passed over by the eight; those that nobody gets near are
/// left out.
/// Memory   fixed; no member allocates
/// Threads  one at a time
class DiscSet {
 public:
  DiscSet(std::span<const Obstacle> obstacles, const LookAhead& look);

  /// The first moment of a move within a disc; empty: never.
  [[nodiscard]] std::optional<double> first_touch(const motion::EvenMove& move) const;
  /// Whether a move touches any disc, and quicker than when.
  [[nodiscard]] bool is_touched(const motion::EvenMove& move) const;

 private:
  static constexpr std::size_t most_in_group = 8;

  /// Discs [begin, end), all of one drift, and the disc that holds them.
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
  mutable std::size_t touched_last_{};  // neighbouring moves mostly end at the same disc
};

}  // namespace floeplan::avoidance
