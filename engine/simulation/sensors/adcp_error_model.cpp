#include "engine/simulation/sensors/adcp_error_model.hpp"

#include <cmath>
#include <stdexcept>

namespace floeplan::simulation {
namespace {

/// Variance in depth of the water that one reading of a beam averages. It comes from a triangle two cells
/// wide (pulse and gate are one cell each) and from the interpolation between two cells.
double smoothing_m2(const AdcpSettings& settings, const Vector& beam, double fraction) {
  const double cell_m = settings.cell_m / std::cos(settings.beam_angle_rad) * beam.down;
  return cell_m * cell_m * (1.0 / 6.0 + fraction * (1.0 - fraction));
}

}  // namespace

AdcpErrorModel::AdcpErrorModel(const AdcpSettings& settings) : settings_{settings} {
  if (!settings_.violations().empty())
    throw std::invalid_argument{"these settings of an ADCP cannot be simulated"};
  truth_.reserve(static_cast<std::size_t>(settings_.cells) + 2);
  bins_.reserve(static_cast<std::size_t>(settings_.cells));
}

std::span<const avoidance::CurrentBin> AdcpErrorModel::detect(const AdcpMoment& moment,
                                                              std::mt19937_64& rng) {
  for (CellNoise& noise : noise_) draw_cell_noise(settings_, rng, noise);
  const double attitude_sigma = settings_.attitude_sigma_rad / std::sqrt(settings_.pings);
  Attitude turned = moment.sensed;
  turned.heading_rad += attitude_sigma * core::normal(rng);
  turned.pitch_rad += attitude_sigma * core::normal(rng);
  turned.roll_rad += attitude_sigma * core::normal(rng);

  bins_.clear();
  const JanusBeams true_beams = janus_beams_of(settings_, moment.state.attitude);
  const JanusBeams sensed_beams = janus_beams_of(settings_, turned);
  for (int bin = 0; bin < settings_.cells; ++bin) {
    const auto mapping = map_bin(settings_, sensed_beams, bin_below_m(settings_, bin), moment.column_m);
    if (mapping) add_bin(moment, bin, *mapping, true_beams, sensed_beams);
  }
  return bins_;
}

void AdcpErrorModel::add_bin(const AdcpMoment& moment, int bin, const BinMapping& mapping,
                             const JanusBeams& true_beams, const JanusBeams& sensed_beams) {
  const auto row = static_cast<std::size_t>(bin) + 1;
  if (!truth_[row]) return;
  const Vector water = *truth_[row];
  const Vector above = truth_[row - 1].value_or(water);
  const Vector below = truth_[row + 1].value_or(water);
  const Vector shear = (0.5 / settings_.cell_m) * (below - above);
  const Vector curvature = (1.0 / (settings_.cell_m * settings_.cell_m)) * (above + below - 2.0 * water);
  const double sunk_m = moment.state.over_ground.down * settings_.ping_interval_s * settings_.pings;
  const double noise_m_s = settings_.ping_sigma_m_s / std::sqrt(settings_.pings);

  Vector relative{};
  double variance = 0.0;
  for (std::size_t b = 0; b < janus_beams; ++b) {
    const BinMapping::Reading& reading = mapping.beams[b];
    if (!reading.used) continue;
    const auto cell = static_cast<std::size_t>(reading.cell);
    const double f = reading.fraction;
    const double lower_m = bin_below_m(settings_, bin) * (true_beams[b].down / sensed_beams[b].down - 1.0);
    const double smoothed_m2 =
        smoothing_m2(settings_, true_beams[b], f) + sunk_m * sunk_m / 12.0 + lower_m * lower_m;
    const Vector seen = water - moment.state.over_ground + lower_m * shear + 0.5 * smoothed_m2 * curvature;
    const double radial =
        dot(true_beams[b], seen) + noise_m_s * ((1.0 - f) * noise_[b][cell] + f * noise_[b][cell + 1]);
    relative = relative + radial * Vector{reading.weight_east, reading.weight_north, reading.weight_down};
    const double share =
        (1.0 - f) * (1.0 - f) + f * f + 2.0 * f * (1.0 - f) * settings_.neighbour_correlation;
    variance += 0.5 * share * noise_m_s * noise_m_s *
                (reading.weight_east * reading.weight_east + reading.weight_north * reading.weight_north);
  }

  const Vector detected = relative + moment.state.over_ground;
  const double turning_m_s = settings_.attitude_sigma_rad / std::sqrt(settings_.pings) * length(relative);
  variance += turning_m_s * turning_m_s + settings_.reference_sigma_m_s * settings_.reference_sigma_m_s;
  bins_.push_back(
      {core::Metres{moment.state.position.down + bin_below_m(settings_, bin)},
       {{detected.east + moment.reference.east_m_s}, {detected.north + moment.reference.north_m_s}},
       {std::sqrt(variance)}});
}

}  // namespace floeplan::simulation
