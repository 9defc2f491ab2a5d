#include "storage/ingest/formats/grib/grib_grid.hpp"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/shown_text.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/ingest_grib_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/common/grid_limits.hpp"
#include "storage/ingest/formats/grib/grib_section.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

// Flag table 3.4.
constexpr std::uint64_t i_runs_west = 0x80;
constexpr std::uint64_t j_runs_north = 0x40;
constexpr std::uint64_t offset_rows = 0x0F;

/// Octet numbers of the values that all templates have.
struct Octets {
  std::size_t first_lat{};
  std::size_t first_lon{};
  std::size_t component_flags{};
  std::size_t i_increment{};
  std::size_t j_increment{};
  std::size_t scanning{};
};

constexpr Octets of_latitude_longitude{47, 51, 55, 64, 68, 72};  // templates 3.0, 3.1
constexpr Octets of_mercator{39, 43, 47, 65, 69, 60};            // template 3.10
constexpr Octets of_plane{39, 43, 47, 56, 60, 65};               // templates 3.20, 3.30

/// `count` equidistant nodes between the file's first and last node, in ascending order.
std::vector<double> nodes_between(double first, double last, std::size_t count) {
  const double low = std::min(first, last);
  const double step = count > 1 ? std::abs(last - first) / static_cast<double>(count - 1) : 0.0;
  std::vector<double> nodes(count);
  for (std::size_t i = 0; i < count; ++i) nodes[i] = low + step * static_cast<double>(i);
  return nodes;
}

class GridReader {
 public:
  explicit GridReader(const std::string& octets) : section_{octets}, template_{section_.at(13, 2)} {}

  GribGrid read() {
    refuse_what_is_not_regular();
    switch (template_) {
      case 0: return on_latitude_longitude();
      case 1: return round_a_turned_pole();
      case 10: return on_mercator();
      case 20: return on_polar_stereographic();
      case 30: return on_lambert();
      default: fail_grib(messages::ingest_grib_message<"grib-grid-template-not-read">(template_));
    }
  }

 private:
  void refuse_what_is_not_regular() const {
    if (section_.at(6, 1) != 0) fail_grib(messages::ingest_grib_message<"grib-grid-not-described">());
    const std::uint64_t columns = section_.at(31, 4);
    const std::uint64_t rows = section_.at(35, 4);
    if (section_.at(11, 1) != 0 || section_.is_missing(31, 4) || section_.is_missing(35, 4))
      fail_grib(messages::ingest_grib_message<"grib-grid-reduced">());
    if (columns == 0 || rows == 0 || columns > max_grid_points / std::max<std::uint64_t>(rows, 1))
      fail_grib(messages::ingest_grib_message<"grib-grid-too-large">(columns, rows, max_grid_points));
    if (section_.at(7, 4) != columns * rows)
      fail_grib(
          messages::ingest_grib_message<"grib-values-differ-from-nodes">(columns, rows, section_.at(7, 4)));
    if ((scanning() & offset_rows) != 0) fail_grib(messages::ingest_grib_message<"grib-rows-offset">());
  }

  [[nodiscard]] const Octets& octets() const {
    if (template_ <= 1) return of_latitude_longitude;
    return template_ == 10 ? of_mercator : of_plane;
  }
  [[nodiscard]] std::uint64_t scanning() const { return section_.at(octets().scanning, 1); }
  [[nodiscard]] double towards_east() const { return (scanning() & i_runs_west) != 0 ? -1.0 : 1.0; }
  [[nodiscard]] double towards_north() const { return (scanning() & j_runs_north) != 0 ? 1.0 : -1.0; }
  [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(section_.at(31, 4)); }
  [[nodiscard]] std::size_t rows() const { return static_cast<std::size_t>(section_.at(35, 4)); }
  [[nodiscard]] double micro_degrees(std::size_t octet) const {
    return static_cast<double>(section_.signed_at(octet, 4)) * 1e-6;
  }

  /// Degrees per unit of the angles in templates 3.0 and 3.1.
  [[nodiscard]] double angle_unit() const {
    const std::uint64_t basic = section_.at(39, 4);
    const std::uint64_t parts = section_.at(43, 4);
    if (basic == 0 || section_.is_missing(39, 4)) return 1e-6;
    if (parts == 0 || section_.is_missing(43, 4))
      fail_grib(messages::ingest_grib_message<"grib-angle-unit-missing">());
    return static_cast<double>(basic) / static_cast<double>(parts);
  }

  /// Degrees between neighbouring nodes; nullopt if the file does not state the increment.
  [[nodiscard]] std::optional<double> increment(std::size_t octet, std::uint64_t flag) const {
    const bool given = (section_.at(octets().component_flags, 1) & flag) != 0;
    if (!given || section_.is_missing(octet, 4) || section_.at(octet, 4) == 0) return std::nullopt;
    return static_cast<double>(section_.at(octet, 4)) * angle_unit();
  }

  [[noreturn]] static void fail_contradiction(const std::string& axis, double first, double last,
                                              double sense, const std::string& step, const char* up,
                                              const char* down) {
    fail_grib(messages::ingest_grib_message<"grib-axis-contradicts">(axis, number(first, 9), number(last, 9),
                                                                     (sense > 0.0 ? up : down) + step));
  }

  /// ", in 12 steps of 0.25 degrees"; empty if the file does not state the step.
  [[nodiscard]] static std::string in_words(std::size_t count, std::optional<double> step) {
    if (!step) return {};
    return ", in " + core::counted(count - 1, "step") + " of " + number(*step, 9) + " degrees";
  }

  /// By how much the stated last node may differ from the computed one: increments and nodes are rounded to
  /// their unit.
  [[nodiscard]] double rounding(std::size_t count, double step) const {
    return std::max(0.25 * step, angle_unit() * (0.5 * static_cast<double>(count) + 2.0));
  }

  [[nodiscard]] std::vector<double> latitudes() const {
    const double first = static_cast<double>(section_.signed_at(47, 4)) * angle_unit();
    const auto step = increment(68, 0x10);
    const std::size_t count = rows();
    if (count == 1) return {first};
    if (section_.is_missing(56, 4)) {
      if (!step) fail_without_step("latitude");
      return nodes_between(first, first + towards_north() * *step * static_cast<double>(count - 1), count);
    }
    const double last = static_cast<double>(section_.signed_at(56, 4)) * angle_unit();
    const double span = towards_north() * (last - first);
    const bool agrees = span > 0.0 && (!step || std::abs(span - *step * static_cast<double>(count - 1)) <=
                                                    rounding(count, *step));
    if (!agrees)
      fail_contradiction("latitude", first, last, towards_north(), in_words(count, step), "north", "south");
    return nodes_between(first, last, count);
  }

  /// Longitudes of the columns in ascending order. The first, the western edge, lies between -180 and 180.
  [[nodiscard]] std::vector<double> longitudes() const {
    const double first = static_cast<double>(section_.signed_at(51, 4)) * angle_unit();
    const auto step = increment(64, 0x20);
    const std::size_t count = columns();
    if (count == 1) return {geo::wrap_longitude(first)};
    const bool last_known = !section_.is_missing(60, 4);
    if (!last_known && !step) fail_without_step("longitude");
    const double by_step = step ? *step * static_cast<double>(count - 1) : 0.0;
    double span = by_step;
    if (last_known) {
      const double last = static_cast<double>(section_.signed_at(60, 4)) * angle_unit();
      span = std::fmod(towards_east() * (last - first), 360.0);
      if (span <= 0.0) span += 360.0;
      if (step) {
        span += 360.0 * std::round((by_step - span) / 360.0);
        if (std::abs(span - by_step) > rounding(count, *step))
          fail_contradiction("longitude", first, last, towards_east(), in_words(count, step), "east", "west");
      }
    }
    if (span > 720.0) fail_grib(messages::ingest_grib_message<"grib-round-the-earth-twice">());
    const double west = geo::wrap_longitude(towards_east() > 0.0 ? first : first - span);
    return nodes_between(west, west + span, count);
  }

  [[noreturn]] static void fail_without_step(const std::string& axis) {
    fail_grib(messages::ingest_grib_message<"grib-step-missing">(axis));
  }

  GribGrid on_latitude_longitude() const { return {longitudes(), latitudes(), nullptr}; }

  GribGrid round_a_turned_pole() const {
    if (section_.at(81, 4) != 0) fail_grib(messages::ingest_grib_message<"grib-pole-turned-further">());
    auto plane = std::make_shared<OGRSpatialReference>();
    plane->SetGeogCS("own", "own", "own", 6371229.0, 0.0);
    const double lat = static_cast<double>(section_.signed_at(73, 4)) * angle_unit();
    const double lon = static_cast<double>(section_.signed_at(77, 4)) * angle_unit();
    if (plane->SetDerivedGeogCRSWithPoleRotationGRIBConvention("turned pole", lat, lon, 0.0) != OGRERR_NONE)
      fail_unusable();
    return {longitudes(), latitudes(), std::move(plane)};
  }

  /// The figure of the Earth (code table 3.2); an inverse flattening of 0 means a sphere.
  [[nodiscard]] std::shared_ptr<OGRSpatialReference> figure() const {
    const auto scaled = [&](std::size_t scale, std::size_t value) {
      return static_cast<double>(section_.at(value, 4)) *
             std::pow(10.0, -static_cast<double>(section_.signed_at(scale, 1)));
    };
    const auto ellipsoid = [&](double major_m, double minor_m) {
      constexpr double smallest_m = 6.3e6;
      constexpr double largest_m = 6.4e6;
      if (!(minor_m > smallest_m && minor_m <= major_m && major_m < largest_m))
        fail_grib(messages::ingest_grib_message<"grib-earth-of-other-size">(number(major_m, 9),
                                                                            number(minor_m, 9)));
      auto crs = std::make_shared<OGRSpatialReference>();
      crs->SetGeogCS("own", "own", "own", major_m, major_m > minor_m ? major_m / (major_m - minor_m) : 0.0);
      return crs;
    };
    const std::uint64_t shape = section_.at(15, 1);
    switch (shape) {
      case 0: return ellipsoid(6367470.0, 6367470.0);
      case 1: return ellipsoid(scaled(16, 17), scaled(16, 17));
      case 2: return ellipsoid(6378160.0, 6356775.0);
      case 3: return ellipsoid(1000.0 * scaled(21, 22), 1000.0 * scaled(26, 27));
      case 4:
      case 5: return ellipsoid(6378137.0, 6356752.3142);
      case 6: return ellipsoid(6371229.0, 6371229.0);
      case 7: return ellipsoid(scaled(21, 22), scaled(26, 27));
      case 8: return ellipsoid(6371200.0, 6371200.0);
      default: fail_grib(messages::ingest_grib_message<"grib-figure-unknown">(shape));
    }
  }

  /// Metres between neighbouring nodes of a projection.
  [[nodiscard]] double spacing_m(std::size_t octet) const {
    if (section_.at(octet, 4) == 0 || section_.is_missing(octet, 4))
      fail_grib(messages::ingest_grib_message<"grib-spacing-missing">());
    return static_cast<double>(section_.at(octet, 4)) * 1e-3;
  }

  /// The grid on a projection plane: projects the first node and continues with the increments.
  [[nodiscard]] GribGrid on(std::shared_ptr<OGRSpatialReference> plane) const {
    plane->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRSpatialReference> geographic{plane->CloneGeogCS()};
    if (geographic) geographic->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> project{
        geographic ? OGRCreateCoordinateTransformation(geographic.get(), plane.get()) : nullptr};
    double x = micro_degrees(octets().first_lon);
    double y = micro_degrees(octets().first_lat);
    if (!project || project->Transform(1, &x, &y) == 0 || !std::isfinite(x) || !std::isfinite(y))
      fail_unusable();
    const double across = spacing_m(octets().i_increment) * static_cast<double>(columns() - 1);
    const double along = spacing_m(octets().j_increment) * static_cast<double>(rows() - 1);
    return {nodes_between(x, x + towards_east() * across, columns()),
            nodes_between(y, y + towards_north() * along, rows()), std::move(plane)};
  }

  [[noreturn]] static void fail_unusable() {
    fail_grib(messages::ingest_grib_message<"grib-plane-unusable">());
  }

  [[nodiscard]] GribGrid on_mercator() const {
    if (section_.at(61, 4) != 0) fail_grib(messages::ingest_grib_message<"grib-mercator-turned">());
    auto plane = figure();
    // The meridian of the first node is the central one, so that the grid does not cross the seam at 180
    // degrees from it.
    const double first_lon = micro_degrees(43);
    if (plane->SetMercator2SP(micro_degrees(48), 0.0, first_lon, 0.0, 0.0) != OGRERR_NONE) fail_unusable();
    GribGrid grid = on(std::move(plane));
    refuse_another_end(grid);
    return grid;
  }

  /// Refuses a Mercator grid whose stated last node is not where its increments end.
  void refuse_another_end(const GribGrid& grid) const {
    if (section_.is_missing(52, 4) || section_.is_missing(56, 4)) return;
    OGRSpatialReference plane{*grid.plane};
    const std::unique_ptr<OGRSpatialReference> geographic{plane.CloneGeogCS()};
    geographic->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> back{
        OGRCreateCoordinateTransformation(&plane, geographic.get())};
    double lon = towards_east() > 0.0 ? grid.x.back() : grid.x.front();
    double lat = towards_north() > 0.0 ? grid.y.back() : grid.y.front();
    if (!back || back->Transform(1, &lon, &lat) == 0) fail_unusable();
    constexpr double metres_a_degree = 111'000.0;
    const double tolerance = 0.5 * std::max(spacing_m(65), spacing_m(69)) / metres_a_degree;
    const double last_lat = micro_degrees(52);
    const double last_lon = micro_degrees(56);
    if (std::abs(lat - last_lat) > tolerance || std::abs(geo::wrap_longitude(lon - last_lon)) > tolerance)
      fail_grib(messages::ingest_grib_message<"grib-mercator-ends-elsewhere">(number(last_lon, 9),
                                                                              number(last_lat, 9)));
  }

  [[nodiscard]] GribGrid on_polar_stereographic() const {
    const std::uint64_t centre = section_.at(64, 1);
    if ((centre & 0x40U) != 0) fail_grib(messages::ingest_grib_message<"grib-two-poles">());
    const double pole = (centre & 0x80U) != 0 ? -1.0 : 1.0;
    const double true_lat = micro_degrees(48);
    if (true_lat == 0.0) fail_grib(messages::ingest_grib_message<"grib-polar-scale-missing">());
    // Some producers give this latitude without its sign. The first node must then lie in the pole's
    // hemisphere.
    if (pole * true_lat < 0.0 && pole * micro_degrees(39) <= 0.0)
      fail_grib(messages::ingest_grib_message<"grib-pole-contradicts">(pole > 0.0 ? "north" : "south"));
    auto plane = figure();
    if (plane->SetPS(pole * std::abs(true_lat), micro_degrees(52), 1.0, 0.0, 0.0) != OGRERR_NONE)
      fail_unusable();
    return on(std::move(plane));
  }

  [[nodiscard]] GribGrid on_lambert() const {
    const double one = micro_degrees(66);
    const double other = micro_degrees(70);
    if (one * other <= 0.0) fail_grib(messages::ingest_grib_message<"grib-cone-impossible">());
    auto plane = figure();
    if (plane->SetLCC(one, other, micro_degrees(48), micro_degrees(52), 0.0, 0.0) != OGRERR_NONE)
      fail_unusable();
    return on(std::move(plane));
  }

  GribSection section_;
  std::uint64_t template_;
};

}  // namespace

Checked<GribGrid> grib_grid(const std::string& section) {
  const GdalMessages quiet;
  try {
    return GridReader{section}.read();
  } catch (const BadGrib& fault) {
    return refuse(fault.reason);
  }
}

}  // namespace floeplan::ingest
