#include "tests/storage/ingest/support/grib_writer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace floeplan::ingest {
namespace {

constexpr double radians = std::numbers::pi / 180.0;
constexpr double sphere_m = 6371229.0;  // code table 3.2, entry 6
constexpr double true_lat_deg = 60.0;
constexpr double vertical_lon_deg = 20.0;
constexpr double from_pole_m = 600000.0;
// the intersection of the rotated equator and its first meridian
constexpr geo::LonLat turned_origin{-40.0, 60.0};

/// Octets of a section, numbers with their most significant octet first.
class Octets {
 public:
  Octets& put(std::uint64_t value, int count) {
    for (int i = count - 1; i >= 0; --i) text_ += static_cast<char>(value >> (8 * i) & 0xFFU);
    return *this;
  }
  /// Puts a number whose first bit is the sign.
  Octets& put_signed(std::int64_t value, int count) {
    const std::uint64_t sign = value < 0 ? std::uint64_t{1} << (8 * count - 1) : 0;
    return put(static_cast<std::uint64_t>(std::abs(value)) | sign, count);
  }
  Octets& text(const std::string& more) {
    text_ += more;
    return *this;
  }
  [[nodiscard]] std::string section(int number) const {
    Octets whole;
    whole.put(text_.size() + 5, 4).put(static_cast<std::uint64_t>(number), 1).text(text_);
    return whole.text_;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::int64_t micro(double degrees) { return std::llround(degrees * 1e6); }

std::uint64_t micro_lon(double degrees) {
  return static_cast<std::uint64_t>(micro(std::fmod(std::fmod(degrees, 360.0) + 360.0, 360.0)));
}

double lambert_cone() { return std::sin(true_lat_deg * radians); }

/// Radius of the parallel of true scale on the cone, and the factor of Snyder's equation 15-2.
double lambert_radius_m() { return sphere_m / std::tan(true_lat_deg * radians); }
double lambert_factor() {
  return std::cos(true_lat_deg * radians) *
         std::pow(std::tan((45.0 + 0.5 * true_lat_deg) * radians), lambert_cone()) / lambert_cone();
}

struct Node {
  int column{};  // from the west
  int row{};     // from the south
};

/// The nodes in the order of the scanning mode.
std::vector<Node> scanned(const GribMessage& message) {
  const bool along_j = (message.scanning & 0x20) != 0;
  const int lines = along_j ? message.columns : message.rows;
  const int in_line = along_j ? message.rows : message.columns;
  std::vector<Node> nodes;
  for (int line = 0; line < lines; ++line) {
    for (int k = 0; k < in_line; ++k) {
      const bool back = (message.scanning & 0x10) != 0 && line % 2 == 1;
      const int at = back ? in_line - 1 - k : k;
      const int i = along_j ? line : at;
      const int j = along_j ? at : line;
      nodes.push_back({(message.scanning & 0x80) != 0 ? message.columns - 1 - i : i,
                       (message.scanning & 0x40) != 0 ? j : message.rows - 1 - j});
    }
  }
  return nodes;
}

/// Writes section 3 from its 15th octet.
void put_grid(Octets& grid, const GribMessage& message) {
  const bool westward = (message.scanning & 0x80) != 0;
  const bool northward = (message.scanning & 0x40) != 0;
  const int first_column = westward ? message.columns - 1 : 0;
  const int first_row = northward ? 0 : message.rows - 1;
  const int last_column = message.columns - 1 - first_column;
  const int last_row = message.rows - 1 - first_row;
  const auto flags =
      static_cast<std::uint64_t>((message.states_increments ? 0x30 : 0) | (message.along_grid ? 8 : 0));
  const auto scanning = static_cast<std::uint64_t>(message.stated_scanning.value_or(message.scanning));
  const auto spacing = static_cast<std::uint64_t>(message.spacing_m * 1000.0);
  const bool turned = message.plane == GribPlane::turned_pole;
  grid.put(6, 1).put(0, 1).put(0, 4).put(0, 1).put(0, 4).put(0, 1).put(0, 4);
  grid.put(static_cast<std::uint64_t>(message.columns), 4).put(static_cast<std::uint64_t>(message.rows), 4);
  if (turned || message.plane == GribPlane::latitude_longitude) {
    const auto own = [&](int column, int row) {
      return turned ? geo::LonLat{(column - 0.5 * (message.columns - 1)) * message.step_deg,
                                  (row - 0.5 * (message.rows - 1)) * message.step_deg}
                    : message.place(column, row);
    };
    const geo::LonLat start = own(first_column, first_row);
    const geo::LonLat end = own(last_column, last_row);
    const std::uint64_t step = message.states_increments ? static_cast<std::uint64_t>(micro(message.step_deg))
                                                         : std::uint64_t{0xFFFFFFFFU};
    grid.put(0, 4).put(0xFFFFFFFFU, 4);
    grid.put_signed(micro(start.lat_deg), 4).put(micro_lon(start.lon_deg), 4).put(flags, 1);
    grid.put_signed(micro(end.lat_deg), 4).put(micro_lon(end.lon_deg), 4);
    grid.put(step, 4).put(step, 4).put(scanning, 1);
    if (turned)
      grid.put_signed(micro(turned_origin.lat_deg - 90.0), 4)
          .put(micro_lon(turned_origin.lon_deg), 4)
          .put(0, 4);
    return;
  }
  const geo::LonLat start = message.place(first_column, first_row);
  grid.put_signed(micro(start.lat_deg), 4).put(micro_lon(start.lon_deg), 4).put(flags, 1);
  if (message.plane == GribPlane::mercator) {
    const geo::LonLat end = message.place(last_column, last_row);
    grid.put_signed(micro(true_lat_deg), 4).put_signed(micro(end.lat_deg), 4).put(micro_lon(end.lon_deg), 4);
    grid.put(scanning, 1).put(0, 4).put(spacing, 4).put(spacing, 4);
    return;
  }
  const bool south = message.plane == GribPlane::south_polar;
  grid.put_signed(micro(south ? -true_lat_deg : true_lat_deg), 4).put_signed(micro(vertical_lon_deg), 4);
  grid.put(spacing, 4).put(spacing, 4).put(south ? 0x80 : 0, 1).put(scanning, 1);
  if (message.plane == GribPlane::lambert)
    grid.put_signed(micro(true_lat_deg), 4)
        .put_signed(micro(true_lat_deg), 4)
        .put_signed(micro(-90.0), 4)
        .put(0, 4);
}

std::uint64_t number_of(GribPlane plane) {
  switch (plane) {
    case GribPlane::latitude_longitude: return 0;
    case GribPlane::turned_pole: return 1;
    case GribPlane::mercator: return 10;
    case GribPlane::north_polar:
    case GribPlane::south_polar: return 20;
    case GribPlane::lambert: return 30;
  }
  return 255;
}

}  // namespace

geo::LonLat GribMessage::place(double column, double row) const {
  const double from_middle_x = column - 0.5 * (columns - 1);
  const double from_middle_y = row - 0.5 * (rows - 1);
  switch (plane) {
    case GribPlane::latitude_longitude:
      return {first.lon_deg + column * step_deg, first.lat_deg + row * step_deg};
    case GribPlane::turned_pole: {
      const double lon = from_middle_x * step_deg * radians;
      const double lat = from_middle_y * step_deg * radians;
      const double tilt = turned_origin.lat_deg * radians;
      const double x = std::cos(lat) * std::cos(lon) * std::cos(tilt) - std::sin(lat) * std::sin(tilt);
      const double z = std::cos(lat) * std::cos(lon) * std::sin(tilt) + std::sin(lat) * std::cos(tilt);
      return {turned_origin.lon_deg + std::atan2(std::cos(lat) * std::sin(lon), x) / radians,
              std::asin(z) / radians};
    }
    case GribPlane::mercator: {
      const double radius = sphere_m * std::cos(true_lat_deg * radians);
      const double y = std::asinh(std::tan(first.lat_deg * radians)) + row * spacing_m / radius;
      return {first.lon_deg + column * spacing_m / radius / radians, std::atan(std::sinh(y)) / radians};
    }
    case GribPlane::north_polar:
    case GribPlane::south_polar: {
      const double side = plane == GribPlane::north_polar ? 1.0 : -1.0;
      const double x = from_middle_x * spacing_m;
      const double y = from_middle_y * spacing_m - side * from_pole_m;
      const double scale = sphere_m * (1.0 + std::sin(true_lat_deg * radians));
      return {geo::wrap_longitude(vertical_lon_deg + std::atan2(x, -side * y) / radians),
              side * (90.0 - 2.0 * std::atan(std::hypot(x, y) / scale) / radians)};
    }
    case GribPlane::lambert: {
      const double x = from_middle_x * spacing_m;
      const double y = lambert_radius_m() - from_middle_y * spacing_m;
      const double share = std::pow(sphere_m * lambert_factor() / std::hypot(x, y), 1.0 / lambert_cone());
      return {vertical_lon_deg + std::atan2(x, y) / lambert_cone() / radians,
              2.0 * std::atan(share) / radians - 90.0};
    }
  }
  return {};
}

std::string GribMessage::octets() const {
  std::vector<double> values;
  for (const Node& node : scanned(*this)) values.push_back(value(node.column, node.row));
  const double least = *std::min_element(values.begin(), values.end());
  const double most = *std::max_element(values.begin(), values.end());
  const int binary_scale = std::ilogb(std::max(most - least, 1e-6)) - 14;

  const std::string identification = Octets{}
                                         .put(98, 2)
                                         .put(0, 2)
                                         .put(2, 1)
                                         .put(0, 1)
                                         .put(1, 1)
                                         .put(2026, 2)
                                         .put(11, 1)
                                         .put(20, 1)
                                         .put(0, 3)
                                         .put(0, 1)
                                         .put(1, 1)
                                         .section(1);
  Octets grid;
  grid.put(0, 1).put(values.size(), 4).put(0, 2).put(number_of(plane), 2);
  put_grid(grid, *this);
  const double surface_m = wind_height_m.value_or(depth_m);
  Octets product;
  product.put(0, 2)
      .put(statistic ? 8 : 0, 2)
      .put(wind_height_m ? 2 : 1, 1)
      .put(static_cast<std::uint64_t>(number), 1)
      .put(2, 1)
      .put(0, 1)
      .put(0, 1)
      .put(0, 2)
      .put(0, 1)
      .put(1, 1)
      .put(static_cast<std::uint64_t>(period_begins_h.value_or(forecast_h)), 4)
      .put(wind_height_m ? 103 : 160, 1)
      .put(2, 1)
      .put(static_cast<std::uint64_t>(std::llround(surface_m * 100.0)), 4)
      .put(layer_ends_m ? static_cast<std::uint64_t>(second_type.value_or(wind_height_m ? 103 : 160)) : 255,
           1)
      .put(layer_ends_m ? 2 : 255, 1)
      .put(layer_ends_m ? static_cast<std::uint64_t>(std::llround(*layer_ends_m * 100.0)) : 0xFFFFFFFFU, 4);
  if (statistic) {  // the range is six hours and ends on 2026-11-20
    product.put(2026, 2).put(11, 1).put(20, 1).put(static_cast<std::uint64_t>(forecast_h), 1).put(0, 2);
    product.put(1, 1).put(0, 4).put(static_cast<std::uint64_t>(*statistic), 1).put(2, 1);
    product.put(1, 1).put(6, 4).put(255, 1).put(0, 4);
  }
  const std::string representation = Octets{}
                                         .put(values.size(), 4)
                                         .put(0, 2)
                                         .put(std::bit_cast<std::uint32_t>(static_cast<float>(least)), 4)
                                         .put_signed(binary_scale, 2)
                                         .put(0, 2)
                                         .put(16, 1)
                                         .put(0, 1)
                                         .section(5);
  const double reference = static_cast<double>(static_cast<float>(least));
  Octets packed;
  for (const double one : values)
    packed.put(static_cast<std::uint64_t>(
                   std::max(0LL, std::llround((one - reference) / std::ldexp(1.0, binary_scale)))),
               2);
  const std::string body = identification + grid.section(3) + product.section(4) + representation +
                           Octets{}.put(255, 1).section(6) + packed.section(7) + "7777";
  return Octets{}
             .text("GRIB")
             .put(0, 2)
             .put(wind_height_m ? 0 : 10, 1)
             .put(2, 1)
             .put(body.size() + 16, 8)
             .text() +
         body;
}

}  // namespace floeplan::ingest
