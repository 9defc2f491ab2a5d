#include "engine/ocean/currents/tide_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/tide/minor_constituents.hpp"

namespace floeplan::ocean {
namespace {

const TideGrid::Field& field_of(const TideGrid::Line& line, TideQuantity quantity) {
  switch (quantity) {
    case TideQuantity::elevation: return line.elevation;
    case TideQuantity::east: return line.east;
    case TideQuantity::north: return line.north;
  }
  throw std::logic_error{"TideQuantity without a field"};
}

/// Bilinear interpolation over those nodes that have a value.
std::optional<std::complex<double>> at_position(const TideGrid::Field& field, std::size_t nx,
                                                const GridPosition& at) {
  const std::array corners{
      std::pair{at.y.lower * nx + at.x.lower, (1.0 - at.x.fraction) * (1.0 - at.y.fraction)},
      std::pair{at.y.lower * nx + at.x.upper, at.x.fraction * (1.0 - at.y.fraction)},
      std::pair{at.y.upper * nx + at.x.lower, (1.0 - at.x.fraction) * at.y.fraction},
      std::pair{at.y.upper * nx + at.x.upper, at.x.fraction * at.y.fraction}};
  std::complex<double> sum{};
  double weights = 0.0;
  for (const auto& [node, weight] : corners) {
    if (weight == 0.0 || std::isnan(field[node].real())) continue;
    sum += weight * std::complex<double>{field[node]};
    weights += weight;
  }
  if (weights == 0.0) return std::nullopt;
  return sum / weights;
}

}  // namespace

TideGrid::TideGrid(Samples samples) : samples_{std::move(samples)} {
  const std::size_t size = samples_.grid.size();
  for (const Line& line : samples_.lines) {
    const auto fits = [&](const Field& field) { return field.empty() || field.size() == size; };
    if (!fits(line.elevation) || !fits(line.east) || line.east.size() != line.north.size())
      throw std::invalid_argument{"a line of a tide needs one constant for each node"};
  }
}

bool TideGrid::has(TideQuantity quantity) const {
  return std::ranges::any_of(samples_.lines,
                             [&](const Line& line) { return !field_of(line, quantity).empty(); });
}

std::optional<std::vector<tide::HarmonicConstant>> TideGrid::constants(TideQuantity quantity,
                                                                       geo::LonLat place) const {
  const auto position = samples_.grid.locate(place);
  if (!position) return std::nullopt;
  std::vector<tide::HarmonicConstant> result;
  for (const Line& line : samples_.lines) {
    const Field& field = field_of(line, quantity);
    if (field.empty()) continue;
    const auto value = at_position(field, samples_.grid.x().size(), *position);
    if (!value) return std::nullopt;
    result.push_back({line.constituent, *value});
  }
  if (result.empty()) return std::nullopt;
  return result;
}

std::optional<std::vector<tide::HarmonicConstant>> joined_constants(const std::vector<TideGrid>& models,
                                                                    TideQuantity quantity,
                                                                    geo::LonLat place) {
  std::vector<tide::HarmonicConstant> result;
  for (const TideGrid& model : models) {
    if (!model.has(quantity)) continue;
    const auto constants = model.constants(quantity, place);
    if (!constants) return std::nullopt;
    for (const tide::HarmonicConstant& constant : *constants)
      if (std::ranges::find(result, constant.constituent, &tide::HarmonicConstant::constituent) ==
          result.end())
        result.push_back(constant);
  }
  if (result.empty()) return std::nullopt;
  std::ranges::sort(result, {}, &tide::HarmonicConstant::constituent);
  return tide::with_minors(std::move(result));
}

}  // namespace floeplan::ocean
