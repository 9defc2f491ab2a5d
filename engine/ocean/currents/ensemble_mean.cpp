#include "engine/ocean/currents/ensemble_mean.hpp"

#include <algorithm>
#include <functional>
#include <ranges>
#include <stdexcept>
#include <utility>

namespace floeplan::ocean {
namespace {

bool same_nodes(const Axis& a, const Axis& b) { return std::ranges::equal(a.nodes(), b.nodes()); }

bool same_nodes(const std::optional<Axis>& a, const std::optional<Axis>& b) {
  return a.has_value() == b.has_value() && (!a || same_nodes(*a, *b));
}

/// Two frames are equal if the outermost nodes lie at the same places.
bool same_places(const HorizontalGrid& a, const HorizontalGrid& b) {
  if (!same_nodes(a.x(), b.x()) || !same_nodes(a.y(), b.y())) return false;
  const std::size_t last_x = a.x().size() - 1;
  const std::size_t last_y = a.y().size() - 1;
  return a.place(0, 0) == b.place(0, 0) && a.place(last_x, last_y) == b.place(last_x, last_y) &&
         a.place(0, last_y) == b.place(0, last_y);
}

bool alike(const CurrentGrid& a, const CurrentGrid& b) {
  return same_places(a.samples().grid, b.samples().grid) &&
         same_nodes(a.samples().depths_m, b.samples().depths_m) &&
         same_nodes(a.samples().times_s, b.samples().times_s) && !a.tide() && !b.tide();
}

}  // namespace

std::optional<CurrentGrid> ensemble_mean(const std::vector<std::shared_ptr<const CurrentGrid>>& members) {
  if (members.empty()) throw std::invalid_argument{"a mean takes at least one member"};
  const CurrentGrid& first = *members.front();
  if (!std::ranges::all_of(members, [&](const auto& member) { return alike(first, *member); }))
    return std::nullopt;
  CurrentGrid::Samples mean = first.samples();
  const float share = 1.0F / static_cast<float>(members.size());
  for (const auto& member : members | std::views::drop(1)) {
    std::ranges::transform(mean.u, member->samples().u, mean.u.begin(), std::plus{});
    std::ranges::transform(mean.v, member->samples().v, mean.v.begin(), std::plus{});
  }
  for (float& u : mean.u) u *= share;
  for (float& v : mean.v) v *= share;
  return CurrentGrid{std::move(mean)};
}

}  // namespace floeplan::ocean
