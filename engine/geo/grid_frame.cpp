#include "engine/geo/grid_frame.hpp"

#include <GeographicLib/AlbersEqualArea.hpp>
#include <GeographicLib/Ellipsoid.hpp>
#include <GeographicLib/LambertConformalConic.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/core/units.hpp"

namespace floeplan::geo {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

double flattening(const Ellipsoid& ellipsoid) {
  return ellipsoid.inverse_flattening == 0.0 ? 0.0 : 1.0 / ellipsoid.inverse_flattening;
}

class PolarStereographicMap {
 public:
  explicit PolarStereographicMap(const PolarStereographicFrame& frame)
      : north_{frame.north},
        lon_0_deg_{frame.lon_0_deg},
        formula_{frame.ellipsoid.semi_major_m, flattening(frame.ellipsoid), 1.0} {
    formula_.SetScale(std::abs(frame.lat_ts_deg), frame.scale_ts);
  }

  [[nodiscard]] GridPoint forward(LonLat place) const {
    GridPoint point;
    formula_.Forward(north_, place.lat_deg, longitude_difference(lon_0_deg_, place.lon_deg), point.x,
                     point.y);
    return point;
  }
  [[nodiscard]] LonLat reverse(GridPoint point) const {
    LonLat place;
    formula_.Reverse(north_, point.x, point.y, place.lat_deg, place.lon_deg);
    return {place.lon_deg + lon_0_deg_, place.lat_deg};
  }

 private:
  bool north_;
  double lon_0_deg_;
  GeographicLib::PolarStereographic formula_;
};

/// A projection whose formulas count northings from a latitude of their own, which is not the frame's.
template <class Formula>
class FromFrameOrigin {
 public:
  FromFrameOrigin(Formula formula, double lon_0_deg, double lat_0_deg)
      : formula_{std::move(formula)}, lon_0_deg_{lon_0_deg} {
    double x = 0.0;
    formula_.Forward(0.0, lat_0_deg, 0.0, x, origin_northing_);
  }

  [[nodiscard]] GridPoint forward(LonLat place) const {
    GridPoint point;
    formula_.Forward(lon_0_deg_, place.lat_deg, place.lon_deg, point.x, point.y);
    return {point.x, point.y - origin_northing_};
  }
  [[nodiscard]] LonLat reverse(GridPoint point) const {
    LonLat place;
    formula_.Reverse(lon_0_deg_, point.x, point.y + origin_northing_, place.lat_deg, place.lon_deg);
    return place;
  }

 private:
  Formula formula_;
  double lon_0_deg_;
  double origin_northing_{};
};

/// Source  Snyder 1987, equations 24-2, 24-13 to 24-22; a place on the authalic sphere is a vector here, which is
///         exact at the centre and at the poles, too
class AzimuthalEqualAreaMap {
 public:
  explicit AzimuthalEqualAreaMap(const AzimuthalEqualAreaFrame& frame)
      : ellipsoid_{frame.ellipsoid.semi_major_m, flattening(frame.ellipsoid)},
        radius_m_{std::sqrt(ellipsoid_.Area() / (4.0 * std::numbers::pi))},
        lon_0_deg_{frame.lon_0_deg} {
    if (!(std::abs(frame.lat_0_deg) < 90.0))
      throw std::invalid_argument{"an azimuthal equal-area frame needs a centre that is not a pole"};
    const double beta_0 = core::degrees_to_radians(ellipsoid_.AuthalicLatitude(frame.lat_0_deg));
    sin_0_ = std::sin(beta_0);
    cos_0_ = std::cos(beta_0);
    stretch_ = ellipsoid_.CircleRadius(frame.lat_0_deg) / (radius_m_ * cos_0_);  // D
  }

  [[nodiscard]] GridPoint forward(LonLat place) const {
    const double beta = core::degrees_to_radians(ellipsoid_.AuthalicLatitude(place.lat_deg));
    const double lon = core::degrees_to_radians(longitude_difference(lon_0_deg_, place.lon_deg));
    const double up = std::sin(beta);
    const double out = std::cos(beta) * std::cos(lon);
    const double east = std::cos(beta) * std::sin(lon);
    const double b_m = radius_m_ * std::sqrt(2.0 / (1.0 + sin_0_ * up + cos_0_ * out));
    return {b_m * stretch_ * east, b_m / stretch_ * (cos_0_ * up - sin_0_ * out)};
  }
  [[nodiscard]] LonLat reverse(GridPoint point) const {
    const double x = point.x / stretch_ / radius_m_;
    const double y = point.y * stretch_ / radius_m_;
    const double square = x * x + y * y;
    const double cos_c = 1.0 - 0.5 * square;
    const double across = std::sqrt(1.0 - 0.25 * square);  // sin c / rho; NaN beyond the antipode
    const double up = cos_c * sin_0_ + y * across * cos_0_;
    const double out = cos_c * cos_0_ - y * across * sin_0_;
    const double east = x * across;
    const double beta = std::atan2(up, std::hypot(out, east));
    return {lon_0_deg_ + core::radians_to_degrees(std::atan2(east, out)),
            ellipsoid_.InverseAuthalicLatitude(core::radians_to_degrees(beta))};
  }

 private:
  GeographicLib::Ellipsoid ellipsoid_;
  double radius_m_;  // of the authalic sphere
  double lon_0_deg_;
  double sin_0_{};  // of the authalic latitude of the centre
  double cos_0_{};
  double stretch_{};
};

using TransverseMercatorMap = FromFrameOrigin<GeographicLib::TransverseMercator>;
using LambertConformalMap = FromFrameOrigin<GeographicLib::LambertConformalConic>;

/// GeographicLib 2.1 places a cone over the southern hemisphere wrongly, so that is computed as its mirror image.
class AlbersMap {
 public:
  explicit AlbersMap(const AlbersFrame& frame)
      : sign_{frame.lat_1_deg + frame.lat_2_deg < 0.0 ? -1.0 : 1.0},
        in_the_north_{{frame.ellipsoid.semi_major_m, flattening(frame.ellipsoid), sign_ * frame.lat_1_deg,
                       sign_ * frame.lat_2_deg, 1.0},
                      frame.lon_0_deg,
                      sign_ * frame.lat_0_deg} {}

  [[nodiscard]] GridPoint forward(LonLat place) const {
    const GridPoint point = in_the_north_.forward({place.lon_deg, sign_ * place.lat_deg});
    return {point.x, sign_ * point.y};
  }
  [[nodiscard]] LonLat reverse(GridPoint point) const {
    const LonLat place = in_the_north_.reverse({point.x, sign_ * point.y});
    return {place.lon_deg, sign_ * place.lat_deg};
  }

 private:
  double sign_;
  FromFrameOrigin<GeographicLib::AlbersEqualArea> in_the_north_;
};

}  // namespace

struct FrameProjection::Formula {
  std::variant<PolarStereographicMap, TransverseMercatorMap, LambertConformalMap, AlbersMap,
               AzimuthalEqualAreaMap>
      map;
  double false_easting_m{};
  double false_northing_m{};

  template <class Frame, class Map>
  static std::shared_ptr<const Formula> of(const Frame& frame, Map map) {
    return std::make_shared<const Formula>(
        Formula{std::move(map), frame.false_easting_m, frame.false_northing_m});
  }
  static std::shared_ptr<const Formula> of(const GeographicFrame&) { return nullptr; }
  static std::shared_ptr<const Formula> of(const PolarStereographicFrame& frame) {
    return of(frame, PolarStereographicMap{frame});
  }
  static std::shared_ptr<const Formula> of(const TransverseMercatorFrame& frame) {
    return of(frame, TransverseMercatorMap{
                         {frame.ellipsoid.semi_major_m, flattening(frame.ellipsoid), frame.scale_0},
                         frame.lon_0_deg,
                         frame.lat_0_deg});
  }
  static std::shared_ptr<const Formula> of(const LambertConformalFrame& frame) {
    return of(frame, LambertConformalMap{{frame.ellipsoid.semi_major_m, flattening(frame.ellipsoid),
                                          frame.lat_1_deg, frame.lat_2_deg, frame.scale_1},
                                         frame.lon_0_deg,
                                         frame.lat_0_deg});
  }
  static std::shared_ptr<const Formula> of(const AlbersFrame& frame) { return of(frame, AlbersMap{frame}); }
  static std::shared_ptr<const Formula> of(const AzimuthalEqualAreaFrame& frame) {
    return of(frame, AzimuthalEqualAreaMap{frame});
  }
};

FrameProjection::FrameProjection(const GridFrame& frame) : frame_{frame} {
  try {
    formula_ = std::visit([](const auto& any) { return Formula::of(any); }, frame);
  } catch (const GeographicLib::GeographicErr& fault) {
    throw std::invalid_argument{fault.what()};
  }
}

GridPoint FrameProjection::to_grid(LonLat place) const {
  if (formula_ == nullptr) return {place.lon_deg, place.lat_deg};
  const GridPoint point = std::visit([&](const auto& map) { return map.forward(place); }, formula_->map);
  return {point.x + formula_->false_easting_m, point.y + formula_->false_northing_m};
}

LonLat FrameProjection::to_lon_lat(GridPoint point) const {
  if (formula_ == nullptr) return {wrap_longitude(point.x), point.y};
  const GridPoint from_origin{point.x - formula_->false_easting_m, point.y - formula_->false_northing_m};
  const LonLat place = std::visit([&](const auto& map) { return map.reverse(from_origin); }, formula_->map);
  return {wrap_longitude(place.lon_deg), place.lat_deg};
}

std::optional<double> FrameProjection::cut_deg() const {
  const auto opposite = [](const auto& frame) -> std::optional<double> {
    const bool around_a_pole = std::abs(frame.lat_1_deg) == 90.0 && frame.lat_2_deg == frame.lat_1_deg;
    return around_a_pole ? std::nullopt : std::optional{wrap_longitude(frame.lon_0_deg + 180.0)};
  };
  if (const auto* conic = std::get_if<LambertConformalFrame>(&frame_)) return opposite(*conic);
  if (const auto* conic = std::get_if<AlbersFrame>(&frame_)) return opposite(*conic);
  return std::nullopt;
}

std::string frame_text(const GridFrame& frame) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  const auto write = [&](const auto& projected, const char* name, auto... numbers) {
    text << name;
    ((text << ' ' << numbers), ...);
    text << ' ' << projected.false_easting_m << ' ' << projected.false_northing_m;
    if (projected.ellipsoid != wgs84)
      text << ' ' << projected.ellipsoid.semi_major_m << ' ' << projected.ellipsoid.inverse_flattening;
  };
  std::visit(
      Overloaded{[&](const GeographicFrame&) { text << "geographic"; },
                 [&](const PolarStereographicFrame& polar) {
                   write(polar, polar.north ? "polar_stereographic north" : "polar_stereographic south",
                         polar.lat_ts_deg, polar.lon_0_deg);
                   if (polar.scale_ts == 1.0) return;
                   if (polar.ellipsoid == wgs84)
                     text << ' ' << wgs84.semi_major_m << ' ' << wgs84.inverse_flattening;
                   text << ' ' << polar.scale_ts;
                 },
                 [&](const TransverseMercatorFrame& mercator) {
                   write(mercator, "transverse_mercator", mercator.lon_0_deg, mercator.lat_0_deg,
                         mercator.scale_0);
                 },
                 [&](const LambertConformalFrame& conic) {
                   write(conic, "lambert_conformal", conic.lat_1_deg, conic.lat_2_deg, conic.scale_1,
                         conic.lat_0_deg, conic.lon_0_deg);
                 },
                 [&](const AlbersFrame& conic) {
                   write(conic, "albers", conic.lat_1_deg, conic.lat_2_deg, conic.lat_0_deg, conic.lon_0_deg);
                 },
                 [&](const AzimuthalEqualAreaFrame& azimuthal) {
                   write(azimuthal, "azimuthal_equal_area", azimuthal.lat_0_deg, azimuthal.lon_0_deg);
                 }},
      frame);
  return text.str();
}

std::optional<GridFrame> parse_frame(std::string_view text) {
  std::istringstream words{std::string{text}};
  words.imbue(std::locale::classic());
  std::string name;
  words >> name;
  const auto read = [&](auto frame, auto... members) -> std::optional<GridFrame> {
    ((words >> frame.*members), ...);
    words >> frame.false_easting_m >> frame.false_northing_m;
    if (!words) return std::nullopt;
    Ellipsoid ellipsoid;
    if (words >> ellipsoid.semi_major_m >> ellipsoid.inverse_flattening) frame.ellipsoid = ellipsoid;
    if constexpr (requires { frame.scale_ts; }) {
      if (double scale = 0.0; words >> scale) frame.scale_ts = scale;
    }
    return frame;
  };
  if (name == "geographic") return GeographicFrame{};
  if (name == "polar_stereographic") {
    using Frame = PolarStereographicFrame;
    std::string pole;
    words >> pole;
    if (pole != "north" && pole != "south") return std::nullopt;
    return read(Frame{.north = pole == "north"}, &Frame::lat_ts_deg, &Frame::lon_0_deg);
  }
  if (name == "transverse_mercator") {
    using Frame = TransverseMercatorFrame;
    return read(Frame{}, &Frame::lon_0_deg, &Frame::lat_0_deg, &Frame::scale_0);
  }
  if (name == "lambert_conformal") {
    using Frame = LambertConformalFrame;
    return read(Frame{}, &Frame::lat_1_deg, &Frame::lat_2_deg, &Frame::scale_1, &Frame::lat_0_deg,
                &Frame::lon_0_deg);
  }
  if (name == "albers") {
    using Frame = AlbersFrame;
    return read(Frame{}, &Frame::lat_1_deg, &Frame::lat_2_deg, &Frame::lat_0_deg, &Frame::lon_0_deg);
  }
  if (name == "azimuthal_equal_area") {
    using Frame = AzimuthalEqualAreaFrame;
    return read(Frame{}, &Frame::lat_0_deg, &Frame::lon_0_deg);
  }
  return std::nullopt;
}

}  // namespace floeplan::geo
