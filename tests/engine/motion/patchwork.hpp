#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>

#include "engine/motion/quadratic_stretch.hpp"
#include "tests/support/property.hpp"

namespace floeplan::motion {

/// A random current on an edge with the structure of gridded data: linear between the nodes in place and
/// time, and in every cell an arch that is zero at the borders of the cell.
struct Patchwork {
  static constexpr std::size_t cells = 4;
  static constexpr std::size_t hours = 40;

  double cell_m{};
  std::array<std::array<CurrentOnEdge, cells + 1>, hours + 1> nodes;
  std::array<std::array<CurrentOnEdge, cells>, hours + 1> arches;  // at the middle of the cell

  Patchwork(std::mt19937_64& rng, double length_m, double strongest_m_s) : cell_m{length_m / cells} {
    const auto random = [&](double most) {
      return CurrentOnEdge{support::uniform(rng, -most, most), support::uniform(rng, -most, most)};
    };
    for (auto& hour : nodes) std::ranges::generate(hour, [&] { return random(strongest_m_s); });
    for (auto& hour : arches) std::ranges::generate(hour, [&] { return random(0.3 * strongest_m_s); });
  }

  /// The same current for the opposite direction of travel.
  [[nodiscard]] Patchwork reversed() const {
    Patchwork back = *this;
    const auto turn = [](auto& hour) {
      std::ranges::reverse(hour);
      for (CurrentOnEdge& c : hour) c = {-c.along_m_s, -c.across_m_s};
    };
    std::ranges::for_each(back.nodes, turn);
    std::ranges::for_each(back.arches, turn);
    return back;
  }

  [[nodiscard]] WayQuadratic quadratic(std::size_t hour, std::size_t cell) const {
    const double start_m = cell_m * static_cast<double>(cell);
    const auto component = [&](double CurrentOnEdge::* part) {
      const double slope = (nodes[hour][cell + 1].*part - nodes[hour][cell].*part) / cell_m;
      const double bend = -4.0 * arches[hour][cell].*part / (cell_m * cell_m);
      return std::array{nodes[hour][cell].*part - slope * start_m + bend * start_m * (start_m + cell_m),
                        slope - bend * (2.0 * start_m + cell_m), bend};
    };
    const auto along = component(&CurrentOnEdge::along_m_s);
    const auto across = component(&CurrentOnEdge::across_m_s);
    return {{along[0], across[0]}, {along[1], across[1]}, {along[2], across[2]}};
  }

  [[nodiscard]] QuadraticStretch stretch(std::size_t hour, std::size_t cell) const {
    const WayQuadratic before = quadratic(hour, cell);
    const WayQuadratic after = quadratic(hour + 1, cell);
    const auto rate = [](CurrentOnEdge a, CurrentOnEdge b) {
      return CurrentOnEdge{(b.along_m_s - a.along_m_s) / 3600.0, (b.across_m_s - a.across_m_s) / 3600.0};
    };
    return {.at_start = before,
            .per_second = {rate(before.constant, after.constant), rate(before.linear, after.linear),
                           rate(before.square, after.square)},
            .start_s = 3600.0 * static_cast<double>(hour),
            .end_way_m = cell_m * static_cast<double>(cell + 1),
            .end_s = 3600.0 * static_cast<double>(hour + 1)};
  }

  [[nodiscard]] CurrentOnEdge at(double way_m, double t_s) const {
    const auto cell = std::min(static_cast<std::size_t>(way_m / cell_m), cells - 1);
    const auto hour = std::min(static_cast<std::size_t>(t_s / 3600.0), hours - 1);
    return *stretch(hour, cell).at(way_m, t_s);
  }

  /// The current as the drive along the edge requests it.
  struct Line {
    const Patchwork& patchwork;
    std::size_t hour{};
    std::size_t cell{};
    QuadraticStretch current;

    explicit Line(const Patchwork& the_patchwork) : patchwork{the_patchwork} {}

    bool begin(core::Seconds depart) {
      hour = static_cast<std::size_t>(depart.count() / 3600.0);
      current = patchwork.stretch(hour, cell);
      return true;
    }
    [[nodiscard]] const QuadraticStretch& stretch() const { return current; }
    bool pass_way() {
      current = patchwork.stretch(hour, ++cell);
      return true;
    }
    bool pass_time() {
      if (++hour == hours) return false;
      current = patchwork.stretch(hour, cell);
      return true;
    }
  };
};

}  // namespace floeplan::motion
