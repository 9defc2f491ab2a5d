#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/ocean/currents/tide_grid.hpp"
#include "engine/ocean/grids/axis.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/tide/prediction.hpp"

namespace floeplan::ocean {

/// Tidal currents at the nodes of a grid and at evenly spaced times, the same at every depth. What depends on the time
/// alone is reckoned once for all nodes, so that a node and a time cost one product for each line.
/// Frame    towards true east and north
/// Outside  nullopt at a node where the tide has no constants
/// Threads  const members may be called from several threads at once
class TidalCurrents {
 public:
  /// Evenly spaced times, both ends included.
  struct Times {
    core::UtcTime from;
    core::Seconds step{};
    std::size_t count{};
  };

  /// Errors  std::invalid_argument for no times, or a step that is not above zero
  TidalCurrents(const HorizontalGrid& grid, const std::vector<TideGrid>& models, const Times& times);

  [[nodiscard]] const Axis& times_s() const { return times_s_; }
  [[nodiscard]] std::optional<geo::VelocityEn> at_node(std::size_t ix, std::size_t iy,
                                                       std::size_t time_index) const;
  [[nodiscard]] std::size_t known_nodes() const { return known_nodes_; }
  /// The names of the lines in use, inferred ones at the end.
  [[nodiscard]] const std::vector<tide::Constituent>& lines() const { return phasors_.constituents(); }

 private:
  struct Constant {
    std::complex<float> east;
    std::complex<float> north;
  };
  struct Nodes {
    std::vector<tide::Constituent> lines;
    std::vector<Constant> constants;  // [y][x][line]; NaN where the tide has none
    std::size_t known{};
  };
  TidalCurrents(std::size_t columns, Nodes nodes, const Times& times);
  static Nodes nodes_of(const HorizontalGrid& grid, const std::vector<TideGrid>& models);

  std::size_t columns_;
  std::size_t known_nodes_;
  std::vector<Constant> constants_;
  tide::PhasorTable phasors_;
  Axis times_s_;
};

/// The longest step of time, between five minutes and an hour, over which a straight line misses no tidal current of
/// the models by more than half a centimetre a second: a chord of length h misses A cos(w t) by at most A (w h)^2 / 8.
[[nodiscard]] core::Seconds straight_step(const std::vector<TideGrid>& models);

}  // namespace floeplan::ocean
