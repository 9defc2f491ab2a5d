#include "engine/simulation/sensors/janus.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::simulation {
namespace {

constexpr double flattest_beam = 0.2;       // cosine of its angle from the vertical: 78 degrees
constexpr double least_determinant = 1e-3;  // of the normal equations; below, no velocity follows

struct Symmetric {
  double ee{}, en{}, ed{}, nn{}, nd{}, dd{};
};

}  // namespace

JanusBeams janus_beams_of(const AdcpSettings& settings, const Attitude& attitude) {
  const BodyAxes axes{attitude};
  const double aside = std::sin(settings.beam_angle_rad);
  const double down = std::cos(settings.beam_angle_rad);
  return {axes.to_frame(aside, 0.0, down), axes.to_frame(-aside, 0.0, down), axes.to_frame(0.0, aside, down),
          axes.to_frame(0.0, -aside, down)};
}

double cell_range_m(const AdcpSettings& settings, double cell) {
  return (settings.blank_m + (cell + 0.5) * settings.cell_m) / std::cos(settings.beam_angle_rad);
}

double bin_below_m(const AdcpSettings& settings, int bin) {
  return settings.blank_m + (bin + 0.5) * settings.cell_m;
}

std::optional<BinMapping> map_bin(const AdcpSettings& settings, const JanusBeams& beams, double below_m,
                                  double column_m) {
  BinMapping mapping;
  Symmetric sum;
  int used = 0;
  const double to_cells = std::cos(settings.beam_angle_rad) / settings.cell_m;
  for (std::size_t b = 0; b < janus_beams; ++b) {
    const Vector& beam = beams[b];
    if (beam.down < flattest_beam) continue;
    const double range_m = below_m / beam.down;
    const double cell = (range_m - cell_range_m(settings, 0.0)) * to_cells;
    if (cell < 0.0 || cell > settings.cells - 1 || range_m > column_m) continue;
    BinMapping::Reading& reading = mapping.beams[b];
    reading.used = true;
    reading.cell = std::min(static_cast<int>(cell), settings.cells - 2);
    reading.fraction = cell - reading.cell;
    sum.ee += beam.east * beam.east;
    sum.en += beam.east * beam.north;
    sum.ed += beam.east * beam.down;
    sum.nn += beam.north * beam.north;
    sum.nd += beam.north * beam.down;
    sum.dd += beam.down * beam.down;
    ++used;
  }
  if (used < 3) return std::nullopt;

  const double c_ee = sum.nn * sum.dd - sum.nd * sum.nd;
  const double c_en = sum.ed * sum.nd - sum.en * sum.dd;
  const double c_ed = sum.en * sum.nd - sum.ed * sum.nn;
  const double determinant = sum.ee * c_ee + sum.en * c_en + sum.ed * c_ed;
  if (determinant < least_determinant) return std::nullopt;
  const double c_nn = sum.ee * sum.dd - sum.ed * sum.ed;
  const double c_nd = sum.en * sum.ed - sum.ee * sum.nd;
  const double c_dd = sum.ee * sum.nn - sum.en * sum.en;
  for (std::size_t b = 0; b < janus_beams; ++b) {
    BinMapping::Reading& reading = mapping.beams[b];
    if (!reading.used) continue;
    const Vector& beam = beams[b];
    reading.weight_east = (c_ee * beam.east + c_en * beam.north + c_ed * beam.down) / determinant;
    reading.weight_north = (c_en * beam.east + c_nn * beam.north + c_nd * beam.down) / determinant;
    reading.weight_down = (c_ed * beam.east + c_nd * beam.north + c_dd * beam.down) / determinant;
  }
  return mapping;
}

}  // namespace floeplan::simulation
