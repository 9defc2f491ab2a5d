#include "engine/reproduction/obstacle.hpp"

#include <algorithm>

namespace floeplan::reproduction {
namespace {

/// The range of a line, as shares of its length, within which one coordinate lies between two bounds.
struct Share {
  double first{0.0};
  double last{1.0};

  void cut(double from, double step, double low, double high) {
    if (step == 0.0) {
      if (from < low || from > high) last = -1.0;
      return;
    }
    const auto [enter, leave] = std::minmax({(low - from) / step, (high - from) / step});
    first = std::max(first, enter);
    last = std::min(last, leave);
  }
};

}  // namespace

bool Obstacle::meets(geo::PlanePoint a, geo::PlanePoint b) const {
  Share share;
  share.cut(a.x_m, b.x_m - a.x_m, low.x_m, high.x_m);
  share.cut(a.y_m, b.y_m - a.y_m, low.y_m, high.y_m);
  return share.first <= share.last;
}

const std::vector<Obstacle>& jet_obstacles() {
  static const std::vector<Obstacle> obstacles{
      {{4.67, -1.29}, {5.17, 3.32}},  {{1.83, 1.23}, {2.68, 3.30}},     {{-2.78, -2.31}, {-2.32, -0.30}},
      {{3.23, -3.68}, {3.63, -3.17}}, {{-6.59, -2.90}, {-5.57, -0.58}}, {{-2.30, 2.87}, {-1.18, 3.83}},
      {{0.93, -4.41}, {1.61, -2.20}}, {{-7.32, 0.80}, {-6.72, 2.28}},
  };
  return obstacles;
}

}  // namespace floeplan::reproduction
