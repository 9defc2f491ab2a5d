#include "engine/ocean/grids/staggered_sampling.hpp"

#include <algorithm>
#include <cmath>

#include "engine/ocean/grids/cell_search.hpp"

namespace floeplan::ocean {
namespace {

constexpr double at_a_point = 1e-6;  // of a side: a node nearer than this lies on the side's end
constexpr float half_way = 1e-3F;    // of a side: this near to the middle both ends are equally near

/// Distance from the first end of a side, as a share; rounded to 0 or 1 at the ends.
float share_of(double share) {
  if (share < at_a_point) return 0.0F;
  return share > 1.0 - at_a_point ? 1.0F : static_cast<float>(share);
}

bool is_open(float value) { return value != 0.0F && !std::isnan(value); }

/// Interpolates between two neighbouring faces side by side, across the component's axis.
float across_axis(float near, float far, float share) {
  if (share == 0.0F) return near;
  if (share == 1.0F) return far;
  if (is_open(near) && is_open(far)) return near + share * (far - near);
  if (std::abs(share - 0.5F) > half_way) return share < 0.5F ? near : far;
  if (std::isnan(near)) return far;
  return std::isnan(far) ? near : 0.5F * (near + far);
}

/// Interpolates between two faces one behind the other, along the component's axis.
float along_axis(float behind, float ahead, float share) {
  if (share == 0.0F) return behind;
  if (share == 1.0F) return ahead;
  if (is_open(behind) && std::isnan(ahead)) return share <= 0.5F + half_way ? behind : missing_sample;
  if (is_open(ahead) && std::isnan(behind)) return share >= 0.5F - half_way ? ahead : missing_sample;
  return behind + share * (ahead - behind);
}

}  // namespace

class StaggeredSampling::Builder {
 public:
  Builder(const Mesh& mesh, const ComponentAxes& axes, const HorizontalGrid& grid)
      : axes_{axes}, search_{mesh, grid}, first_(search_.nodes()), second_(search_.nodes()) {}

  bool add_all() {
    return search_.visit(
        [&](const Mesh::Cell& cell, std::size_t node) {
          const Stencil& stencil = stencils_of(cell)[node];
          return stencil.cosine == 0.0F && stencil.sine == 0.0F;
        },
        [&](const Mesh::Cell& cell, const std::array<double, 4>& weights, std::size_t node,
            const SpherePlace& place) { stencils_of(cell)[node] = stencil_of(cell, weights, place); });
  }

  StaggeredSampling take() { return {std::move(first_), std::move(second_)}; }

 private:
  [[nodiscard]] bool is_of_first(const Mesh::Cell& cell) const {
    return !std::isnan(axes_.first_rad[cell[0]]);
  }
  std::vector<Stencil>& stencils_of(const Mesh::Cell& cell) { return is_of_first(cell) ? first_ : second_; }

  [[nodiscard]] Stencil stencil_of(const Mesh::Cell& cell, const std::array<double, 4>& weights,
                                   const SpherePlace& node) const {
    const std::vector<float>& angles_rad = is_of_first(cell) ? axes_.first_rad : axes_.second_rad;
    Stencil stencil{.point = cell,
                    .along = share_of(weights[1] + weights[2]),
                    .across = share_of(weights[2] + weights[3])};
    const auto along = static_cast<double>(stencil.along);
    const auto across = static_cast<double>(stencil.across);
    const std::array shares{(1.0 - along) * (1.0 - across), along * (1.0 - across), along * across,
                            (1.0 - along) * across};
    const auto at_node = [&](std::size_t corner) {
      const auto angle = static_cast<double>(angles_rad[cell[corner]]);
      const Turn turn = turn_between(search_.point(cell[corner]), node);
      const double cosine = std::cos(angle);
      const double sine = std::sin(angle);
      return Turn{turn.cosine * cosine + turn.sine * sine, turn.cosine * sine - turn.sine * cosine};
    };
    const auto nearest = static_cast<std::size_t>(std::ranges::max_element(shares) - shares.begin());
    const Turn guide = at_node(nearest);
    Turn sum;
    for (std::size_t corner = 0; corner < cell.size(); ++corner) {
      const Turn axis = at_node(corner);
      const double sign = axis.cosine * guide.cosine + axis.sine * guide.sine < 0.0 ? -1.0 : 1.0;
      stencil.sign[corner] = static_cast<float>(sign);
      if (shares[corner] == 0.0) continue;
      sum.cosine += shares[corner] * sign * axis.cosine;
      sum.sine += shares[corner] * sign * axis.sine;
    }
    const double length = std::hypot(sum.cosine, sum.sine);
    // The axes at the points differ in direction. Averaging their components shortens a uniform current by
    // this length.
    stencil.stretch = static_cast<float>(1.0 / length);
    stencil.cosine = static_cast<float>(sum.cosine / length);
    stencil.sine = static_cast<float>(sum.sine / length);
    return stencil;
  }

  const ComponentAxes& axes_;
  CellSearch search_;
  std::vector<Stencil> first_;
  std::vector<Stencil> second_;
};

std::optional<StaggeredSampling> StaggeredSampling::of(const Mesh& mesh, const ComponentAxes& axes,
                                                       const HorizontalGrid& grid) {
  Builder builder{mesh, axes, grid};
  if (!builder.add_all()) return std::nullopt;
  return builder.take();
}

StaggeredSampling::Flow StaggeredSampling::flow(const Stencil& stencil, std::span<const float> components) {
  if (stencil.cosine == 0.0F && stencil.sine == 0.0F) return {};
  const auto face = [&](std::size_t corner) {
    return stencil.stretch * stencil.sign[corner] * components[stencil.point[corner]];
  };
  const std::array values{face(0), face(1), face(2), face(3)};
  Flow result{.value = along_axis(across_axis(values[0], values[3], stencil.across),
                                  across_axis(values[1], values[2], stencil.across), stencil.along)};
  const bool nearer_is_first = stencil.across < 0.5F;
  const auto near = nearer_is_first ? std::pair{values[0], values[1]} : std::pair{values[3], values[2]};
  const auto beside = nearer_is_first ? std::pair{values[3], values[2]} : std::pair{values[0], values[1]};
  result.closed = near.first == 0.0F && near.second == 0.0F;
  result.moves_beside = is_open(beside.first) || is_open(beside.second);
  return result;
}

PointVelocities StaggeredSampling::apply(std::span<const float> components) const {
  PointVelocities out{std::vector<float>(first_.size(), missing_sample),
                      std::vector<float>(first_.size(), missing_sample)};
  for (std::size_t node = 0; node < first_.size(); ++node) {
    const Stencil& u_at = first_[node];
    const Stencil& v_at = second_[node];
    const Flow u = flow(u_at, components);
    const Flow v = flow(v_at, components);
    if (std::isnan(u.value) || std::isnan(v.value)) continue;
    if (u.closed && v.closed && (u.moves_beside || v.moves_beside)) continue;
    // Each component is the projection of the current on its axis. The two axes need not be perpendicular.
    constexpr float nearly_parallel = 0.5F;  // sine of 30 degrees; no model's axes are as close
    const float square = u_at.cosine * v_at.sine - u_at.sine * v_at.cosine;
    if (std::abs(square) < nearly_parallel) continue;
    out.east[node] = (u.value * v_at.sine - v.value * u_at.sine) / square;
    out.north[node] = (v.value * u_at.cosine - u.value * v_at.cosine) / square;
  }
  return out;
}

std::pair<std::vector<float>, std::vector<float>> StaggeredSampling::apply_to_numbers(
    std::span<const float> values) const {
  const auto at_nodes = [&](const std::vector<Stencil>& stencils) {
    std::vector<float> out;
    out.reserve(stencils.size());
    for (Stencil stencil : stencils) {
      stencil.sign = {1.0F, 1.0F, 1.0F, 1.0F};
      stencil.stretch = 1.0F;
      out.push_back(flow(stencil, values).value);
    }
    return out;
  };
  return {at_nodes(first_), at_nodes(second_)};
}

}  // namespace floeplan::ocean
