#include "storage/ingest/readers/currents/zero_land.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::ingest {
namespace {

constexpr std::size_t smallest_patch_nodes = 9;
constexpr double smallest_patch_share = 0.01;

}  // namespace

ZeroLand::ZeroLand(std::size_t columns, std::size_t rows, std::size_t levels)
    : columns_{columns}, nodes_{columns * rows}, zero_(nodes_ * levels, true) {}

void ZeroLand::add(std::size_t level, std::span<const float> u, std::span<const float> v) {
  if (any_missing_) return;  // no land is found then
  for (std::size_t i = 0; i < nodes_; ++i) {
    if (std::isnan(u[i]) || std::isnan(v[i])) any_missing_ = true;
    if (u[i] != 0.0F || v[i] != 0.0F) zero_[level * nodes_ + i] = false;
  }
}

bool ZeroLand::everything_is_zero() const {
  return std::all_of(zero_.begin(), zero_.end(), [](bool zero) { return zero; });
}

double ZeroLand::share() const {
  const auto end = zero_.begin() + static_cast<std::ptrdiff_t>(nodes_);
  return static_cast<double>(std::count(zero_.begin(), end, true)) / static_cast<double>(nodes_);
}

bool ZeroLand::found() const {
  if (any_missing_ || everything_is_zero()) return false;
  const auto enough = static_cast<std::size_t>(smallest_patch_share * static_cast<double>(nodes_));
  return largest_patch() >= std::max(smallest_patch_nodes, enough);
}

std::size_t ZeroLand::largest_patch() const {
  std::vector<bool> open(zero_.begin(), zero_.begin() + static_cast<std::ptrdiff_t>(nodes_));
  std::vector<std::size_t> stack;
  std::size_t largest = 0;
  for (std::size_t seed = 0; seed < nodes_; ++seed) {
    if (!open[seed]) continue;
    open[seed] = false;
    stack.push_back(seed);
    std::size_t size = 0;
    const auto visit = [&](std::size_t node) {
      if (!open[node]) return;
      open[node] = false;
      stack.push_back(node);
    };
    while (!stack.empty()) {
      const std::size_t node = stack.back();
      stack.pop_back();
      ++size;
      if (node % columns_ > 0) visit(node - 1);
      if (node % columns_ + 1 < columns_) visit(node + 1);
      if (node >= columns_) visit(node - columns_);
      if (node + columns_ < nodes_) visit(node + columns_);
    }
    largest = std::max(largest, size);
  }
  return largest;
}

}  // namespace floeplan::ingest
