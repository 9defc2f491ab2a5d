#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "storage/demo/bathymetry_file.hpp"
#include "storage/demo/current_file.hpp"
#include "storage/demo/flat_earth.hpp"
#include "storage/demo/scenarios.hpp"

namespace floeplan::demo {
namespace {

constexpr FlatEarth earth{66.0};
constexpr float bed_m = -500.0F;
const std::string warning = "Synthetic, not for navigation. ";

/// Position and scale at sea of a field of the paper: its origin, and the metres, seconds and m/s of one unit.
struct Placement {
  geo::LonLat origin;
  double length_m{};
  double speed_m_s{};

  [[nodiscard]] double time_s() const { return length_m / speed_m_s; }
};

/// Velocity in the paper's units at the paper's x, y and t.
struct PaperVelocity {
  double x{};
  double y{};
};
using PaperField = std::function<PaperVelocity(double x, double y, double t)>;

struct PaperBox {
  double west, south, east, north;  // the paper's units
  double step;
};

RasterFrame frame_of(const Placement& placement, const PaperBox& box) {
  const double lon_deg = placement.length_m / earth.metres_per_degree_lon();
  const double lat_deg = placement.length_m / metres_per_degree_lat;
  return {placement.origin.lon_deg + (box.west - 0.5 * box.step) * lon_deg,
          placement.origin.lat_deg + (box.south - 0.5 * box.step) * lat_deg,
          box.step * lon_deg,
          box.step * lat_deg,
          static_cast<std::size_t>(std::lround((box.east - box.west) / box.step)) + 1,
          static_cast<std::size_t>(std::lround((box.north - box.south) / box.step)) + 1};
}

CurrentLayer sampled(const PaperField& field, const Placement& placement, const PaperBox& box,
                     const RasterFrame& frame, core::Seconds elapsed) {
  CurrentLayer layer{{std::vector<double>(frame.size()), std::vector<double>(frame.size())},
                     std::vector<bool>(frame.size())};
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const std::size_t row = i / frame.columns;
    const double x = box.west + static_cast<double>(i % frame.columns) * box.step;
    const double y = box.south + static_cast<double>(row) * box.step;
    const PaperVelocity velocity = field(x, y, elapsed.count() / placement.time_s());
    layer.flow.east[i] = velocity.x * placement.speed_m_s;
    layer.flow.north[i] = velocity.y * placement.speed_m_s;
  }
  return layer;
}

PaperVelocity river(double x, double /*y*/, double /*t*/) {
  constexpr double width = 300.0;
  constexpr double fastest = 1.8;
  return {0.0, 4.0 / (width * width) * x * (width - x) * fastest};
}

/// Velocity of equations (2) to (4), with the derivatives of the stream function written out.
PaperVelocity jet(double x, double y, double t) {
  constexpr double k = 0.84;
  constexpr double c = 0.12;
  const double b = 1.2 + 0.3 * std::cos(0.4 * t + 0.5 * std::numbers::pi);
  const double phase = k * (x - c * t);
  const double stretch = std::sqrt(1.0 + k * k * b * b * std::sin(phase) * std::sin(phase));
  const double offset = (y - b * std::cos(phase)) / stretch;
  const double stretch_x = k * k * k * b * b * std::sin(phase) * std::cos(phase) / stretch;
  const double offset_x = (b * k * std::sin(phase) - offset * stretch_x) / stretch;
  const double slope = 1.0 / (std::cosh(offset) * std::cosh(offset));
  return {slope / stretch, -slope * offset_x};
}

std::vector<std::filesystem::path> write_scenario(const std::filesystem::path& dir, const std::string& name,
                                                  const std::string& what, const PaperField& field,
                                                  const Placement& placement, const PaperBox& box,
                                                  const std::vector<core::UtcTime>& times) {
  const RasterFrame frame = frame_of(placement, box);
  const std::filesystem::path currents = dir / (name + "-synthetic-currents.nc");
  const std::filesystem::path bathymetry = dir / (name + "-synthetic-bathymetry.tif");
  write_currents(
      currents, {.title = what + " (synthetic, not for navigation)",
                 .comment = warning + what +
                            " of Eichhorn 2009, placed in Davis Strait at sea scale: one unit of length is " +
                            std::to_string(std::lround(placement.length_m)) + " m, one unit of speed " +
                            std::to_string(std::lround(placement.speed_m_s * 1000.0)) +
                            " mm/s; the paper's origin lies at 57.0 W 66.0 N, its x axis points east.",
                 .frame = frame,
                 .depth_m = {0.0, 200.0, 400.0},
                 .times = times,
                 .layer = [&](core::UtcTime time, double /*depth_m*/) {
                   return sampled(field, placement, box, frame, time - times.front());
                 }});
  write_bathymetry(bathymetry, frame, std::vector<float>(frame.size(), bed_m),
                   warning + "Flat sea bed at 500 m for the scenario " + name + ".");
  return {bathymetry, currents};
}

}  // namespace

std::vector<std::filesystem::path> write_river(const std::filesystem::path& dir, core::UtcTime start) {
  const Placement placement{{-57.0, 66.0}, 100.0, 0.15};
  const PaperBox box{0.0, -150.0, 300.0, 210.0, 5.0};
  return write_scenario(dir, "river", "The river of equation (1)", river, placement, box,
                        {start, start + std::chrono::hours{144}});
}

std::vector<std::filesystem::path> write_jet(const std::filesystem::path& dir, core::UtcTime start) {
  const Placement placement{{-57.0, 66.0}, 5000.0, 0.7};
  const PaperBox box{-11.0, -6.0, 11.0, 6.0, 0.2};
  std::vector<core::UtcTime> times;
  for (int hour = 0; hour <= 144; ++hour) times.push_back(start + std::chrono::hours{hour});
  return write_scenario(dir, "jet", "The meandering jet of equations (2) to (4)", jet, placement, box, times);
}

}  // namespace floeplan::demo
