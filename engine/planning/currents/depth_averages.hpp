#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/motion/plane_current.hpp"
#include "engine/ocean/currents/current_rows.hpp"
#include "engine/ocean/grids/axis.hpp"
#include "engine/planning/plane/fast_axis.hpp"
#include "engine/planning/plane/node_window.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::planning::currents {

/// Turns vectors from east and north into the axes of the plane, at one node.
struct NodeTurn {
  double cosine{1.0};
  double sine{};
};

/// Where a window of nodes has water, in some of its rows and at one time.
class WetLevels {
 public:
  /// `first_row`, `rows`  of the window, the rows that `water` holds
  WetLevels(const plane::NodeWindow& window, std::size_t first_row, std::size_t rows,
            const ocean::CurrentRows& water);

  /// How many levels have water, from the first one down.
  [[nodiscard]] std::size_t at(std::size_t ix, std::size_t iy) const {
    return counts_[(iy - first_row_) * columns_ + ix];
  }
  [[nodiscard]] std::size_t first_row() const { return first_row_; }
  friend bool operator==(const WetLevels&, const WetLevels&) = default;

 private:
  std::size_t first_row_;
  std::size_t columns_;
  std::vector<std::uint32_t> counts_;  // [y][x]
};

/// Mean currents over the depths flown at places, each a weighted sum of samples: each node's column by itself,
/// bilinear between the nodes. As long as the same levels have water, the sums are the same at every time.
/// Coast  a node without water takes the mean of its neighbours with water, one ring deep, because a model's
///        land mask is coarser than the coast
class DepthAverages {
 public:
  struct Place {
    plane::CellPosition x;
    plane::CellPosition y;
    vehicle::DiveBand band;
  };
  struct Mean {
    motion::CurrentXy current;
    bool extended{false};  // it rests on a node beyond the data's own coast
  };

  /// `turns`  one for each node of the window, [y][x]
  /// `wet`    its rows hold those of the places' cells and those beside them, as far as the window has them
  /// `water`  as those the means are asked for; its values do not matter
  DepthAverages(const std::vector<Place>& places, const std::optional<ocean::Axis>& levels_m,
                const plane::NodeWindow& window, const std::vector<NodeTurn>& turns, const WetLevels& wet,
                const ocean::CurrentRows& water);

  /// Empty where there is no water. `water`: of a time at which the same levels have water.
  [[nodiscard]] std::optional<Mean> at(std::size_t place, const ocean::CurrentRows& water) const;

 private:
  /// What one node's column counts in the mean at one place.
  struct Column {
    std::size_t first_sample;
    std::size_t first_weight;
    std::size_t levels;
    NodeTurn turn;  // times the node's share
  };
  struct Sum {
    std::size_t first_column;
    bool extended;
  };
  class Builder;

  std::size_t level_stride_;
  std::vector<double> weights_;
  std::vector<Column> columns_;
  std::vector<Sum> sums_;  // one for each place, and the end of the last one
};

}  // namespace floeplan::planning::currents
