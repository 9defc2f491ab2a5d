#include "engine/simulation/world/convex_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace floeplan::simulation {
namespace {

constexpr double unit_tolerance = 1e-6;
constexpr int most_sweeps = 400;
constexpr double settled_m =
    1e-4;  // largest change in the last sweep; the error that remains is far below a centimetre

double dot(const BodyPoint& a, const BodyPoint& b) {
  return a.along * b.along + a.across * b.across + a.down * b.down;
}

}  // namespace

ConvexPart::ConvexPart(std::vector<Face> faces) : faces_{std::move(faces)} {
  if (faces_.size() < 4) throw std::invalid_argument{"a solid has four faces or more"};
  for (const Face& face : faces_) {
    if (!(std::abs(dot(face.normal, face.normal) - 1.0) < unit_tolerance) || !std::isfinite(face.offset_m)) {
      throw std::invalid_argument{"a face needs a normal of unit length and a finite offset"};
    }
  }
}

double ConvexPart::plane_distance(BodyPoint point) const {
  double most = -std::numeric_limits<double>::infinity();
  for (const Face& face : faces_) most = std::max(most, dot(face.normal, point) - face.offset_m);
  return most;
}

double ConvexPart::distance(BodyPoint point) const {
  const double by_planes = plane_distance(point);
  if (by_planes <= 0.0) return by_planes;

  // The nearest point is the given one minus a sum of face normals with weights of at least zero. Adjusts one
  // weight after another until the point satisfies all planes.
  std::vector<double> weights(faces_.size(), 0.0);
  BodyPoint nearest = point;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double moved = 0.0;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Face& face = faces_[i];
      const double weight = std::max(0.0, weights[i] + dot(face.normal, nearest) - face.offset_m);
      const double change = weight - weights[i];
      weights[i] = weight;
      nearest = {nearest.along - change * face.normal.along, nearest.across - change * face.normal.across,
                 nearest.down - change * face.normal.down};
      moved = std::max(moved, std::abs(change));
    }
    if (moved < settled_m) break;
  }
  const BodyPoint away{point.along - nearest.along, point.across - nearest.across, point.down - nearest.down};
  return std::max(by_planes, std::sqrt(dot(away, away)));
}

std::optional<PartHit> ConvexPart::first_hit(BodyPoint origin, BodyPoint direction,
                                             double max_range_m) const {
  double enters_m = 0.0;
  double leaves_m = max_range_m;
  const Face* entered = nullptr;
  for (const Face& face : faces_) {
    const double outside_m = dot(face.normal, origin) - face.offset_m;
    const double outward = dot(face.normal, direction);
    if (outward == 0.0) {
      if (outside_m > 0.0) return std::nullopt;
      continue;
    }
    const double crossing_m = -outside_m / outward;
    if (outward < 0.0) {
      if (crossing_m > enters_m) {
        enters_m = crossing_m;
        entered = &face;
      }
    } else {
      leaves_m = std::min(leaves_m, crossing_m);
    }
    if (enters_m > leaves_m) return std::nullopt;
  }
  const BodyPoint back{-direction.along, -direction.across, -direction.down};
  return PartHit{.range_m = enters_m, .normal = entered != nullptr ? entered->normal : back};
}

}  // namespace floeplan::simulation
