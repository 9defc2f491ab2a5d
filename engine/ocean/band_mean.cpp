#include "engine/ocean/band_mean.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::ocean {
namespace {

/// Sums up what layers of water, from the surface downwards, have in a band.
class BandSum {
 public:
  BandSum(core::Metres top, core::Metres bottom) : top_m_{top.value}, bottom_m_{bottom.value} {}

  void add(double depth_m, double east_m_s, double north_m_s) {
    const double from_m = std::max(above_m_, top_m_);
    const double to_m = std::min(depth_m, bottom_m_);
    if (to_m > from_m) {
      const double share = (0.5 * (from_m + to_m) - above_m_) / (depth_m - above_m_);
      east_m2_s_ += (to_m - from_m) * (east_above_ + share * (east_m_s - east_above_));
      north_m2_s_ += (to_m - from_m) * (north_above_ + share * (north_m_s - north_above_));
      thickness_m_ += to_m - from_m;
    }
    begin_layer(depth_m, east_m_s, north_m_s);
  }
  void begin_layer(double depth_m, double east_m_s, double north_m_s) {
    above_m_ = depth_m;
    east_above_ = east_m_s;
    north_above_ = north_m_s;
  }
  [[nodiscard]] bool is_done() const { return above_m_ >= bottom_m_; }
  [[nodiscard]] std::optional<geo::VelocityEn> mean() const {
    if (!(thickness_m_ > 0.0)) return std::nullopt;
    return geo::VelocityEn{{east_m2_s_ / thickness_m_}, {north_m2_s_ / thickness_m_}};
  }

 private:
  double top_m_;
  double bottom_m_;
  double above_m_{};
  double east_above_{};
  double north_above_{};
  double east_m2_s_{};
  double north_m2_s_{};
  double thickness_m_{};
};

/// Empty also where no layer of the data lies in the band.
std::optional<geo::VelocityEn> mean_of_samples(const CurrentGrid::Samples& samples, std::size_t node,
                                               std::size_t time_index, core::Metres top,
                                               core::Metres bottom) {
  const std::size_t slice = samples.grid.size();
  const std::size_t levels = samples.depths_m ? samples.depths_m->size() : 1;
  BandSum sum{top, bottom};
  std::size_t i = time_index * levels * slice + node;
  for (std::size_t level = 0; level < levels && !sum.is_done(); ++level, i += slice) {
    const auto east = static_cast<double>(samples.u[i]);
    const auto north = static_cast<double>(samples.v[i]);
    if (std::isnan(east) || std::isnan(north)) break;  // the sea bed
    if (level == 0) sum.begin_layer(0.0, east, north);
    sum.add(samples.depths_m ? std::max((*samples.depths_m)[level], 0.0) : 0.0, east, north);
  }
  return sum.mean();
}

}  // namespace

std::optional<geo::VelocityEn> band_mean_at_node(const CurrentGrid& currents, std::size_t ix, std::size_t iy,
                                                 std::size_t time_index, core::Metres top,
                                                 core::Metres bottom) {
  if (!currents.tide()) {
    const CurrentGrid::Samples& samples = currents.samples();
    const std::size_t node = iy * samples.grid.x().size() + ix;
    if (const auto mean = mean_of_samples(samples, node, time_index, top, bottom)) return mean;
  }
  const auto column = currents.column_at_node(ix, iy, time_index);
  if (!column) return std::nullopt;
  return column->mean(top, bottom);
}

}  // namespace floeplan::ocean
