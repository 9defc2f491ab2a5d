#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "engine/core/random.hpp"
#include "engine/simulation/sensors/adcp_error_model.hpp"

namespace floeplan::simulation {

/// The current profile by simulating every ping, beam and cell: the reference for the error model. A ping
/// measures the water along each beam, weighted by a triangle two cells wide, at the vehicle's place and
/// attitude at that time. Noise is drawn for every cell. The processing maps bins and rotates velocities by
/// the attitude sensed for the ping, averages the pings that reach a bin, and adds the velocity over ground.
/// Precondition the settings have no violations
template <WaterAt Water>
[[nodiscard]] std::vector<avoidance::CurrentBin> simulate_adcp_beams(const AdcpSettings& settings,
                                                                     const AdcpMoment& moment,
                                                                     const Water& water,
                                                                     std::mt19937_64& rng) {
  constexpr std::array<double, 5> places{-2.0 / 3.0, -1.0 / 3.0, 0.0, 1.0 / 3.0, 2.0 / 3.0};  // in cells
  constexpr std::array<double, 5> shares{1.0 / 9.0, 2.0 / 9.0, 3.0 / 9.0, 2.0 / 9.0, 1.0 / 9.0};
  const auto cells = static_cast<std::size_t>(settings.cells);
  std::vector<Vector> sums(cells);
  std::vector<int> counts(cells);

  const auto swayed = [&](Attitude attitude, double sigma) {
    attitude.heading_rad += sigma * core::normal(rng);
    attitude.pitch_rad += sigma * core::normal(rng);
    attitude.roll_rad += sigma * core::normal(rng);
    return attitude;
  };
  const Attitude& mean = moment.state.attitude;
  for (int ping = 0; ping < settings.pings; ++ping) {
    const double since_middle_s = (ping + 0.5 - 0.5 * settings.pings) * settings.ping_interval_s;
    const Vector from = moment.state.position + since_middle_s * moment.state.over_ground;
    const Attitude attitude = swayed(mean, settings.sway_sigma_rad);
    const JanusBeams beams = janus_beams_of(settings, attitude);
    const Attitude constant{attitude.heading_rad + moment.sensed.heading_rad - mean.heading_rad,
                            attitude.pitch_rad + moment.sensed.pitch_rad - mean.pitch_rad,
                            attitude.roll_rad + moment.sensed.roll_rad - mean.roll_rad};
    const JanusBeams sensed = janus_beams_of(settings, swayed(constant, settings.attitude_sigma_rad));

    std::array<std::array<double, most_adcp_cells>, janus_beams> radial{};
    for (std::size_t b = 0; b < janus_beams; ++b) {
      CellNoise noise{};
      draw_cell_noise(settings, rng, noise);
      for (std::size_t cell = 0; cell < cells; ++cell) {
        double along = settings.ping_sigma_m_s * noise[cell];
        for (std::size_t i = 0; i < places.size(); ++i) {
          const double range_m = cell_range_m(settings, static_cast<double>(cell) + places[i]);
          const std::optional<Vector> velocity = water(from + range_m * beams[b]);
          if (velocity) along += shares[i] * dot(*velocity - moment.state.over_ground, beams[b]);
        }
        radial[b][cell] = along;
      }
    }
    for (std::size_t bin = 0; bin < cells; ++bin) {
      const auto mapping =
          map_bin(settings, sensed, bin_below_m(settings, static_cast<int>(bin)), moment.column_m);
      if (!mapping) continue;
      Vector velocity{};
      for (std::size_t b = 0; b < janus_beams; ++b) {
        const BinMapping::Reading& reading = mapping->beams[b];
        if (!reading.used) continue;
        const auto cell = static_cast<std::size_t>(reading.cell);
        const double read =
            (1.0 - reading.fraction) * radial[b][cell] + reading.fraction * radial[b][cell + 1];
        velocity = velocity + read * Vector{reading.weight_east, reading.weight_north, reading.weight_down};
      }
      sums[bin] = sums[bin] + velocity;
      ++counts[bin];
    }
  }

  std::vector<avoidance::CurrentBin> profile;
  for (std::size_t bin = 0; bin < cells; ++bin) {
    if (2 * counts[bin] < settings.pings) continue;  // usual rule: half of the pings must be good
    const Vector detected = (1.0 / counts[bin]) * sums[bin] + moment.state.over_ground;
    profile.push_back(
        {core::Metres{moment.state.position.down + bin_below_m(settings, static_cast<int>(bin))},
         {{detected.east + moment.reference.east_m_s}, {detected.north + moment.reference.north_m_s}},
         {settings.ping_sigma_m_s}});
  }
  return profile;
}

}  // namespace floeplan::simulation
