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

/// Rotates vectors from east-north to the axes of the plane, at one node.
struct NodeTurn {
  double cosine{1.0};
  double sine{};
};

/// Number of levels with water at the nodes of a window, in some of its rows and at one time.
class WetLevels {
 public:
  /// `first_row`, `rows`  the rows of the window that `water` holds
  WetLevels(const plane::NodeWindow& window, std::size_t first_row, std::size_t rows,
            const ocean::CurrentRows& water);

  /// The number of levels with water at a node, counted from the first level down.
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

/// Mean currents over the flown depths at places. Each is a weighted sum of samples: first over each node's
/// column, then bilinear between the nodes. The weights stay the same as long as the same levels have water.
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
    bool extended{false};  // its value uses a node without water of its own (see Coast)
  };

  /// `turns`  one for each node of the window, [y][x]
  /// `wet`    its rows include the cells of the places and the cells next to them, as far as the window
  /// reaches
  /// `water`  a slice with the same rows as in later calls of `at`; its values do not matter
  DepthAverages(const std::vector<Place>& places, const std::optional<ocean::Axis>& levels_m,
                const plane::NodeWindow& window, const std::vector<NodeTurn>& turns, const WetLevels& wet,
                const ocean::CurrentRows& water);

  /// Empty if there is no water. `water`: a slice in which the same levels have water as in the
  /// constructor's.
  [[nodiscard]] std::optional<Mean> at(std::size_t place, const ocean::CurrentRows& water) const;

 private:
  /// Weight of one node's column in the mean at one place.
  struct Column {
    std::size_t first_sample;
    std::size_t first_weight;
    std::size_t levels;
    NodeTurn turn;  // rotation times the node's weight
  };
  struct Sum {
    std::size_t first_column;
    bool extended;
  };
  class Builder;

  std::size_t level_stride_;
  std::vector<double> weights_;
  std::vector<Column> columns_;
  std::vector<Sum> sums_;  // one for each place, then an end marker
};

}  // namespace floeplan::planning::currents
