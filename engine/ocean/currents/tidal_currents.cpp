#include "engine/ocean/currents/tidal_currents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace floeplan::ocean {
namespace {

Axis axis_of(const TidalCurrents::Times& times) {
  if (times.count == 0 || !(times.step.count() > 0.0))
    throw std::invalid_argument{"tidal currents need times and a step above zero"};
  std::vector<double> nodes;
  nodes.reserve(times.count);
  for (std::size_t i = 0; i < times.count; ++i)
    nodes.push_back(core::unix_seconds(times.from + static_cast<double>(i) * times.step));
  return Axis{std::move(nodes)};
}

/// The tidal constituents for which any node may have constants. With the same models they are the same at
/// all nodes.
std::vector<tide::Constituent> lines_of(const std::vector<tide::HarmonicConstant>& constants) {
  std::vector<tide::Constituent> lines;
  lines.reserve(constants.size());
  for (const tide::HarmonicConstant& constant : constants) lines.push_back(constant.constituent);
  return lines;
}

}  // namespace

TidalCurrents::Nodes TidalCurrents::nodes_of(const HorizontalGrid& grid,
                                             const std::vector<TideGrid>& models) {
  constexpr float missing = std::numeric_limits<float>::quiet_NaN();
  std::vector<std::vector<Constant>> by_node(grid.size());
  Nodes nodes;
  for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
    for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
      const geo::LonLat place = grid.place(ix, iy);
      const auto east = joined_constants(models, TideQuantity::east, place);
      const auto north = joined_constants(models, TideQuantity::north, place);
      if (!east || !north) continue;
      if (nodes.lines.empty()) nodes.lines = lines_of(*east);
      auto& constants = by_node[iy * grid.x().size() + ix];
      for (std::size_t i = 0; i < nodes.lines.size(); ++i)
        constants.push_back({std::complex<float>{(*east)[i].value}, std::complex<float>{(*north)[i].value}});
      ++nodes.known;
    }
  }
  nodes.constants.assign(grid.size() * nodes.lines.size(), {{missing, missing}, {missing, missing}});
  for (std::size_t node = 0; node < by_node.size(); ++node)
    std::ranges::copy(by_node[node],
                      nodes.constants.begin() + static_cast<std::ptrdiff_t>(node * nodes.lines.size()));
  return nodes;
}

TidalCurrents::TidalCurrents(const HorizontalGrid& grid, const std::vector<TideGrid>& models,
                             const Times& times)
    : TidalCurrents{grid.x().size(), nodes_of(grid, models), times} {}

TidalCurrents::TidalCurrents(std::size_t columns, Nodes nodes, const Times& times)
    : columns_{columns},
      known_nodes_{nodes.known},
      constants_{std::move(nodes.constants)},
      phasors_{std::move(nodes.lines), times.from, times.step, times.count},
      times_s_{axis_of(times)} {}

std::optional<geo::VelocityEn> TidalCurrents::at_node(std::size_t ix, std::size_t iy,
                                                      std::size_t time_index) const {
  const auto phasors = phasors_.at(time_index);
  if (phasors.empty()) return std::nullopt;
  const Constant* constant = constants_.data() + (iy * columns_ + ix) * phasors.size();
  double east = 0.0;
  double north = 0.0;
  for (const std::complex<double>& phasor : phasors) {
    east += static_cast<double>(constant->east.real()) * phasor.real() -
            static_cast<double>(constant->east.imag()) * phasor.imag();
    north += static_cast<double>(constant->north.real()) * phasor.real() -
             static_cast<double>(constant->north.imag()) * phasor.imag();
    ++constant;
  }
  if (std::isnan(east)) return std::nullopt;
  return geo::VelocityEn{{east}, {north}};
}

core::Seconds straight_step(const std::vector<TideGrid>& models) {
  constexpr double most_missed_m_s = 0.005;
  constexpr double shortest_s = 300.0;
  constexpr double longest_s = 3600.0;
  double bend_m_s3 = 0.0;  // largest second derivative in time of any current
  for (const TideGrid& model : models) {
    std::vector<double> bends(model.samples().grid.size(), 0.0);
    for (const TideGrid::Line& line : model.samples().lines) {
      const double speed = tide::angular_speed(line.constituent);
      for (std::size_t i = 0; i < line.east.size(); ++i) {
        const double amplitude = std::hypot(std::abs(line.east[i]), std::abs(line.north[i]));
        if (!std::isnan(amplitude)) bends[i] += amplitude * speed * speed;
      }
    }
    if (!bends.empty()) bend_m_s3 = std::max(bend_m_s3, std::ranges::max(bends));
  }
  if (bend_m_s3 == 0.0) return core::Seconds{longest_s};
  return core::Seconds{std::clamp(std::sqrt(8.0 * most_missed_m_s / bend_m_s3), shortest_s, longest_s)};
}

}  // namespace floeplan::ocean
