#include "tests/storage/ingest/support/model_grid_writer.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/geo/bearing.hpp"
#include "engine/geo/geodesic.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"

namespace floeplan::ingest {
namespace {

constexpr double radians = std::numbers::pi / 180.0;

using Value = std::function<double(double, double)>;

/// Values at (i + shift_i, j + shift_j) for all rows and columns.
std::vector<double> plane(std::size_t rows, std::size_t columns, double shift_i, double shift_j,
                          const Value& value) {
  std::vector<double> values;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      values.push_back(value(static_cast<double>(i) + shift_i, static_cast<double>(j) + shift_j));
  return values;
}

NetcdfWriter::Variable variable(std::string name, std::vector<std::string> dimensions,
                                std::vector<double> values, std::map<std::string, std::string> texts) {
  return {.name = std::move(name),
          .dimensions = std::move(dimensions),
          .values = std::move(values),
          .texts = std::move(texts),
          .numbers = {},
          .fill = {},
          .type = NetcdfWriter::Type::float64};
}

void write_positions(NetcdfWriter& writer, const ModelGrid& grid, const std::string& lon_name,
                     const std::string& lat_name, const std::vector<std::string>& dimensions,
                     std::size_t rows, std::size_t columns, double shift_i, double shift_j) {
  writer.variable(variable(
      lon_name, dimensions,
      plane(rows, columns, shift_i, shift_j, [&](double i, double j) { return grid.place(i, j).lon_deg; }),
      {{"units", "degrees_east"}}));
  writer.variable(variable(
      lat_name, dimensions,
      plane(rows, columns, shift_i, shift_j, [&](double i, double j) { return grid.place(i, j).lat_deg; }),
      {{"units", "degrees_north"}}));
}

/// Ellipses and hyperbolas with their foci in the two poles, on the polar stereographic plane of a unit sphere.
geo::LonLat place_on_cap(const ModelGrid& grid, double i, double j) {
  constexpr double focus = 0.2679491924311227;  // tan of half of 30 degrees
  const double round = 2.0 * std::numbers::pi * i / static_cast<double>(grid.columns - 2);
  const double outward = (static_cast<double>(grid.rows - 2) - j) / static_cast<double>(grid.rows - 2);
  const std::complex<double> place = focus * std::cosh(std::complex{outward, round});
  return {geo::wrap_longitude(grid.origin.lon_deg + std::arg(place) / radians),
          90.0 - 2.0 * std::atan(std::abs(place)) / radians};
}

const std::map<std::string, std::string> hours{{"units", "hours since 2026-11-20 00:00:00"}};

}  // namespace

geo::VelocityEn turning_sea(geo::LonLat place) {
  constexpr double pole_lon = 100.0 * radians;
  constexpr double pole_lat = 20.0 * radians;
  const double lon = place.lon_deg * radians;
  const double lat = place.lat_deg * radians;
  const double wx = std::cos(pole_lat) * std::cos(pole_lon);
  const double wy = std::cos(pole_lat) * std::sin(pole_lon);
  const double wz = std::sin(pole_lat);
  const double x = std::cos(lat) * std::cos(lon);
  const double y = std::cos(lat) * std::sin(lon);
  const double z = std::sin(lat);
  const double vx = wy * z - wz * y;
  const double vy = wz * x - wx * z;
  const double vz = wx * y - wy * x;
  return {{0.5 * (-std::sin(lon) * vx + std::cos(lon) * vy)},
          {0.5 * (-std::sin(lat) * (std::cos(lon) * vx + std::sin(lon) * vy) + std::cos(lat) * vz)}};
}

geo::LonLat ModelGrid::place(double i, double j) const {
  if (two_poles) return place_on_cap(*this, i, j);
  const double x = (i - 0.5 * static_cast<double>(columns - 1)) * spacing_m;
  const double y = (j - 0.5 * static_cast<double>(rows - 1)) * spacing_m;
  const double distance = std::hypot(x, y);
  if (distance == 0.0) return origin;
  const double angle = std::atan2(y, x) + turned_deg * radians;
  return geo::geodesic_destination(origin, geo::Bearing::degrees(90.0 - angle / radians), {distance});
}

double ModelGrid::angle(double i, double j) const {
  const geo::LonLat here = place(i, j);
  const geo::LonLat next = place(i + 1e-3, j);
  return (90.0 - geo::geodesic_between(here, next).course_at_start.degrees()) * radians;
}

double ModelGrid::first(double i, double j) const {
  const geo::VelocityEn water = turning_sea(place(i, j));
  const double turn = angle(i, j);
  return water.east.value * std::cos(turn) + water.north.value * std::sin(turn);
}

double ModelGrid::second(double i, double j) const {
  const geo::VelocityEn water = turning_sea(place(i, j));
  const double turn = angle(i, j);
  return water.north.value * std::cos(turn) - water.east.value * std::sin(turn);
}

void write_nemo(const ModelGrid& grid, const std::filesystem::path& u_file,
                const std::filesystem::path& v_file,
                const std::function<bool(std::size_t, std::size_t)>& is_land) {
  const auto dry = [&](double i, double j) {
    return is_land(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  };
  for (const bool is_u : {true, false}) {
    NetcdfWriter writer{is_u ? u_file : v_file};
    const double shift_i = is_u ? 0.5 : 0.0;
    const double shift_j = is_u ? 0.0 : 0.5;
    writer.axis("time_counter", {0.0}, hours);
    writer.axis(is_u ? "depthu" : "depthv", {0.5, 10.0}, {{"units", "m"}, {"positive", "down"}});
    writer.dimension("y", grid.rows);
    writer.dimension("x", grid.columns);
    write_positions(writer, grid, "nav_lon", "nav_lat", {"y", "x"}, grid.rows, grid.columns, shift_i,
                    shift_j);
    std::vector<double> values;
    for (const double share : {1.0, 0.5})
      for (const double value : plane(grid.rows, grid.columns, shift_i, shift_j, [&](double i, double j) {
             if (dry(i, j) || dry(i + shift_i, j + shift_j)) return 0.0;
             return is_u ? grid.first(i, j) : grid.second(i, j);
           }))
        values.push_back(share * value);
    writer.variable(variable(is_u ? "vozocrtx" : "vomecrty",
                             {"time_counter", is_u ? "depthu" : "depthv", "y", "x"}, std::move(values),
                             {{"units", "m/s"}, {"coordinates", "nav_lon nav_lat"}}));
  }
}

void write_pop(const ModelGrid& grid, const std::filesystem::path& file) {
  NetcdfWriter writer{file};
  writer.axis("time", {0.0}, hours);
  writer.axis("z_t", {500.0, 1500.0}, {{"units", "centimeters"}, {"positive", "down"}});
  writer.dimension("nlat", grid.rows);
  writer.dimension("nlon", grid.columns);
  write_positions(writer, grid, "ULONG", "ULAT", {"nlat", "nlon"}, grid.rows, grid.columns, 0.0, 0.0);
  for (const bool is_u : {true, false}) {
    std::vector<double> values;
    for (const double share : {1.0, 0.5})
      for (const double value : plane(grid.rows, grid.columns, 0.0, 0.0, [&](double i, double j) {
             return is_u ? grid.first(i, j) : grid.second(i, j);
           }))
        values.push_back(100.0 * share * value);
    writer.variable(variable(is_u ? "UVEL" : "VVEL", {"time", "z_t", "nlat", "nlon"}, std::move(values),
                             {{"units", "centimeter/s"}, {"coordinates", "ULONG ULAT z_t time"}}));
  }
}

void write_roms(const ModelGrid& grid, const std::filesystem::path& file, const RomsOptions& options) {
  constexpr std::size_t levels = 10;
  constexpr double critical_m = 20.0;
  constexpr double surface_m = 1.0;
  const auto bed_m = [](double i) { return 100.0 + 5.0 * i; };
  std::vector<double> s;
  std::vector<double> stretching;
  for (std::size_t k = 0; k < levels; ++k) {
    s.push_back((static_cast<double>(k) + 0.5) / static_cast<double>(levels) - 1.0);
    stretching.push_back(-s.back() * s.back());
  }
  const auto depth_m = [&](std::size_t k, double i) {
    if (options.transform == 1) {
      const double level = critical_m * s[k] + (bed_m(i) - critical_m) * stretching[k];
      return surface_m - (level + surface_m * (1.0 + level / bed_m(i)));
    }
    return -(surface_m + bed_m(i)) * (critical_m * s[k] + bed_m(i) * stretching[k]) / (critical_m + bed_m(i));
  };

  NetcdfWriter writer{file};
  writer.axis("ocean_time", {0.0}, hours);
  writer.axis("s_rho", s, {{"standard_name", "ocean_s_coordinate_g" + std::to_string(options.transform)}});
  writer.variable(variable("Cs_r", {"s_rho"}, stretching, {}));
  writer.variable(variable("hc", {}, {critical_m}, {{"units", "meter"}}));
  writer.variable(variable("Vtransform", {}, {static_cast<double>(options.transform)}, {}));
  writer.dimension("eta_rho", grid.rows);
  writer.dimension("xi_rho", grid.columns);
  writer.dimension("eta_u", grid.rows);
  writer.dimension("xi_u", grid.columns - 1);
  writer.dimension("eta_v", grid.rows - 1);
  writer.dimension("xi_v", grid.columns);
  write_positions(writer, grid, "lon_rho", "lat_rho", {"eta_rho", "xi_rho"}, grid.rows, grid.columns, 0.0,
                  0.0);
  if (options.with_positions_of_components) {
    write_positions(writer, grid, "lon_u", "lat_u", {"eta_u", "xi_u"}, grid.rows, grid.columns - 1, 0.5, 0.0);
    write_positions(writer, grid, "lon_v", "lat_v", {"eta_v", "xi_v"}, grid.rows - 1, grid.columns, 0.0, 0.5);
  }
  writer.variable(
      variable("h", {"eta_rho", "xi_rho"},
               plane(grid.rows, grid.columns, 0.0, 0.0, [&](double i, double) { return bed_m(i); }),
               {{"units", "meter"}}));
  writer.variable(variable("zeta", {"ocean_time", "eta_rho", "xi_rho"},
                           std::vector<double>(grid.rows * grid.columns, surface_m), {{"units", "meter"}}));
  if (options.with_angle)
    writer.variable(variable(
        "angle", {"eta_rho", "xi_rho"},
        plane(grid.rows, grid.columns, 0.0, 0.0,
              [&](double i, double j) { return grid.angle(i, j) + options.angle_error_deg * radians; }),
        {{"units", "radians"}}));
  if (options.wall_rows > 0)
    writer.variable(variable("mask_u", {"eta_u", "xi_u"},
                             plane(grid.rows, grid.columns - 1, 0.0, 0.0,
                                   [&](double i, double j) {
                                     const bool wall = i == static_cast<double>(options.wall_after) &&
                                                       j < static_cast<double>(options.wall_rows);
                                     return wall ? 0.0 : 1.0;
                                   }),
                             {}));
  for (const bool is_u : {true, false}) {
    std::vector<double> values;
    for (std::size_t k = 0; k < levels; ++k) {
      const auto level = plane(is_u ? grid.rows : grid.rows - 1, is_u ? grid.columns - 1 : grid.columns,
                               is_u ? 0.5 : 0.0, is_u ? 0.0 : 0.5, [&](double i, double j) {
                                 const double share = 1.0 - options.shear_per_m * depth_m(k, i);
                                 return share * (is_u ? grid.first(i, j) : grid.second(i, j));
                               });
      values.insert(values.end(), level.begin(), level.end());
    }
    writer.variable(
        variable(is_u ? "u" : "v", {"ocean_time", "s_rho", is_u ? "eta_u" : "eta_v", is_u ? "xi_u" : "xi_v"},
                 std::move(values),
                 {{"units", "meter second-1"},
                  {"long_name", is_u ? "u-momentum component" : "v-momentum component"},
                  {"coordinates", is_u ? "lon_u lat_u s_rho ocean_time" : "lon_v lat_v s_rho ocean_time"}}));
  }
}

void write_fvcom(const ModelGrid& grid, const std::filesystem::path& file) {
  struct Face {
    std::array<std::size_t, 3> nodes;
    double i;
    double j;
  };
  std::vector<Face> faces;
  const auto node = [&](std::size_t i, std::size_t j) { return j * grid.columns + i + 1; };
  for (std::size_t j = 0; j + 1 < grid.rows; ++j)
    for (std::size_t i = 0; i + 1 < grid.columns; ++i) {
      const auto x = static_cast<double>(i);
      const auto y = static_cast<double>(j);
      faces.push_back({{node(i, j), node(i + 1, j), node(i, j + 1)}, x + 1.0 / 3.0, y + 1.0 / 3.0});
      faces.push_back({{node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}, x + 2.0 / 3.0, y + 2.0 / 3.0});
    }
  const std::size_t nodes = grid.rows * grid.columns;

  NetcdfWriter writer{file};
  writer.axis("time", {0.0}, hours);
  writer.dimension("siglay", 2);
  writer.dimension("node", nodes);
  writer.dimension("nele", faces.size());
  writer.dimension("three", 3);
  writer.variable(variable("lon", {"node"},
                           plane(grid.rows, grid.columns, 0.0, 0.0,
                                 [&](double i, double j) {
                                   const double lon = grid.place(i, j).lon_deg;
                                   return lon < 0.0 ? lon + 360.0 : lon;
                                 }),
                           {{"units", "degrees_east"}}));
  writer.variable(variable(
      "lat", {"node"},
      plane(grid.rows, grid.columns, 0.0, 0.0, [&](double i, double j) { return grid.place(i, j).lat_deg; }),
      {{"units", "degrees_north"}}));
  std::vector<double> corners;
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (const Face& face : faces) corners.push_back(static_cast<double>(face.nodes[corner]));
  writer.variable(variable("nv", {"three", "nele"}, std::move(corners), {}));
  writer.variable(variable("h", {"node"}, std::vector<double>(nodes, 40.0), {{"units", "m"}}));
  std::vector<double> layers(nodes, -0.25);
  layers.insert(layers.end(), nodes, -0.75);
  writer.variable(variable("siglay", {"siglay", "node"}, std::move(layers), {{"positive", "up"}}));
  writer.variable(variable("zeta", {"time", "node"}, std::vector<double>(nodes, 0.0), {{"units", "m"}}));
  for (const bool is_u : {true, false}) {
    std::vector<double> values;
    for (const double share : {1.0, 0.5})
      for (const Face& face : faces) {
        const geo::VelocityEn water = turning_sea(grid.place(face.i, face.j));
        values.push_back(share * (is_u ? water.east.value : water.north.value));
      }
    writer.variable(
        variable(is_u ? "u" : "v", {"time", "siglay", "nele"}, std::move(values),
                 {{"units", "meters s-1"},
                  {"standard_name", is_u ? "eastward_sea_water_velocity" : "northward_sea_water_velocity"}}));
  }
}

void write_polar_plane(const std::filesystem::path& file, const PolarOptions& options) {
  const geo::GridFrame frame =
      geo::PolarStereographicFrame{.north = true, .lat_ts_deg = 70.0, .lon_0_deg = -45.0};
  const std::vector<double> x{-300000.0, -250000.0, -200000.0, -150000.0};
  const std::vector<double> y{-600000.0, -650000.0, -700000.0};
  NetcdfWriter writer{file};
  writer.axis("time", {0.0}, hours);
  const auto written = [&](std::vector<double> nodes) {
    for (double& node : nodes) node /= options.as_topaz ? 1e5 : 1.0;
    return nodes;
  };
  const std::string unit = options.as_topaz ? "100 km" : "m";
  writer.axis("y", written(y), {{"units", unit}, {"standard_name", "projection_y_coordinate"}});
  writer.axis("x", written(x), {{"units", unit}, {"standard_name", "projection_x_coordinate"}});
  for (const bool is_lon : {true, false}) {
    std::vector<double> values;
    for (const double at_y : y)
      for (const double at_x : x) {
        const geo::LonLat here = geo::FrameProjection{frame}.to_lon_lat({at_x, at_y});
        values.push_back(is_lon ? here.lon_deg : here.lat_deg);
      }
    if (options.as_topaz)
      writer.variable(variable(is_lon ? "longitude" : "latitude", {"y", "x"}, std::move(values),
                               {{"units", is_lon ? "degrees_east" : "degrees_north"}}));
  }
  NetcdfWriter::Variable crs = variable("crs", {}, {1.0}, {{"grid_mapping_name", "polar_stereographic"}});
  crs.numbers = {{"straight_vertical_longitude_from_pole", -45.0},
                 {"latitude_of_projection_origin", 90.0},
                 {"standard_parallel", 70.0},
                 {"false_easting", 0.0},
                 {"false_northing", 0.0}};
  if (options.as_topaz) {
    crs.numbers["earth_radius"] = 6378273.0;
  } else {
    crs.numbers["semi_major_axis"] = 6378137.0;
    crs.numbers["inverse_flattening"] = 298.257223563;
  }
  crs.type = NetcdfWriter::Type::int32;
  writer.variable(crs);
  for (const bool is_u : {true, false}) {
    std::vector<double> values;
    for (const double at_y : y)
      for (const double at_x : x) {
        const geo::LonLat here = geo::FrameProjection{frame}.to_lon_lat({at_x, at_y});
        const geo::VelocityEn water = turning_sea(here);
        const double turn =
            options.along_axes ? -(here.lon_deg + 45.0) * radians : 0.0;  // of the x axis from east
        values.push_back(is_u ? water.east.value * std::cos(turn) + water.north.value * std::sin(turn)
                              : water.north.value * std::cos(turn) - water.east.value * std::sin(turn));
      }
    const std::string axis = is_u ? "x" : "y";
    writer.variable(variable(
        is_u ? "vxo" : "vyo", {"time", "y", "x"}, std::move(values),
        {{"units", "m s-1"},
         {"grid_mapping", "crs"},
         {"standard_name", options.along_axes
                               ? "sea_water_" + axis + "_velocity"
                               : (is_u ? "eastward_sea_water_velocity" : "northward_sea_water_velocity")}}));
  }
}

}  // namespace floeplan::ingest
