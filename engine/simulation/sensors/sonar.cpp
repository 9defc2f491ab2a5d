#include "engine/simulation/sensors/sonar.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "engine/core/random.hpp"
#include "engine/core/units.hpp"

namespace floeplan::simulation {
namespace {

constexpr double most_rays = 4000.0;          // with at most this number, a ping takes under 1 ms
constexpr double rays_in_height = 5.0;        // number over a beam's height: they hit faces of a fifth of it
constexpr double least_false_alarm = 1e-12;   // probability per cell if no false alarms are wanted
constexpr float loudest_neighbour = 3.98F;    // 6 dB: if louder by more, the echo is the neighbour's
constexpr double faintest_echo = 0.05;        // share of the noise; detected hardly more than noise alone
constexpr std::size_t surface_entries = 256;  // of the table of surface backscattering
constexpr double right_angle = std::numbers::pi / 2.0;

double power_of(double level_db) { return std::pow(10.0, level_db / 10.0); }
double level_of(double power) { return 10.0 * std::log10(power); }

/// Unit vector at `azimuth` to the right of the axis and `elevation` above it.
avoidance::BodyVector direction(double azimuth, double elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          -std::sin(elevation)};
}

double product(const avoidance::BodyVector& a, const avoidance::BodyVector& b) {
  return a.forward * b.forward + a.starboard * b.starboard + a.down * b.down;
}

double row_elevation(const SonarSettings& settings, int row) {
  return settings.tilt_rad + (row - 0.5 * (settings.rows - 1)) * settings.row_step_rad;
}

double beam_azimuth(const SonarSettings& settings, int beam) {
  return (beam - 0.5 * (settings.beams - 1)) * settings.beam_step_rad;
}

}  // namespace

Sonar::Sonar(const SonarSettings& settings) : settings_{settings} {
  if (!settings.violations().empty())
    throw std::invalid_argument{"these settings of a sonar cannot be simulated"};
  cell_m_ = 0.5 * settings_.water.speed_m_s * settings_.pulse_s;
  first_cell_ = static_cast<int>(settings_.blind_m / cell_m_);
  cells_ = static_cast<int>(std::ceil(settings_.range_m / cell_m_));
  absorption_db_m_ = absorption_db_m(settings_.frequency_khz, settings_.water);
  side_lobes_ = power_of(2.0 * settings_.beam.side_lobes_db);
  lay_beams();
  lay_rays();
  weigh_rays();
  find_neighbours();
  tabulate();
}

std::span<const avoidance::SonarReturn> Sonar::ping_in_open_water(std::mt19937_64& rng) {
  detections_.clear();
  add_false_alarms(rng);
  hand_out();
  return returns_;
}

void Sonar::lay_beams() {
  for (int row = 0; row < settings_.rows; ++row) {
    for (int beam = 0; beam < settings_.beams; ++beam)
      beams_.push_back(direction(beam_azimuth(settings_, beam), row_elevation(settings_, row)));
  }
}

/// Makes a grid of rays in azimuth and elevation over all beams and a beam's width around them.
void Sonar::lay_rays() {
  const BeamPattern& beam = settings_.beam;
  const double step = std::min(settings_.beam_step_rad, beam.width_rad);
  const int to_side =
      static_cast<int>(std::ceil((beam_azimuth(settings_, settings_.beams - 1) + beam.width_rad) / step));
  const double lowest = std::max(-right_angle, row_elevation(settings_, 0) - beam.height_rad);
  const double highest =
      std::min(right_angle, row_elevation(settings_, settings_.rows - 1) + beam.height_rad);
  const double columns = 2.0 * to_side + 1.0;
  const double finest = std::max(beam.height_rad / rays_in_height, (highest - lowest) * columns / most_rays);
  const int levels = static_cast<int>(std::ceil((highest - lowest) / finest));
  const double height = (highest - lowest) / levels;

  for (int level = 0; level < levels; ++level) {
    const double elevation = lowest + (level + 0.5) * height;
    const double solid_angle = step * 2.0 * std::cos(elevation) * std::sin(0.5 * height);
    for (int column = -to_side; column <= to_side; ++column)
      rays_.push_back({direction(column * step, elevation), solid_angle});
  }
  heard_.resize(rays_.size());
}

/// A beam's weights are scaled to its equivalent solid angle, so that echoes of walls do not depend on the
/// spacing of rays.
void Sonar::weigh_rays() {
  const double one_way_floor = power_of(settings_.beam.side_lobes_db);
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const double azimuth = beam_azimuth(settings_, static_cast<int>(i) % settings_.beams);
    const double elevation = row_elevation(settings_, static_cast<int>(i) / settings_.beams);
    const avoidance::BodyVector side{-std::sin(azimuth), std::cos(azimuth), 0.0};
    const avoidance::BodyVector up{-std::sin(elevation) * std::cos(azimuth),
                                   -std::sin(elevation) * std::sin(azimuth), -std::cos(elevation)};
    std::vector<Weight> weights;
    double seen_sr = 0.0;
    for (std::size_t ray = 0; ray < rays_.size(); ++ray) {
      const avoidance::BodyVector& towards = rays_[ray].direction;
      if (product(towards, beams_[i]) <= 0.0) continue;
      const double one_way = beam_power(settings_.beam, product(towards, side), product(towards, up));
      if (one_way <= one_way_floor) continue;
      const double two_way = one_way * one_way - side_lobes_;
      weights.push_back({static_cast<std::uint32_t>(ray), static_cast<float>(two_way)});
      seen_sr += two_way * rays_[ray].solid_angle_sr;
    }
    const auto scale = static_cast<float>(reverberation_angle_sr(settings_.beam) / seen_sr);
    for (Weight& weight : weights) weight.two_way *= scale;
    weights_.push_back(std::move(weights));
  }
}

void Sonar::tabulate() {
  const double noise_db =
      level_of(power_of(noise_spectrum_db(settings_.frequency_khz, settings_.water.wind_m_s)) +
               power_of(settings_.receiver_noise_db)) +
      10.0 * std::log10(1.0 / settings_.pulse_s) - directivity_db(settings_.beam);
  const double volume_share =
      power_of(settings_.volume_strength_db) * reverberation_angle_sr(settings_.beam) * cell_m_;
  for (int cell = 0; cell < cells_; ++cell) {
    const double range_m = (cell + 0.5) * cell_m_;
    const double from_steradian =
        power_of(settings_.source_level_db - 2.0 * absorption_db_m_ * range_m) / (range_m * range_m);
    echo_.push_back(from_steradian);
    background_.push_back(power_of(noise_db) + volume_share * from_steradian);
  }
  for (std::size_t i = 0; i < surface_entries; ++i) {
    const double sine = (static_cast<double>(i) + 0.5) / static_cast<double>(surface_entries);
    surface_strength_.push_back(surface_backscatter(sine, settings_.frequency_khz, settings_.water.wind_m_s) /
                                sine);
  }
  total_.resize(static_cast<std::size_t>(cells_));
  const double places = static_cast<double>(beams_.size()) * (cells_ - first_cell_);
  false_alarm_log_ = std::log(std::clamp(settings_.false_alarms_per_ping / places, least_false_alarm, 0.5));
  returns_.reserve(avoidance::SonarPing::most_returns);
  detections_.reserve(avoidance::SonarPing::most_returns + 128);
  powers_.resize(beams_.size() * static_cast<std::size_t>(cells_));
  spans_.resize(beams_.size());
}

Sonar::Heard Sonar::heard(const Ray& ray, const RayHit& hit) const {
  const double reckoned_m = hit.range_m * (1.0 + settings_.sound_speed_error_share);
  const int cell = static_cast<int>(reckoned_m / cell_m_);
  if (cell < first_cell_ || cell >= cells_) return {};
  const double from_steradian = echo_[static_cast<std::size_t>(cell)] * ray.solid_angle_sr;
  if (hit.scatterer == Scatterer::open_surface) {
    const auto entry = std::min(surface_entries - 1, static_cast<std::size_t>(hit.cosine * surface_entries));
    return {cell, from_steradian * surface_strength_[entry], true};
  }
  const double strength_db =
      hit.scatterer == Scatterer::ice ? settings_.ice_strength_db : settings_.sea_bed_strength_db;
  return {cell, from_steradian * power_of(strength_db) * hit.cosine, false};
}

void Sonar::find_neighbours() {
  const auto of_row = static_cast<std::size_t>(settings_.beams);
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    std::vector<std::size_t> beside;
    if (i % of_row > 0) beside.push_back(i - 1);
    if (i % of_row + 1 < of_row) beside.push_back(i + 1);
    if (i >= of_row) beside.push_back(i - of_row);
    if (i + of_row < beams_.size()) beside.push_back(i + of_row);
    neighbours_.push_back(std::move(beside));
  }
}

/// Adds up the echoes in the beam's main lobe, cell by cell.
void Sonar::gather(std::size_t beam) {
  const auto cells = static_cast<std::size_t>(cells_);
  CellPower* powers = &powers_[beam * cells];
  Spans spans{{cells, 0}, {cells, 0}};
  for (const Weight& weight : weights_[beam]) {
    const Heard& from = heard_[weight.ray];
    if (from.cell < 0) continue;
    const auto cell = static_cast<std::size_t>(from.cell);
    const float power = weight.two_way * static_cast<float>(from.power);
    (from.open_surface ? powers[cell].surface : powers[cell].echo) += power;
    spans.heard = {std::min(spans.heard.begin, cell), std::max(spans.heard.end, cell + 1)};
    if (!from.open_surface)
      spans.echoes = {std::min(spans.echoes.begin, cell), std::max(spans.echoes.end, cell + 1)};
  }
  spans_[beam] = spans;
}

bool Sonar::is_a_neighbours(std::size_t beam, std::size_t cell) const {
  const auto cells = static_cast<std::size_t>(cells_);
  const float loudest = loudest_neighbour * powers_[beam * cells + cell].echo;
  return std::ranges::any_of(neighbours_[beam],
                             [&](std::size_t other) { return powers_[other * cells + cell].echo > loudest; });
}

void Sonar::forget_powers() {
  const auto cells = static_cast<std::size_t>(cells_);
  for (std::size_t beam = 0; beam < beams_.size(); ++beam) {
    for (std::size_t cell = spans_[beam].heard.begin; cell < spans_[beam].heard.end; ++cell)
      powers_[beam * cells + cell] = {};
  }
}

void Sonar::listen(std::size_t beam, std::mt19937_64& rng) {
  const CellSpan span = spans_[beam].echoes;
  int returned = 0;
  std::size_t end_of_last = 0;
  for (std::size_t cell = span.begin; cell < span.end; ++cell) {
    const CellPower& heard_here = powers_[beam * static_cast<std::size_t>(cells_) + cell];
    const auto echo = static_cast<double>(heard_here.echo);
    const auto surface = static_cast<double>(heard_here.surface);
    const double against = background_[cell] + surface + side_lobes_ * total_[cell];
    if (echo <= faintest_echo * against) continue;
    const double mean = against + echo;
    // Detected if log(chance) is at most the exponent. As exp(x) <= 1 / (1 - x), most cases need no
    // logarithm.
    const double chance = 1.0 - core::uniform(rng);
    const double exponent = false_alarm_log_ * against / mean;
    if (chance * (1.0 - exponent) > 1.0 || std::log(chance) > exponent) continue;
    if (is_a_neighbours(beam, cell)) continue;

    // An exponential distribution above a threshold has the same form as from zero.
    const double level_db = level_of(-false_alarm_log_ * against - mean * std::log1p(-core::uniform(rng)));
    if (returned > 0 && cell == end_of_last) {
      detections_.back().level_db = std::max(detections_.back().level_db, level_db);
      end_of_last = cell + 1;
    } else if (returned < settings_.most_returns_per_beam) {
      detections_.push_back({beam, static_cast<int>(cell), level_db});
      end_of_last = cell + 1;
      ++returned;
    }
  }
}

void Sonar::add_false_alarms(std::mt19937_64& rng) {
  const int alarms = core::poisson(rng, settings_.false_alarms_per_ping);
  for (int i = 0; i < alarms; ++i) {
    const auto beam = static_cast<std::size_t>(core::uniform(rng) * static_cast<double>(beams_.size()));
    const int cell = first_cell_ + static_cast<int>(core::uniform(rng) * (cells_ - first_cell_));
    const double mean = background_[static_cast<std::size_t>(cell)];
    detections_.push_back(
        {beam, cell, level_of(mean * (-false_alarm_log_ - std::log1p(-core::uniform(rng))))});
  }
}

/// Sorts the returns by beam, then by range, so that false alarms and echoes cannot be told apart.
void Sonar::hand_out() {
  std::ranges::sort(detections_, [](const Detection& a, const Detection& b) {
    return std::tie(a.beam, a.cell, a.level_db) < std::tie(b.beam, b.cell, b.level_db);
  });
  returns_.clear();
  for (const Detection& detection : detections_) {
    if (returns_.size() == avoidance::SonarPing::most_returns) return;
    returns_.push_back(
        {core::Metres{(detection.cell + 0.5) * cell_m_}, beams_[detection.beam], detection.level_db});
  }
}

double Sonar::background_db(double range_m) const {
  const int cell = std::clamp(static_cast<int>(range_m / cell_m_), 0, cells_ - 1);
  return level_of(background_[static_cast<std::size_t>(cell)]);
}

double Sonar::threshold_db() const { return level_of(-false_alarm_log_); }

double Sonar::echo_of_wall_db(double range_m, double strength_db) const {
  const double loss_db = 40.0 * std::log10(range_m) + 2.0 * absorption_db_m_ * range_m;
  const double area_db = level_of(range_m * range_m * reverberation_angle_sr(settings_.beam));
  return settings_.source_level_db - loss_db + strength_db + area_db;
}

}  // namespace floeplan::simulation
