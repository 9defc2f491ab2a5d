#include "engine/tide/nodal_factor.hpp"

#include <cmath>
#include <stdexcept>

namespace floeplan::tide {
namespace {

/// Coefficients of the series 1 + c1 cos N + c2 cos 2N + i (s1 sin N + s2 sin 2N).
struct NodeSeries {
  double c1{};
  double c2{};
  double s1{};
  double s2{};

  [[nodiscard]] std::complex<double> at(double node_rad) const {
    return {1.0 + c1 * std::cos(node_rad) + c2 * std::cos(2.0 * node_rad),
            s1 * std::sin(node_rad) + s2 * std::sin(2.0 * node_rad)};
  }
};

constexpr NodeSeries of_m2{-0.03731, 0.00052, -0.03731, 0.00052};

std::complex<double> to_the_three_halves(std::complex<double> factor) {
  return std::polar(std::pow(std::abs(factor), 1.5), 1.5 * std::arg(factor));
}

std::complex<double> of_m1(double perigee_rad, double node_rad) {
  return 1.0 + std::polar(0.36, -2.0 * perigee_rad) + std::polar(0.201, -node_rad) +
         std::polar(0.066, -2.0 * perigee_rad + node_rad);
}

std::complex<double> of_l2(double perigee_rad, double node_rad) {
  return 1.0 - std::polar(0.25, 2.0 * perigee_rad) - std::polar(0.11, 2.0 * perigee_rad - node_rad) -
         std::polar(0.04, node_rad);
}

}  // namespace

std::complex<double> nodal_factor(NodalClass nodal, const MeanLongitudes& longitudes) {
  const double node = core::degrees_to_radians(longitudes.lunar_node_deg);
  const double perigee = core::degrees_to_radians(longitudes.lunar_perigee_deg);
  switch (nodal) {
    case NodalClass::none: return 1.0;
    case NodalClass::mm: return NodeSeries{-0.130, 0.0, 0.0, 0.0}.at(node);
    case NodalClass::mf: return NodeSeries{0.414, 0.0387, -0.414, -0.0387}.at(node);
    case NodalClass::q1: return NodeSeries{0.188, 0.0, 0.188, 0.0}.at(node);
    case NodalClass::o1: return NodeSeries{0.189, -0.0058, 0.189, -0.0058}.at(node);
    case NodalClass::beta1: return NodeSeries{0.227, 0.0, 0.227, 0.0}.at(node);
    case NodalClass::m1: return of_m1(perigee, node);
    case NodalClass::chi1: return NodeSeries{0.221, 0.0, -0.221, 0.0}.at(node);
    case NodalClass::k1: return NodeSeries{0.1158, -0.0029, -0.1554, 0.0029}.at(node);
    case NodalClass::j1: return NodeSeries{0.169, 0.0, -0.227, 0.0}.at(node);
    case NodalClass::oo1: return NodeSeries{0.640, 0.134, -0.640, -0.134}.at(node);
    case NodalClass::m2: return of_m2.at(node);
    case NodalClass::m3: return to_the_three_halves(of_m2.at(node));
    case NodalClass::l2: return of_l2(perigee, node);
    case NodalClass::k2: return NodeSeries{0.2852, 0.0324, -0.3108, -0.0324}.at(node);
    case NodalClass::eta2: return NodeSeries{0.436, 0.0, -0.436, 0.0}.at(node);
  }
  throw std::logic_error{"NodalClass without a factor"};
}

}  // namespace floeplan::tide
