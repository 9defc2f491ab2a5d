#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/tide/prediction.hpp"

namespace floeplan::ocean {

/// What a harmonic constant is one of.
enum class TideQuantity {
  elevation,  // of the sea surface over its mean, metres
  east,       // of the current, mean over the depth, m/s
  north
};

/// Harmonic constants of a tide model on a grid.
/// Shape    each field is [y][x], last index fastest, A exp(-i g) with the Greenwich phase lag g; NaN marks a missing
///          node inside the arrays; it never leaves the class
/// Outside  nullopt beyond the grid, and where no node around the place has a value. At a coast the nodes that have one
///          stand for those that have none
/// Errors   std::invalid_argument from the constructor when the sizes do not agree
/// Threads  const members may be called from several threads at once
class TideGrid {
 public:
  using Field = std::vector<std::complex<float>>;
  struct Line {
    tide::Constituent constituent;
    Field elevation;  // empty: the model has none
    Field east;       // the same; both components or none
    Field north;
  };
  struct Samples {
    HorizontalGrid grid;
    std::vector<Line> lines;
  };

  explicit TideGrid(Samples samples);

  [[nodiscard]] bool has(TideQuantity quantity) const;
  /// The constants of every constituent that has the quantity, in the order of the constituents.
  [[nodiscard]] std::optional<std::vector<tide::HarmonicConstant>> constants(TideQuantity quantity,
                                                                             geo::LonLat place) const;
  [[nodiscard]] const Samples& samples() const { return samples_; }

 private:
  Samples samples_;
};

/// The constants at a place from several models, each line from the first that has it, in the order of the lines'
/// names in the catalogue, and the minor lines that follow from them.
/// Outside  nullopt where no model has the quantity there, or one has a line of it that has no value there
[[nodiscard]] std::optional<std::vector<tide::HarmonicConstant>> joined_constants(
    const std::vector<TideGrid>& models, TideQuantity quantity, geo::LonLat place);

}  // namespace floeplan::ocean
