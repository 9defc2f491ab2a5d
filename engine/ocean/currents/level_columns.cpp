#include "engine/ocean/currents/level_columns.hpp"

#include <array>
#include <utility>

namespace floeplan::ocean {
namespace {

struct DepthBand {
  double down_to_m;
  double step_m;
};

float blend_of(float a, float b, float share_of_b) {
  if (share_of_b <= 0.0F) return a;
  return share_of_b >= 1.0F ? b : a + share_of_b * (b - a);
}

}  // namespace

std::vector<double> standard_depths_m(double deepest_m) {
  constexpr std::array bands{DepthBand{100.0, 5.0}, DepthBand{500.0, 25.0}, DepthBand{2000.0, 50.0},
                             DepthBand{5500.0, 100.0}, DepthBand{12000.0, 500.0}};
  std::vector<double> depths{0.0};
  for (const DepthBand& band : bands)
    while (depths.back() < band.down_to_m && depths.back() < deepest_m)
      depths.push_back(depths.back() + band.step_m);
  return depths;
}

LevelColumns::LevelColumns(std::span<const double> depths_m, std::size_t points, Components components)
    : depths_m_{depths_m},
      next_(points, 0),
      filled_(depths_m.size(), PointVelocities{std::vector<float>(points, missing_sample),
                                               std::vector<float>(components == Components::both ? points : 0,
                                                                  missing_sample)}) {}

template <class Share>
void LevelColumns::fill(std::size_t point, double lower_m, const PointVelocities& upper,
                        const PointVelocities& lower, const Share& share_of_lower) {
  for (std::uint16_t& next = next_[point]; next < depths_m_.size() && depths_m_[next] <= lower_m; ++next) {
    const float share = static_cast<float>(share_of_lower(depths_m_[next]));
    filled_[next].east[point] = blend_of(upper.east[point], lower.east[point], share);
    if (!filled_[next].north.empty())
      filled_[next].north[point] = blend_of(upper.north[point], lower.north[point], share);
  }
}

void LevelColumns::add(PointVelocities level, std::vector<float> level_m) {
  for (std::size_t i = 0; i < next_.size(); ++i) {
    const double here_m = static_cast<double>(level_m[i]);
    if (above_m_.empty()) {
      fill(i, here_m, level, level, [](double) { return 1.0; });
      continue;
    }
    const double from_m = static_cast<double>(above_m_[i]);
    fill(i, here_m, above_, level,
         [&](double depth_m) { return here_m > from_m ? (depth_m - from_m) / (here_m - from_m) : 1.0; });
  }
  above_ = std::move(level);
  above_m_ = std::move(level_m);
}

std::vector<PointVelocities> LevelColumns::down_to(std::span<const float> bed_m) && {
  for (std::size_t i = 0; i < next_.size(); ++i)
    fill(i, static_cast<double>(bed_m[i]), above_, above_, [](double) { return 0.0; });
  return std::move(filled_);
}

}  // namespace floeplan::ocean
