#include "tests/bench/calibration.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/bench/report.hpp"

namespace floeplan::bench {
namespace {

constexpr int calibration_side = 1'000;

/// Travel time in a tidal current: never zero, different everywhere, and expensive to compute.
double time_of_edge(int column, int row, int dx, int dy, double depart) {
  const double current = 0.3 * std::sin(0.013 * column + 1e-3 * depart) * std::cos(0.017 * row);
  const double length = std::sqrt(static_cast<double>(dx * dx + dy * dy));
  return length / (0.4 + current * dx / length);
}

double farthest_arrival() {
  using Entry = std::pair<double, std::int32_t>;
  std::vector<double> arrival(static_cast<std::size_t>(calibration_side) * calibration_side,
                              std::numeric_limits<double>::infinity());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  arrival[0] = 0.0;
  queue.emplace(0.0, 0);
  double farthest = 0.0;
  while (!queue.empty()) {
    const auto [time, vertex] = queue.top();
    queue.pop();
    if (time > arrival[static_cast<std::size_t>(vertex)]) continue;
    farthest = time;
    const int column = vertex % calibration_side;
    const int row = vertex / calibration_side;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = column + dx;
        const int y = row + dy;
        if ((dx == 0 && dy == 0) || x < 0 || y < 0 || x >= calibration_side || y >= calibration_side)
          continue;
        const std::int32_t head = y * calibration_side + x;
        const double then = time + time_of_edge(column, row, dx, dy, time);
        if (then >= arrival[static_cast<std::size_t>(head)]) continue;
        arrival[static_cast<std::size_t>(head)] = then;
        queue.emplace(then, head);
      }
    }
  }
  return farthest;
}

}  // namespace

double calibration_seconds() {
  return least_seconds(2, [] {
    if (!(farthest_arrival() > calibration_side))
      throw std::logic_error{"the calibration loop was cut short"};
  });
}

}  // namespace floeplan::bench
