#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/grids/axis.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/ice/ice_moment.hpp"

namespace floeplan::ocean {

/// Sea ice at one place and one time.
struct IceState {
  double concentration{};                 // share of the sea surface covered, 0 to 1
  std::optional<core::Metres> thickness;  // of level ice, from its top to its underside; empty if the data
                                          // have none
};

/// Sea ice of a model or an analysis on a grid; bilinear in place, linear in time.
/// Shape    concentration and thickness_m are [time][y][x], last index fastest; thickness_m may be empty: the
///          data have none. NaN marks a missing sample inside the arrays; no function returns it
/// Units    concentration from 0 to 1, thickness in metres
/// Outside  nullopt if a needed concentration is missing (land, the gap around the pole in a satellite's
///          orbit), outside the grid, outside the times and between two times that are further apart than
///          longest_ice_gap; never extrapolates
/// Errors   std::invalid_argument from the constructor if the sizes of the arrays differ, and for arguments
///          that are not finite
/// Threads  const members may be called from several threads at once
class IceField {
 public:
  struct Samples {
    HorizontalGrid grid;
    Axis times_s;  // seconds since 1970-01-01T00:00:00Z
    std::vector<float> concentration;
    std::vector<float> thickness_m;
  };

  explicit IceField(Samples samples);

  [[nodiscard]] std::optional<IceState> at(geo::LonLat place, core::UtcTime time) const;
  [[nodiscard]] const Samples& samples() const { return samples_; }
  [[nodiscard]] std::size_t bytes() const {
    return (samples_.concentration.size() + samples_.thickness_m.size()) * sizeof(float);
  }

 private:
  Samples samples_;
};

}  // namespace floeplan::ocean
