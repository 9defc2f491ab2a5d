#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/tide/prediction.hpp"

namespace floeplan::ocean {

/// The quantity that a harmonic constant describes.
enum class TideQuantity {
  elevation,  // of the sea surface over its mean, metres
  east,       // of the current, mean over the depth, m/s
  north
};

/// Harmonic constants of a tide model on a grid.
/// Shape    each field is [y][x], last index fastest, A exp(-i g) with the Greenwich phase lag g; NaN marks a
///          missing node inside the arrays; no function returns it
/// Outside  nullopt outside the grid, and if no node around the place has a value. At a coast the nodes with
///          a value also count for those without
/// Errors   std::invalid_argument from the constructor if the sizes of the arrays differ
/// Threads  const members may be called from several threads at once
class TideGrid {
 public:
  using Field = std::vector<std::complex<float>>;
  struct Line {
    tide::Constituent constituent;
    Field elevation;  // empty: the model has no elevations
    Field east;       // empty: the model has no currents; both components or none
    Field north;
  };
  struct Samples {
    HorizontalGrid grid;
    std::vector<Line> lines;
  };

  explicit TideGrid(Samples samples);

  [[nodiscard]] bool has(TideQuantity quantity) const;
  /// The constants at a place for every constituent with this quantity, in the order of the constituents.
  [[nodiscard]] std::optional<std::vector<tide::HarmonicConstant>> constants(TideQuantity quantity,
                                                                             geo::LonLat place) const;
  [[nodiscard]] const Samples& samples() const { return samples_; }

 private:
  Samples samples_;
};

/// The constants at a place from several models: each constituent from the first model that has it, in the
/// order of the catalogue of constituents, then the minor constituents inferred from them.
/// Outside  nullopt if no model has the quantity at the place, or if a model has a constituent of the
///          quantity but no value for it at the place
[[nodiscard]] std::optional<std::vector<tide::HarmonicConstant>> joined_constants(
    const std::vector<TideGrid>& models, TideQuantity quantity, geo::LonLat place);

}  // namespace floeplan::ocean
