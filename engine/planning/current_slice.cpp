#include "engine/planning/current_slice.hpp"

#include <algorithm>

#include "engine/ocean/band_mean.hpp"

namespace floeplan::planning {

CurrentSlice::CurrentSlice(const ocean::CurrentGrid& currents, const NodeWindow& window,
                           const std::vector<NodeTurn>& turns, std::size_t time_index)
    : currents_{currents}, window_{window}, turns_{turns}, time_index_{time_index}, answers_(window.size()) {}

std::optional<motion::CurrentXy> CurrentSlice::turned(std::size_t ix, std::size_t iy,
                                                      const vehicle::DiveBand& band) const {
  const auto mean = ocean::band_mean_at_node(currents_, window_.columns[ix], window_.first_row + iy,
                                             time_index_, band.top, band.bottom);
  if (!mean) return std::nullopt;
  const NodeTurn& turn = turns_[iy * window_.x.size() + ix];
  return motion::CurrentXy{mean->east.value * turn.cosine - mean->north.value * turn.sine,
                           mean->east.value * turn.sine + mean->north.value * turn.cosine};
}

const std::optional<CurrentSlice::Mean>& CurrentSlice::at_node(std::size_t ix, std::size_t iy,
                                                               const vehicle::DiveBand& band) {
  std::optional<Answer>& answer = answers_[iy * window_.x.size() + ix];
  if (!answer || answer->band != band) answer = Answer{band, worked_out(ix, iy, band)};
  return answer->mean;
}

std::optional<CurrentSlice::Mean> CurrentSlice::worked_out(std::size_t ix, std::size_t iy,
                                                           const vehicle::DiveBand& band) const {
  const std::size_t nx = window_.x.size();
  const std::size_t ny = window_.y.size();
  if (const auto own = turned(ix, iy, band)) return Mean{*own, false};
  motion::CurrentXy sum{0.0, 0.0};
  int wet = 0;
  for (std::size_t jy = iy > 0 ? iy - 1 : 0; jy <= std::min(iy + 1, ny - 1); ++jy) {
    for (std::size_t jx = ix > 0 ? ix - 1 : 0; jx <= std::min(ix + 1, nx - 1); ++jx) {
      const auto neighbour = turned(jx, jy, band);
      if (!neighbour) continue;
      sum.x_m_s += neighbour->x_m_s;
      sum.y_m_s += neighbour->y_m_s;
      ++wet;
    }
  }
  if (wet == 0) return std::nullopt;
  return Mean{{sum.x_m_s / wet, sum.y_m_s / wet}, true};
}

std::optional<CurrentSlice::Mean> CurrentSlice::mean(const CellPosition& x, const CellPosition& y,
                                                     const vehicle::DiveBand& band) {
  Mean result;
  for (const std::size_t up : {0U, 1U}) {
    for (const std::size_t right : {0U, 1U}) {
      const double weight = (up == 1 ? y.share : 1.0 - y.share) * (right == 1 ? x.share : 1.0 - x.share);
      if (weight == 0.0) continue;
      const auto& node = at_node(x.cell + right, y.cell + up, band);
      if (!node) return std::nullopt;
      result.current.x_m_s += weight * node->current.x_m_s;
      result.current.y_m_s += weight * node->current.y_m_s;
      result.extended = result.extended || node->extended;
    }
  }
  return result;
}

}  // namespace floeplan::planning
