#include "storage/ingest/grids/depth_columns.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#include "storage/ingest/common/missing_value.hpp"

namespace floeplan::ingest {
namespace {

struct Band {
  double down_to_m;
  double step_m;
};

/// Fills a column downwards: every depth not yet filled that lies between two levels.
class ColumnFiller {
 public:
  ColumnFiller(std::span<const double> depths_m, std::size_t points)
      : depths_m_{depths_m},
        next_(points, 0),
        slices_(depths_m.size(),
                VelocitySlice{std::vector<float>(points, missing), std::vector<float>(points, missing), 0}) {}

  /// Depths of one point down to `lower_m`; `share_of_lower` of a depth gives the weight of the lower level.
  template <class Share>
  void fill(std::size_t point, double lower_m, const VelocitySlice& upper, const VelocitySlice& lower,
            const Share& share_of_lower) {
    for (std::uint16_t& next = next_[point]; next < depths_m_.size() && depths_m_[next] <= lower_m; ++next) {
      const float share = static_cast<float>(share_of_lower(depths_m_[next]));
      const auto blend = [share](float a, float b) {
        if (share <= 0.0F) return a;
        return share >= 1.0F ? b : a + share * (b - a);
      };
      slices_[next].east[point] = blend(upper.east[point], lower.east[point]);
      slices_[next].north[point] = blend(upper.north[point], lower.north[point]);
    }
  }

  std::vector<VelocitySlice> take() { return std::move(slices_); }

 private:
  std::span<const double> depths_m_;
  std::vector<std::uint16_t> next_;  // the first depth not yet filled
  std::vector<VelocitySlice> slices_;
};

}  // namespace

std::vector<double> standard_depths_m(double deepest_m) {
  constexpr std::array bands{Band{100.0, 5.0}, Band{500.0, 25.0}, Band{2000.0, 50.0}, Band{5500.0, 100.0},
                             Band{12000.0, 500.0}};
  std::vector<double> depths{0.0};
  for (const Band& band : bands)
    while (depths.back() < band.down_to_m && depths.back() < deepest_m)
      depths.push_back(depths.back() + band.step_m);
  return depths;
}

Checked<std::vector<VelocitySlice>> currents_at_depths(const VelocitySource& source, const LevelReader& read,
                                                       std::size_t time, std::span<const double> depths_m) {
  const std::size_t points = source.shape().points();
  const std::size_t levels = source.shape().levels;
  ColumnFiller filler{depths_m, points};
  VelocitySlice above;
  std::vector<float> above_m;
  for (std::size_t level = 0; level < levels; ++level) {
    auto slice = read(level);
    if (!slice) return refuse(slice.error());
    auto level_m = source.level_depths(time, level);
    if (!level_m) return refuse(level_m.error());
    for (std::size_t i = 0; i < points; ++i) {
      const double here_m = static_cast<double>((*level_m)[i]);
      if (level == 0) {
        filler.fill(i, here_m, *slice, *slice, [](double) { return 1.0; });
        continue;
      }
      const double from_m = static_cast<double>(above_m[i]);
      filler.fill(i, here_m, above, *slice, [&](double depth_m) {
        return here_m > from_m ? (depth_m - from_m) / (here_m - from_m) : 1.0;
      });
    }
    above = std::move(*slice);
    above_m = std::move(*level_m);
  }
  const auto bed_m = source.level_depths(time, levels);
  if (!bed_m) return refuse(bed_m.error());
  for (std::size_t i = 0; i < points; ++i)
    filler.fill(i, static_cast<double>((*bed_m)[i]), above, above, [](double) { return 0.0; });
  return filler.take();
}

}  // namespace floeplan::ingest
