#include "storage/demo/stream_function.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/core/units.hpp"
#include "storage/demo/flat_earth.hpp"

namespace floeplan::demo {
namespace {

constexpr double land_resistance = 1e6;

/// The nodes on the frame's edge, anticlockwise from the south-west corner, each once.
std::vector<std::size_t> edge_nodes(const RasterFrame& frame) {
  std::vector<std::size_t> nodes;
  for (std::size_t c = 0; c + 1 < frame.columns; ++c) nodes.push_back(frame.index(c, 0));
  for (std::size_t r = 0; r + 1 < frame.rows; ++r) nodes.push_back(frame.index(frame.columns - 1, r));
  for (std::size_t c = frame.columns - 1; c > 0; --c) nodes.push_back(frame.index(c, frame.rows - 1));
  for (std::size_t r = frame.rows - 1; r > 0; --r) nodes.push_back(frame.index(0, r));
  return nodes;
}

/// Adds a gate's inflow to the edge nodes: a smooth profile over the gate's sea nodes, whose sum is the
/// inflow.
void add_gate(const RasterFrame& frame, const std::vector<bool>& land, const std::vector<std::size_t>& edge,
              const Gate& gate, std::vector<double>& inflow) {
  std::vector<std::size_t> wet;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    if (!land[edge[i]] && geo::contains(gate.stretch, frame.centre(edge[i]))) wet.push_back(i);
  }
  if (wet.empty()) throw std::invalid_argument{"a gate lies on land"};
  double total = 0.0;
  std::vector<double> weights;
  for (std::size_t k = 0; k < wet.size(); ++k) {
    const double across = (static_cast<double>(k) + 0.5) / static_cast<double>(wet.size());
    weights.push_back(across * (1.0 - across));
    total += weights.back();
  }
  for (std::size_t k = 0; k < wet.size(); ++k) inflow[wet[k]] += gate.inflow * weights[k] / total;
}

/// Psi at each edge node: along the edge, anticlockwise, psi grows by the inflow.
std::vector<double> edge_psi(const RasterFrame& frame, const std::vector<bool>& land,
                             const std::vector<std::size_t>& edge, const std::vector<Gate>& gates) {
  double balance = 0.0;
  for (const Gate& gate : gates) balance += gate.inflow;
  if (std::abs(balance) > 1e-9) throw std::invalid_argument{"the gates let in more than out"};

  std::vector<double> inflow(edge.size());
  for (const Gate& gate : gates) add_gate(frame, land, edge, gate, inflow);
  std::vector<double> psi(edge.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    psi[i] = sum + 0.5 * inflow[i];
    sum += inflow[i];
  }
  return psi;
}

class Equations {
 public:
  Equations(const RasterFrame& frame, const std::vector<bool>& land, const std::vector<double>& resistance)
      : frame_{frame}, land_{land}, resistance_{resistance} {
    const FlatEarth earth{frame.lat_deg(frame.rows / 2)};
    dx_m_ = frame.step_lon_deg * earth.metres_per_degree_lon();
    dy_m_ = frame.step_lat_deg * metres_per_degree_lat;
  }

  [[nodiscard]] std::vector<double> solve(const std::vector<std::size_t>& edge,
                                          const std::vector<double>& at_edge,
                                          const std::vector<double>& spin) const {
    std::vector<double> psi(frame_.size());
    for (std::size_t i = 0; i < edge.size(); ++i) psi[edge[i]] = at_edge[i];

    const auto inner = static_cast<Eigen::Index>((frame_.columns - 2) * (frame_.rows - 2));
    Eigen::VectorXd right = Eigen::VectorXd::Zero(inner);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t r = 1; r + 1 < frame_.rows; ++r) {
      for (std::size_t c = 1; c + 1 < frame_.columns; ++c) {
        const std::size_t here = frame_.index(c, r);
        const Eigen::Index row = unknown(c, r);
        right[row] -= land_[here] ? 0.0 : spin[here];
        double diagonal = 0.0;
        const auto couple = [&](std::size_t nc, std::size_t nr, double step_m) {
          const double weight = between(here, frame_.index(nc, nr)) / (step_m * step_m);
          diagonal += weight;
          if (is_edge(nc, nr))
            right[row] += weight * psi[frame_.index(nc, nr)];
          else
            entries.emplace_back(row, unknown(nc, nr), -weight);
        };
        couple(c - 1, r, dx_m_);
        couple(c + 1, r, dx_m_);
        couple(c, r - 1, dy_m_);
        couple(c, r + 1, dy_m_);
        entries.emplace_back(row, row, diagonal);
      }
    }
    Eigen::SparseMatrix<double> matrix{inner, inner};
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors{matrix};
    const Eigen::VectorXd solution = factors.solve(right);
    for (std::size_t r = 1; r + 1 < frame_.rows; ++r) {
      for (std::size_t c = 1; c + 1 < frame_.columns; ++c) psi[frame_.index(c, r)] = solution[unknown(c, r)];
    }
    return psi;
  }

  /// Velocity from centred differences of psi; differences along the frame's edge are one-sided.
  [[nodiscard]] Flow flow(const std::vector<double>& psi) const {
    Flow flow{std::vector<double>(psi.size()), std::vector<double>(psi.size())};
    for (std::size_t i = 0; i < psi.size(); ++i) {
      if (land_[i]) continue;
      const std::size_t c = i % frame_.columns;
      const std::size_t r = i / frame_.columns;
      const std::size_t west = c > 0 ? c - 1 : c;
      const std::size_t east = std::min(c + 1, frame_.columns - 1);
      const std::size_t south = r > 0 ? r - 1 : r;
      const std::size_t north = std::min(r + 1, frame_.rows - 1);
      flow.north[i] = (psi[frame_.index(east, r)] - psi[frame_.index(west, r)]) /
                      (static_cast<double>(east - west) * dx_m_);
      flow.east[i] = -(psi[frame_.index(c, north)] - psi[frame_.index(c, south)]) /
                     (static_cast<double>(north - south) * dy_m_);
    }
    return flow;
  }

 private:
  [[nodiscard]] bool is_edge(std::size_t c, std::size_t r) const {
    return c == 0 || r == 0 || c + 1 == frame_.columns || r + 1 == frame_.rows;
  }
  [[nodiscard]] Eigen::Index unknown(std::size_t c, std::size_t r) const {
    return static_cast<Eigen::Index>((r - 1) * (frame_.columns - 2) + c - 1);
  }
  [[nodiscard]] double between(std::size_t a, std::size_t b) const {
    const double first = land_[a] ? land_resistance : resistance_[a];
    const double second = land_[b] ? land_resistance : resistance_[b];
    return 2.0 * first * second / (first + second);
  }

  const RasterFrame& frame_;
  const std::vector<bool>& land_;
  const std::vector<double>& resistance_;
  double dx_m_{};
  double dy_m_{};
};

}  // namespace

Flow stream_flow(const RasterFrame& frame, const std::vector<bool>& land,
                 const std::vector<double>& resistance, const std::vector<Gate>& gates,
                 const std::vector<double>& spin) {
  const std::vector<std::size_t> edge = edge_nodes(frame);
  const Equations equations{frame, land, resistance};
  return equations.flow(equations.solve(edge, edge_psi(frame, land, edge, gates), spin));
}

}  // namespace floeplan::demo
