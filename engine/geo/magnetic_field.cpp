#include "engine/geo/magnetic_field.hpp"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/SphericalHarmonic1.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "engine/geo/magnetic_coefficients.hpp"

namespace floeplan::geo {
namespace {

/// Radius of the sphere to which the coefficients refer.
constexpr double reference_radius_m = 6'371'200.0;
constexpr double years_an_edition = 5.0;

double year_of(core::UtcTime time) {
  using namespace std::chrono;
  const year_month_day date{floor<days>(time)};
  const auto first_of = [](year each) { return sys_days{each / January / 1}; };
  const core::UtcTime begin{first_of(date.year())};
  const core::UtcTime end{first_of(date.year() + years{1})};
  return static_cast<int>(date.year()) + (time - begin) / (end - begin);
}

/// An edition's coefficients in the order of GeographicLib: grouped by order, without the sines of order 0.
struct Columns {
  std::vector<double> cosines;
  std::vector<double> sines;

  Columns() : cosines(magnetic_terms + 1), sines(magnetic_terms - magnetic_degree) {}

  void set(int n, int m, double cosine, double sine) {
    const int at = m * magnetic_degree - m * (m - 1) / 2 + n;
    cosines.at(static_cast<std::size_t>(at)) = cosine;
    if (m > 0) sines.at(static_cast<std::size_t>(at - magnetic_degree - 1)) = sine;
  }
};

/// Owns the coefficients: GeographicLib's sum only refers to them.
class Edition {
 public:
  explicit Edition(const MagneticEpoch& epoch) : year_{epoch.year} {
    for (const MagneticCoefficient& term : epoch.terms) {
      field_.set(term.n, term.m, term.g_nt, term.h_nt);
      change_.set(term.n, term.m, term.dg_nt, term.dh_nt);
    }
    sum_ = {field_.cosines, field_.sines,    magnetic_degree,    change_.cosines,
            change_.sines,  magnetic_degree, reference_radius_m, GeographicLib::SphericalHarmonic1::SCHMIDT};
  }
  Edition(const Edition&) = delete;
  Edition& operator=(const Edition&) = delete;

  [[nodiscard]] MagneticField at(LonLat place, double year, core::Metres height) const {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    std::vector<double> axes(9);  // rows: geocentric x, y, z; columns: east, north, up
    GeographicLib::Geocentric::WGS84().Forward(place.lat_deg, place.lon_deg, height.value, x, y, z, axes);
    double grad_x = 0.0;
    double grad_y = 0.0;
    double grad_z = 0.0;
    sum_(year - year_, x, y, z, grad_x, grad_y, grad_z);
    const auto along = [&](std::size_t axis) {  // field = -gradient of the potential
      return -reference_radius_m * (axes[axis] * grad_x + axes[3 + axis] * grad_y + axes[6 + axis] * grad_z);
    };
    return {.east_nt = along(0), .north_nt = along(1), .down_nt = -along(2)};
  }

 private:
  double year_;
  Columns field_;
  Columns change_;
  GeographicLib::SphericalHarmonic1 sum_;
};

/// The time as a decimal year; empty if no edition is valid.
std::optional<double> year_in_model(core::UtcTime time) {
  if (!(time >= first_magnetic_time) || time > last_magnetic_time) return std::nullopt;
  return year_of(time);
}

std::size_t edition_of(double year) {
  const auto number = static_cast<std::size_t>((year - magnetic_epochs().front().year) / years_an_edition);
  return std::min(number, magnetic_epochs().size() - 1);
}

const Edition& edition(std::size_t number) {
  static const std::array<Edition, 4> all{Edition{magnetic_epochs()[0]}, Edition{magnetic_epochs()[1]},
                                          Edition{magnetic_epochs()[2]}, Edition{magnetic_epochs()[3]}};
  return all.at(number);
}

}  // namespace

std::optional<MagneticField> magnetic_field_at(LonLat place, core::UtcTime time, core::Metres height) {
  if (!is_valid(place) || !std::isfinite(height.value))
    throw std::invalid_argument{"the magnetic field needs a valid place"};
  const auto year = year_in_model(time);
  if (!year) return std::nullopt;
  return edition(edition_of(*year)).at(place, *year, height);
}

std::optional<Declination> declination_at(LonLat place, core::UtcTime time) {
  const auto field = magnetic_field_at(place, time);
  if (!field) return std::nullopt;
  const MagneticEpoch& epoch = magnetic_epochs()[edition_of(year_of(time))];
  const double horizontal_nt = std::hypot(field->east_nt, field->north_nt);
  return Declination{
      .east_deg = core::radians_to_degrees(std::atan2(field->east_nt, field->north_nt)),
      .sigma_deg = std::min(180.0, std::hypot(epoch.sigma_deg, epoch.sigma_nt / horizontal_nt))};
}

}  // namespace floeplan::geo
