#include "storage/ingest/grids/true_north.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floeplan::ingest {

GridDirections GridDirections::along_east(std::size_t points) {
  return {std::vector<float>(points, 1.0F), std::vector<float>(points, 0.0F)};
}

void GridDirections::add(std::optional<double> angle) {
  cosine.push_back(static_cast<float>(std::cos(angle.value_or(0.0))));
  sine.push_back(static_cast<float>(std::sin(angle.value_or(0.0))));
}

void GridDirections::set(std::size_t point, double angle) {
  cosine[point] = static_cast<float>(std::cos(angle));
  sine[point] = static_cast<float>(std::sin(angle));
}

double GridDirections::largest_turn_deg() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < cosine.size(); ++i) {
    const double turn = std::abs(std::atan2(static_cast<double>(sine[i]), static_cast<double>(cosine[i])));
    largest = std::max(largest, turn);
  }
  return largest * 180.0 / std::numbers::pi;
}

}  // namespace floeplan::ingest
