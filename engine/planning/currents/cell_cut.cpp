#include "engine/planning/currents/cell_cut.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace floeplan::planning::currents {
namespace {

/// Number of parts into which a side of a cell is cut: the usual and the largest one. Memory and time grow
/// with it.
constexpr int usual_parts = 4;
constexpr int most_parts = 16;
constexpr std::size_t most_nodes = 1 << 22;        // limit over all times: 32 MB
constexpr std::size_t most_trial_nodes = 1 << 18;  // limit at one time: some tens of milliseconds

std::vector<vehicle::DiveBand> bands_over(const FlownDepths& depths, const geo::GridFrame& frame,
                                          const plane::NodeWindow& window, int parts) {
  const geo::FrameProjection projection{frame};
  std::vector<vehicle::DiveBand> bands;
  for (const double y : cut_axis(window.y, parts)) {
    for (const double x : cut_axis(window.x, parts))
      bands.push_back(depths.at(projection.to_lon_lat({x, y})));
  }
  return bands;
}

/// Mean currents at all nodes of a finer lattice, at one time.
class Lattice {
 public:
  Lattice(const ocean::CurrentGrid& currents, const plane::NodeWindow& window,
          const std::vector<NodeTurn>& turns, const CellCut& cut, std::size_t time)
      : nx_{(window.x.size() - 1) * static_cast<std::size_t>(cut.parts) + 1} {
    const ocean::CurrentRows water{currents, time, window.first_row, window.y.size()};
    const WetLevels wet{window, 0, window.y.size(), water};
    std::vector<DepthAverages::Place> places;
    places.reserve(cut.bands.size());
    for (std::size_t i = 0; i < cut.bands.size(); ++i)
      places.push_back({on_uncut(i % nx_, cut.parts, window.x.size()),
                        on_uncut(i / nx_, cut.parts, window.y.size()), cut.bands[i]});
    const DepthAverages means{places, currents.samples().depths_m, window, turns, wet, water};
    means_.reserve(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto mean = means.at(i, water);
      means_.push_back(mean ? mean->current : motion::CurrentXy{NAN, NAN});
    }
  }

  /// The largest error of a bilinear interpolation between every `step`-th node, at the nodes between.
  [[nodiscard]] double most_missed_m_s(std::size_t step) const {
    const std::size_t ny = means_.size() / nx_;
    double most = 0.0;
    for (std::size_t iy = 0; iy < ny; ++iy) {
      for (std::size_t ix = 0; ix < nx_; ++ix) {
        const double missed = missed_m_s(ix, iy, step);
        if (missed > most) most = missed;  // false for NaN, where there is no water
      }
    }
    return most;
  }

 private:
  [[nodiscard]] double missed_m_s(std::size_t ix, std::size_t iy, std::size_t step) const {
    const std::size_t west = ix - ix % step;
    const std::size_t south = iy - iy % step;
    const std::size_t east = ix == west ? west : west + step;
    const std::size_t north = iy == south ? south : south + step;
    const double fx = static_cast<double>(ix - west) / static_cast<double>(step);
    const double fy = static_cast<double>(iy - south) / static_cast<double>(step);
    const auto between = [&](auto member) {
      const auto at = [&](std::size_t x, std::size_t y) { return means_[y * nx_ + x].*member; };
      return std::lerp(std::lerp(at(west, south), at(east, south), fx),
                       std::lerp(at(west, north), at(east, north), fx), fy) -
             at(ix, iy);
    };
    return std::hypot(between(&motion::CurrentXy::x_m_s), between(&motion::CurrentXy::y_m_s));
  }

  std::size_t nx_;
  std::vector<motion::CurrentXy> means_;  // [y][x]; NaN: no water
};

}  // namespace

std::vector<double> cut_axis(const std::vector<double>& nodes, int parts) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    for (int part = 0; part < parts; ++part)
      result.push_back(nodes[i] + (nodes[i + 1] - nodes[i]) * part / parts);
  }
  result.push_back(nodes.back());
  return result;
}

plane::CellPosition on_uncut(std::size_t i, int parts, std::size_t nodes) {
  const std::size_t cell = i / static_cast<std::size_t>(parts);
  const double share = static_cast<double>(i % static_cast<std::size_t>(parts)) / parts;
  return cell + 1 < nodes ? plane::CellPosition{cell, share} : plane::CellPosition{nodes - 1, 0.0};
}

CellCut cut_cells(const ocean::CurrentGrid& currents, const FlownDepths& depths,
                  const plane::NodeWindow& window, const std::vector<NodeTurn>& turns, std::size_t slices,
                  const std::stop_token& stop) {
  const ocean::HorizontalGrid& grid = currents.samples().grid;
  if (!depths.bathymetry()) return {1, std::vector(window.size(), depths.at(grid.place(0, 0)))};
  const double of_bathymetry = std::ceil(grid.spacing() / depths.bathymetry()->grid().spacing());
  const auto fits = [&](int parts, std::size_t times, std::size_t most) {
    return window.size() * static_cast<std::size_t>(parts * parts) * times <= most;
  };
  int parts = static_cast<int>(std::clamp(of_bathymetry, 1.0, static_cast<double>(usual_parts)));

  int finest = parts;
  while (finest < of_bathymetry && finest < most_parts && fits(2 * finest, 1, most_trial_nodes)) finest *= 2;
  CellCut cut{finest, bands_over(depths, grid.frame(), window, finest)};
  const bool same =
      std::ranges::all_of(cut.bands, [&](const auto& band) { return band == cut.bands.front(); });
  if (same) return {1, std::vector(window.size(), cut.bands.front())};
  if (finest > parts) {
    const std::size_t times = currents.times_s().size();
    for (const std::size_t time : {std::size_t{0}, std::min(times, slices) / 2}) {
      if (stop.stop_requested()) break;
      const Lattice lattice{currents, window, turns, cut, time};
      while (parts < finest &&
             lattice.most_missed_m_s(static_cast<std::size_t>(finest / parts)) > most_missed_at_banks.value)
        parts *= 2;
    }
  }
  while (parts > 1 && !fits(parts, slices, most_nodes)) --parts;
  if (parts == finest) return cut;
  return {parts, bands_over(depths, grid.frame(), window, parts)};
}

}  // namespace floeplan::planning::currents
