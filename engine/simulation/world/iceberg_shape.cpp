#include "engine/simulation/world/iceberg_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/core/random.hpp"
#include "engine/ocean/ice/iceberg_draft.hpp"

namespace floeplan::simulation {
namespace {

using Face = ConvexPart::Face;

constexpr double length_over_width = 1.62;
constexpr double most_chipped = 0.1;
constexpr int sides = 12;
/// Shape of the keels: how far a pinnacle's sides lean in, as a share of the radius, and how much a wedge's
/// keel rises, as a share of the draft. Choices between a point, which no keel is, and a vertical side.
constexpr double pinnacle_keel_share = 0.15;
constexpr double wedge_rise_share = 0.7;
/// Shape of a drydock: width of each column as a share of the berg's, top and bottom of the slab as shares of
/// the draft.
constexpr double column_share = 0.3;
constexpr double slab_top_share = 0.35;
constexpr double slab_bottom_share = 0.6;

struct Axes {
  double along_m;  // half the length
  double across_m;
  double draft_m;
};

double height_share(IcebergForm form) {
  switch (form) {
    case IcebergForm::tabular:
    case IcebergForm::blocky:
    case IcebergForm::wedge: return 0.2;
    case IcebergForm::domed: return 0.25;
    case IcebergForm::pinnacle: return 0.5;
    case IcebergForm::drydock: return 1.0;
  }
  return 0.2;
}

/// Share of a side that remains after chipping. The ends are not chipped, because they define the length.
double chipped(int side, std::mt19937_64& rng) {
  const double share = 1.0 - most_chipped * core::uniform(rng);
  return side % (sides / 2) == 0 ? 1.0 : share;
}

double side_angle(int side) { return 2.0 * std::numbers::pi * side / sides; }

double ellipse_support(const Axes& axes, double angle) {
  return std::hypot(axes.along_m * std::cos(angle), axes.across_m * std::sin(angle));
}

/// Distance of the tangent plane of a box with cut corners, at this angle.
double block_support(const Axes& axes, double angle) {
  const double corner = axes.along_m * std::abs(std::cos(angle)) + axes.across_m * std::abs(std::sin(angle));
  return std::min(corner, 1.1 * ellipse_support(axes, angle));
}

std::vector<Face> cap_and_keel(const Axes& axes, double height_m) {
  return {{{0.0, 0.0, 1.0}, axes.draft_m}, {{0.0, 0.0, -1.0}, height_m}};
}

template <class Support>
void add_upright_sides(std::vector<Face>& faces, const Axes& axes, const Support& support,
                       std::mt19937_64& rng) {
  for (int side = 0; side < sides; ++side) {
    const double angle = side_angle(side);
    faces.push_back({{std::cos(angle), std::sin(angle), 0.0}, support(axes, angle) * chipped(side, rng)});
  }
}

/// Adds facets that touch an ellipsoid below the water.
void add_dome(std::vector<Face>& faces, const Axes& axes, std::mt19937_64& rng) {
  for (const double dip_deg : {25.0, 50.0, 72.0}) {
    const double dip = core::degrees_to_radians(dip_deg);
    for (int side = 0; side < sides; ++side) {
      const double angle = side_angle(side);
      const double support =
          std::hypot(ellipse_support(axes, angle) * std::cos(dip), axes.draft_m * std::sin(dip));
      faces.push_back({{std::cos(angle) * std::cos(dip), std::sin(angle) * std::cos(dip), std::sin(dip)},
                       support * (1.0 - 0.5 * most_chipped * core::uniform(rng))});
    }
  }
}

/// Adds sides that lean inwards from the waterline to the keel.
void add_cone(std::vector<Face>& faces, const Axes& axes, std::mt19937_64& rng) {
  for (int side = 0; side < sides; ++side) {
    const double angle = side_angle(side);
    const double radius_m = ellipse_support(axes, angle) * chipped(side, rng);
    const double lean = (1.0 - pinnacle_keel_share) * radius_m / axes.draft_m;
    const double norm = std::hypot(1.0, lean);
    faces.push_back({{std::cos(angle) / norm, std::sin(angle) / norm, lean / norm}, radius_m / norm});
  }
}

/// Adds a keel that rises from the draft at one end.
void add_rising_keel(std::vector<Face>& faces, const Axes& axes) {
  const double rise = wedge_rise_share * axes.draft_m / (2.0 * axes.along_m);
  const double norm = std::hypot(1.0, rise);
  const double in_the_middle_m = axes.draft_m * (1.0 - 0.5 * wedge_rise_share);
  faces.push_back({{-rise / norm, 0.0, 1.0 / norm}, in_the_middle_m / norm});
}

std::vector<ConvexPart> drydock_parts(const Axes& axes, double height_m, std::mt19937_64& rng) {
  std::vector<ConvexPart> parts;
  const double column_m = column_share * axes.across_m;
  for (const double side : {-1.0, 1.0}) {
    const double inner_m = axes.across_m - 2.0 * column_m;
    std::vector<Face> faces = cap_and_keel(axes, height_m);
    add_upright_sides(faces, axes, block_support, rng);
    faces.push_back({{0.0, -side, 0.0}, -inner_m});
    parts.emplace_back(std::move(faces));
  }
  std::vector<Face> slab{{{0.0, 0.0, 1.0}, slab_bottom_share * axes.draft_m},
                         {{0.0, 0.0, -1.0}, -slab_top_share * axes.draft_m}};
  add_upright_sides(slab, axes, block_support, rng);
  parts.emplace_back(std::move(slab));
  return parts;
}

/// Radius of a cylinder around the axis that contains the shape. Perpendicular sides lie at half the length
/// and width or inside, so all lies in the box of length and width.
/// inside, so that all lies in the box of both.
double outline_radius(const Axes& axes) { return std::hypot(axes.along_m, axes.across_m); }

}  // namespace

IcebergForm iceberg_form(std::string_view code, std::mt19937_64& rng) {
  using enum IcebergForm;
  static constexpr std::array<std::pair<std::string_view, IcebergForm>, 8> named{{{"TAB", tabular},
                                                                                  {"BLK", blocky},
                                                                                  {"NTB", blocky},
                                                                                  {"DOM", domed},
                                                                                  {"PIN", pinnacle},
                                                                                  {"PNC", pinnacle},
                                                                                  {"WDG", wedge},
                                                                                  {"DD", drydock}}};
  const double drawn = core::uniform(rng);  // for every berg: a code must not change the draws of others
  for (const auto& [name, form] : named) {
    if (code == name) return form;
  }
  constexpr std::array<IcebergForm, 6> all{tabular, blocky, domed, pinnacle, wedge, drydock};
  return all[static_cast<std::size_t>(drawn * static_cast<double>(all.size()))];
}

core::Metres likely_draft(core::Metres length, std::mt19937_64& rng) {
  const ocean::Iceberg berg{.id = {},
                            .place = {},
                            .observed = {},
                            .length = length,
                            .draft = {},
                            .position_uncertainty = {},
                            .shape = {},
                            .method = {}};
  const double shallow_m = ocean::drift_draft(berg).value;
  const double deep_m = ocean::safe_draft(berg).value;
  return {shallow_m + (deep_m - shallow_m) * core::uniform(rng)};
}

Shape iceberg_shape(IcebergForm form, core::Metres length, core::Metres draft, std::mt19937_64& rng) {
  if (!(length.value > 0.0) || !(draft.value > 0.0) || !std::isfinite(length.value + draft.value))
    throw std::invalid_argument{"an iceberg has a length and a draft"};
  const Axes axes{0.5 * length.value, 0.5 * length.value / length_over_width, draft.value};
  const double height_m = height_share(form) * draft.value;
  Shape shape{.parts = {}, .radius_m = outline_radius(axes), .draft_m = draft.value};
  if (form == IcebergForm::drydock) {
    shape.parts = drydock_parts(axes, height_m, rng);
    return shape;
  }
  std::vector<Face> faces = cap_and_keel(axes, height_m);
  if (form == IcebergForm::blocky) {
    add_upright_sides(faces, axes, block_support, rng);
  } else {
    add_upright_sides(faces, axes, ellipse_support, rng);
  }
  if (form == IcebergForm::domed) add_dome(faces, axes, rng);
  if (form == IcebergForm::pinnacle) add_cone(faces, axes, rng);
  if (form == IcebergForm::wedge) add_rising_keel(faces, axes);
  shape.parts.emplace_back(std::move(faces));
  return shape;
}

}  // namespace floeplan::simulation
