#include "engine/geo/local_projection.hpp"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/LambertConformalConic.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace floeplan::geo {
namespace {

using GeographicLib::LambertConformalConic;
using GeographicLib::PolarStereographic;
using GeographicLib::TransverseMercator;

constexpr double polar_from_deg = 60.0;  // nearer to the pole a polar plane distorts less than a cone
constexpr double conic_from_deg =
    15.0;  // nearer to the equator the cone is almost a cylinder and gains nothing

struct Projected {
  PlanePoint point;
  double convergence_deg;  // bearing of grid north
  double scale;
};

/// Polar stereographic, true to scale on the origin's parallel; the origin's meridian is the y axis.
struct Polar {
  bool north;
  PolarStereographic formula;

  explicit Polar(LonLat origin)
      : north{origin.lat_deg > 0.0},
        formula{GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(), 1.0} {
    formula.SetScale(std::min(std::abs(origin.lat_deg), 89.9), 1.0);
  }

  [[nodiscard]] Projected forward(double lon_from_origin_deg, double lat_deg) const {
    Projected result{};
    formula.Forward(north, lat_deg, lon_from_origin_deg, result.point.x_m, result.point.y_m,
                    result.convergence_deg, result.scale);
    return result;
  }

  [[nodiscard]] LonLat reverse(PlanePoint point) const {
    LonLat place;
    formula.Reverse(north, point.x_m, point.y_m, place.lat_deg, place.lon_deg);
    return place;
  }
};

/// A projection with the same formulas on both sides of the equator.
template <class Formula>
struct Central {
  Formula formula;

  [[nodiscard]] Projected forward(double lon_from_origin_deg, double lat_deg) const {
    Projected result{};
    formula.Forward(0.0, lat_deg, lon_from_origin_deg, result.point.x_m, result.point.y_m,
                    result.convergence_deg, result.scale);
    return result;
  }

  [[nodiscard]] LonLat reverse(PlanePoint point) const {
    LonLat place;
    formula.Reverse(0.0, point.x_m, point.y_m, place.lat_deg, place.lon_deg);
    return place;
  }
};

using Conic = Central<LambertConformalConic>;
using Transverse = Central<TransverseMercator>;

Conic conic_at(LonLat origin) {
  return {{GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(), origin.lat_deg, 1.0}};
}

Transverse transverse() {
  return {{GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f(), 1.0}};
}

}  // namespace

/// Longitudes in the formulas count from the origin's meridian, so that no seam is near the area.
class LocalProjection::Formulas {
 public:
  explicit Formulas(LonLat origin) : formula_{choose(origin)} {
    shift_ = std::visit([&](const auto& f) { return f.forward(0.0, origin.lat_deg).point; }, formula_);
  }

  [[nodiscard]] Projected forward(double lon_from_origin_deg, double lat_deg) const {
    Projected result =
        std::visit([&](const auto& f) { return f.forward(lon_from_origin_deg, lat_deg); }, formula_);
    result.point.x_m -= shift_.x_m;
    result.point.y_m -= shift_.y_m;
    return result;
  }

  [[nodiscard]] LonLat reverse(PlanePoint point) const {
    return std::visit(
        [&](const auto& f) { return f.reverse({point.x_m + shift_.x_m, point.y_m + shift_.y_m}); }, formula_);
  }

 private:
  using Formula = std::variant<Polar, Conic, Transverse>;

  static Formula choose(LonLat origin) {
    if (std::abs(origin.lat_deg) >= polar_from_deg) return Polar{origin};
    if (std::abs(origin.lat_deg) >= conic_from_deg) return conic_at(origin);
    return transverse();
  }

  Formula formula_;
  PlanePoint shift_;
};

LocalProjection::LocalProjection(LonLat origin) : origin_{origin} {
  if (!is_valid(origin)) throw std::invalid_argument{"LocalProjection needs a valid place as its origin"};
  formulas_ = std::make_shared<const Formulas>(origin);
}

PlanePoint LocalProjection::to_plane(LonLat place) const {
  return formulas_->forward(longitude_difference(origin_.lon_deg, place.lon_deg), place.lat_deg).point;
}

LonLat LocalProjection::to_lon_lat(PlanePoint point) const {
  LonLat place = formulas_->reverse(point);
  place.lon_deg = wrap_longitude(place.lon_deg + origin_.lon_deg);
  return place;
}

GlobeWindow LocalProjection::window() const {
  // Stereographic planes have the opposite pole at infinity. Cones have a seam, and the opposite pole at
  // infinity. Transverse Mercator has the places on the equator 90 degrees away at infinity.
  constexpr double beyond_equator_deg = 45.0;
  constexpr double half_width_deg = 60.0;
  const double lat_deg = origin_.lat_deg;
  if (std::abs(lat_deg) < conic_from_deg)
    return {.middle_lon_deg = origin_.lon_deg, .half_width_deg = half_width_deg};
  GlobeWindow window{.middle_lon_deg = origin_.lon_deg};
  if (std::abs(lat_deg) < polar_from_deg) window.half_width_deg = half_width_deg;
  (lat_deg > 0.0 ? window.south_deg : window.north_deg) = -std::copysign(beyond_equator_deg, lat_deg);
  return window;
}

PlaneScale LocalProjection::at(LonLat place) const {
  const Projected projected =
      formulas_->forward(longitude_difference(origin_.lon_deg, place.lon_deg), place.lat_deg);
  return {projected.scale, core::Radians{core::degrees_to_radians(projected.convergence_deg)}};
}

PlaneVelocity LocalProjection::to_plane(VelocityEn velocity, LonLat place) const {
  const PlaneScale local = at(place);
  const double cosine = std::cos(local.convergence.value);
  const double sine = std::sin(local.convergence.value);
  const double east = local.scale * velocity.east.value;
  const double north = local.scale * velocity.north.value;
  // `convergence` is the bearing of grid north. In east-north axes y points along (sin, cos), x along (cos,
  // -sin).
  return {east * cosine - north * sine, east * sine + north * cosine};
}

}  // namespace floeplan::geo
