#include "tests/storage/ingest/grib_writer.hpp"

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

/// Octets of a section, numbers with their most significant octet first.
class Octets {
 public:
  Octets& put(std::uint64_t value, int count) {
    for (int i = count - 1; i >= 0; --i) text_ += static_cast<char>(value >> (8 * i) & 0xFFU);
    return *this;
  }
  /// The first bit is the sign.
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

}  // namespace

geo::LonLat GribMessage::place(double column, double row) const {
  if (!polar) return {first.lon_deg + column * step_deg, first.lat_deg + row * step_deg};
  const double x = (column - 0.5 * (columns - 1)) * spacing_m;
  const double y = (row - 0.5 * (rows - 1)) * spacing_m - from_pole_m;
  const double scale = sphere_m * (1.0 + std::sin(true_lat_deg * radians));
  return {geo::wrap_longitude(vertical_lon_deg + std::atan2(x, -y) / radians),
          90.0 - 2.0 * std::atan(std::hypot(x, y) / scale) / radians};
}

std::string GribMessage::octets() const {
  std::vector<double> values;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      values.push_back(value(column, rows_from_south ? row : rows - 1 - row));
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
  grid.put(0, 1).put(static_cast<std::uint64_t>(columns * rows), 4).put(0, 2).put(polar ? 20 : 0, 2);
  grid.put(6, 1).put(0, 1).put(0, 4).put(0, 1).put(0, 4).put(0, 1).put(0, 4);
  grid.put(static_cast<std::uint64_t>(columns), 4).put(static_cast<std::uint64_t>(rows), 4);
  const int flags = 0x30 | (along_grid ? 8 : 0);
  const int scanning = rows_from_south ? 0x40 : 0;
  const geo::LonLat start = place(0, rows_from_south ? 0 : rows - 1);
  const geo::LonLat end = place(columns - 1, rows_from_south ? rows - 1 : 0);
  const auto lon = [](geo::LonLat at) { return micro(at.lon_deg < 0.0 ? at.lon_deg + 360.0 : at.lon_deg); };
  const auto wrapped = [&](geo::LonLat at) { return lon({std::fmod(at.lon_deg, 360.0), at.lat_deg}); };
  if (polar) {
    grid.put_signed(micro(start.lat_deg), 4)
        .put_signed(lon(start), 4)
        .put(static_cast<std::uint64_t>(flags), 1);
    grid.put_signed(micro(true_lat_deg), 4).put_signed(micro(vertical_lon_deg), 4);
    grid.put(static_cast<std::uint64_t>(spacing_m * 1000.0), 4)
        .put(static_cast<std::uint64_t>(spacing_m * 1000.0), 4);
    grid.put(0, 1).put(static_cast<std::uint64_t>(scanning), 1);
  } else {
    grid.put(0, 4).put(0xFFFFFFFFU, 4);
    grid.put_signed(micro(start.lat_deg), 4)
        .put_signed(wrapped(start), 4)
        .put(static_cast<std::uint64_t>(flags), 1);
    grid.put_signed(micro(end.lat_deg), 4).put_signed(wrapped(end), 4);
    grid.put(static_cast<std::uint64_t>(micro(step_deg)), 4)
        .put(static_cast<std::uint64_t>(micro(step_deg)), 4);
    grid.put(static_cast<std::uint64_t>(scanning), 1);
  }
  const double surface_m = wind_height_m.value_or(depth_m);
  const std::string product = Octets{}
                                  .put(0, 2)
                                  .put(0, 2)
                                  .put(wind_height_m ? 2 : 1, 1)
                                  .put(static_cast<std::uint64_t>(number), 1)
                                  .put(2, 1)
                                  .put(0, 1)
                                  .put(0, 1)
                                  .put(0, 2)
                                  .put(0, 1)
                                  .put(1, 1)
                                  .put(static_cast<std::uint64_t>(forecast_h), 4)
                                  .put(wind_height_m ? 103 : 160, 1)
                                  .put(2, 1)
                                  .put(static_cast<std::uint64_t>(std::llround(surface_m * 100.0)), 4)
                                  .put(255, 1)
                                  .put(255, 1)
                                  .put(0xFFFFFFFFU, 4)
                                  .section(4);
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
  const std::string body = identification + grid.section(3) + product + representation +
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
