#include "engine/simulation/logs/glider_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/flight_fault_messages.hpp"
#include "engine/mission/document/packed_degrees.hpp"
#include "engine/simulation/logs/log_table.hpp"
#include "engine/simulation/logs/logged_positions.hpp"

namespace floeplan::simulation {
namespace {

/// A smaller turn of the saw-tooth is heave of the vehicle.
constexpr double least_turn_m = 3.0;
/// The pump has begun a stroke once it has moved this share of it.
constexpr double stroke_begun = 0.05;
/// Below this depth the hull glides, so its pitch shows the settings.
constexpr double gliding_from_m = 5.0;
constexpr double flattest_glide_rad = 0.15;
constexpr double cm3 = 1e-6;
/// Longest dive of a Slocum. If a dive of a log is longer, the times of the log have a jump.
constexpr core::Seconds longest_dive{10.0 * 86400.0};
/// Part of the time between two turns in which the glide is steady, as shares of that time.
constexpr double middle_from = 0.3;
constexpr double middle_to = 0.7;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::optional<geo::LonLat> place_of(std::optional<double> lon, std::optional<double> lat) {
  return lon && lat ? mission::unpack_place(*lon, *lat) : std::nullopt;
}

geo::LonLat half_way(geo::LonLat from, geo::LonLat to) {
  return {geo::wrap_longitude(from.lon_deg + 0.5 * geo::longitude_difference(from.lon_deg, to.lon_deg)),
          0.5 * (from.lat_deg + to.lat_deg)};
}

struct Turn {
  std::size_t row;
  double depth_m;
  bool deep;
};

/// Rows of one dive: the first under water, the first at the surface after it, and the first with a fix there.
struct Span {
  std::size_t first;
  std::size_t surfaced;
  std::size_t fixed;
};

class Reader {
 public:
  explicit Reader(LogTable log) : log_{std::move(log)} {}

  tl::expected<std::vector<LoggedSegment>, core::Violations> read() {
    for (const char* name : {"m_present_time", "m_lat", "m_lon", "m_gps_lat", "m_gps_lon", "m_depth",
                             "m_pitch", "x_dr_state", "m_water_vx", "m_water_vy", "c_wpt_lat", "c_wpt_lon"}) {
      if (!log_.has(name))
        found_.push_back(messages::flight_fault<"column-missing">(std::string{"/"} + name));
    }
    if (!log_.has("m_initial_water_vx") && !log_.has("m_final_water_vx"))
      found_.push_back(messages::flight_fault<"column-of-currents-missing">("/m_initial_water_vx"));
    if (!pump_column())
      found_.push_back(messages::flight_fault<"column-of-pump-missing">("/m_ballast_pumped"));
    if (!found_.empty()) return tl::unexpected(std::move(found_));

    const auto positions = settle_positions(log_);
    if (!positions) return tl::unexpected(core::Violations{positions.error()});
    note_axes();
    std::vector<LoggedSegment> segments;
    for (const Span& span : spans()) {
      const auto axes = axes_.axes(axes_at_.at(span.first));
      if (!axes) return tl::unexpected(core::Violations{unknown_axes()});
      if (auto segment = segment_of(span, *axes)) segments.push_back(std::move(*segment));
    }
    for (LoggedSegment& segment : segments) segment.positions_read = positions->value_or("");
    if (segments.empty())
      return tl::unexpected(core::Violations{messages::flight_fault<"no-dive-in-log">("/x_dr_state")});
    return segments;
  }

 private:
  static core::Violation unknown_axes() {
    return messages::flight_fault<"axes-of-currents-unknown">("/m_gps_mag_var");
  }

  /// Passes all rows to LoggedAxes, and stores which axes are valid at each row.
  void note_axes() {
    const auto told = [&](const char* name, std::size_t row) {
      return log_.has(name) ? log_[name][row] : std::nullopt;
    };
    axes_at_.reserve(log_.rows());
    for (std::size_t row = 0; row < log_.rows(); ++row) {
      const auto seconds = log_["m_present_time"][row];
      axes_at_.push_back(
          axes_.note({.time = seconds ? std::optional{core::from_unix_seconds(*seconds)} : std::nullopt,
                      .fix = fix_at(row),
                      .place = place_of(log_["m_lon"][row], log_["m_lat"][row]),
                      .cosine = told("x_utm_to_lmc_00", row),
                      .sine = told("x_utm_to_lmc_01", row),
                      .variation_rad = told("m_gps_mag_var", row),
                      .utm_zone = told("x_lmc_utm_zone_digit", row)}));
    }
  }

  [[nodiscard]] std::optional<std::string> pump_column() const {
    for (const char* name : {"m_ballast_pumped", "m_de_oil_vol"}) {
      if (!log_.has(name)) continue;
      const auto moves = [](const std::optional<double>& cc) { return cc && std::abs(*cc) > 1.0; };
      if (std::ranges::any_of(log_[name], moves)) return name;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::vector<Span> spans() const {
    std::vector<Span> spans;
    enum class Where { unknown, under_water, up } where{Where::unknown};
    Span span{};
    for (std::size_t row = 0; row < log_.rows(); ++row) {
      const auto state = log_["x_dr_state"][row];
      if (!state) continue;
      if (*state == 1.0) {
        if (where != Where::under_water) span.first = row;
        where = Where::under_water;
      } else if (where == Where::under_water) {
        span.surfaced = row;
        where = Where::up;
      }
      if (*state == 3.0 && where == Where::up && fix_at(row)) {
        span.fixed = row;
        spans.push_back(span);
        where = Where::unknown;
      }
    }
    return spans;
  }

  [[nodiscard]] std::optional<geo::LonLat> fix_at(std::size_t row) const {
    return place_of(log_["m_gps_lon"][row], log_["m_gps_lat"][row]);
  }

  [[nodiscard]] std::optional<core::UtcTime> time_of(std::size_t row) const {
    const auto seconds = log_.before("m_present_time", row);
    if (!seconds) return std::nullopt;
    return core::from_unix_seconds(*seconds);
  }

  [[nodiscard]] std::optional<geo::VelocityLmc> current(const std::string& stem, std::size_t row) const {
    if (!log_.has(stem + "_vx") || !log_.has(stem + "_vy")) return std::nullopt;
    const auto x = log_.before(stem + "_vx", row);
    const auto y = log_.before(stem + "_vy", row);
    if (!x || !y) return std::nullopt;
    return geo::VelocityLmc{{*x}, {*y}};
  }

  /// The vehicle's own estimate of this dive's mean current after it: the final estimate if it changed after
  /// the dive, otherwise the initial one.
  [[nodiscard]] std::optional<geo::VelocityLmc> depth_averaged(const Span& span) const {
    const std::size_t last = last_row_at_surface(span);
    for (const char* stem : {"m_final_water", "m_initial_water"}) {
      const auto before = current(stem, span.surfaced);
      const auto after = current(stem, last);
      if (after && after != before) return after;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::size_t last_row_at_surface(const Span& span) const {
    std::size_t row = span.fixed;
    while (row + 1 < log_.rows() && log_["x_dr_state"][row + 1].value_or(0.0) != 1.0) ++row;
    return row;
  }

  [[nodiscard]] std::vector<Turn> turns_of(const Span& span) const {
    std::vector<Turn> turns;
    bool sinks = true;
    std::optional<Turn> extreme;
    for (std::size_t row = span.first; row < span.surfaced; ++row) {
      const auto depth_m = log_["m_depth"][row];
      if (!depth_m) continue;
      const double further =
          extreme ? (sinks ? *depth_m - extreme->depth_m : extreme->depth_m - *depth_m) : 1.0;
      if (further > 0.0) {
        extreme = Turn{row, *depth_m, sinks};
      } else if (further < -least_turn_m) {
        turns.push_back(*extreme);
        sinks = !sinks;
        extreme = Turn{row, *depth_m, sinks};
      }
    }
    return turns;
  }

  /// Depth at which the pump begins the stroke for a turn; searched backwards from the turn.
  [[nodiscard]] double depth_of_command(const Turn& turn, const std::string& pump, double low_cc,
                                        double high_cc) const {
    const double begun_cc =
        turn.deep ? low_cc + stroke_begun * (high_cc - low_cc) : high_cc - stroke_begun * (high_cc - low_cc);
    for (std::size_t row = turn.row; row-- > 0;) {
      const auto cc = log_[pump][row];
      const bool rests = cc && (turn.deep ? *cc <= begun_cc : *cc >= begun_cc);
      if (rests) return log_.before("m_depth", row).value_or(turn.depth_m);
    }
    return turn.depth_m;
  }

  [[nodiscard]] std::vector<LoggedSegment::Waypoint> waypoints_of(const Span& span) const {
    std::vector<LoggedSegment::Waypoint> waypoints;
    for (std::size_t row = span.first; row < span.surfaced; ++row) {
      const auto lon = log_.before("c_wpt_lon", row);
      const auto lat = log_.before("c_wpt_lat", row);
      if (!lon || !lat || (*lon == 0.0 && *lat == 0.0)) continue;
      const auto place = place_of(lon, lat);
      if (!place || (!waypoints.empty() && waypoints.back().place == *place)) continue;
      if (!waypoints.empty()) {
        const auto here = place_of(log_.before("m_lon", row), log_.before("m_lat", row));
        if (here)
          waypoints.back().reached_within = geo::geodesic_between(*here, waypoints.back().place).length;
      }
      waypoints.push_back({.place = *place, .reached_within = {}});
    }
    return waypoints;
  }

  [[nodiscard]] std::optional<LoggedSegment> segment_of(const Span& span,
                                                        const ocean::VehicleAxes& known) const {
    const auto start = place_of(log_.before("m_lon", span.first), log_.before("m_lat", span.first));
    const auto end = fix_at(span.fixed);
    const auto dived = time_of(span.first);
    const auto surfaced = time_of(span.surfaced);
    const auto reckoned_with = current("m_water", span.first);
    const auto averaged = depth_averaged(span);
    const auto waypoints = waypoints_of(span);
    const std::vector<Turn> turns = turns_of(span);
    const auto deep = std::ranges::count(turns, true, &Turn::deep);
    if (!start || !end || !dived || !surfaced || !reckoned_with || !averaged || waypoints.empty() || deep < 2)
      return std::nullopt;

    if (!(*surfaced > *dived) || *surfaced - *dived > longest_dive) return std::nullopt;
    const geo::LonLat middle = half_way(*start, *end);
    LoggedSegment segment{.dived = *dived,
                          .surfaced = *surfaced,
                          .fixed = *time_of(span.fixed),
                          .start = *start,
                          .end = *end,
                          .reckoned_with = known.axes.to_true(*reckoned_with, middle),
                          .depth_averaged = known.axes.to_true(*averaged, middle),
                          .turned_from = known,
                          .waypoints = waypoints};
    segment.dives = static_cast<int>(deep);
    if (!read_settings(span, turns, segment)) return std::nullopt;
    const auto last_deep = std::ranges::find(turns.rbegin(), turns.rend(), true, &Turn::deep);
    segment.until_ascent = 0.5 * ((*time_of(last_deep->row) - *dived) + segment.under_water());
    return segment;
  }

  /// Median vertical speed in the middle of the glides that begin at such turns.
  [[nodiscard]] core::MetresPerSecond rate_after(const std::vector<Turn>& turns, bool deep) const {
    std::vector<double> rates;
    for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
      if (turns[i].deep != deep) continue;
      const double from_m = std::lerp(turns[i].depth_m, turns[i + 1].depth_m, middle_from);
      const double to_m = std::lerp(turns[i].depth_m, turns[i + 1].depth_m, middle_to);
      const auto [low_m, high_m] = std::minmax(from_m, to_m);
      std::optional<std::size_t> first;
      std::size_t last = turns[i].row;
      for (std::size_t row = turns[i].row; row < turns[i + 1].row; ++row) {
        const auto depth_m = log_["m_depth"][row];
        if (!depth_m || *depth_m < low_m || *depth_m > high_m) continue;
        if (!first) first = row;
        last = row;
      }
      if (!first || last == *first) continue;
      const double moved_m = std::abs(*log_["m_depth"][last] - *log_["m_depth"][*first]);
      const core::Seconds took = *time_of(last) - *time_of(*first);
      if (took.count() > 0.0) rates.push_back(moved_m / took.count());
    }
    return {rates.empty() ? 0.0 : median(rates)};
  }

  /// False if pump or pitch do not distinguish dive from climb.
  [[nodiscard]] bool read_settings(const Span& span, const std::vector<Turn>& turns,
                                   LoggedSegment& segment) const {
    const std::string pump = *pump_column();
    std::vector<double> strokes_cc;
    std::vector<double> down_rad;
    std::vector<double> up_rad;
    for (std::size_t row = span.first; row < span.surfaced; ++row) {
      if (const auto cc = log_[pump][row]) strokes_cc.push_back(*cc);
      const auto pitch = log_["m_pitch"][row];
      if (!pitch || log_.before("m_depth", row).value_or(0.0) < gliding_from_m) continue;
      if (*pitch < -flattest_glide_rad) down_rad.push_back(*pitch);
      if (*pitch > flattest_glide_rad) up_rad.push_back(*pitch);
    }
    if (strokes_cc.empty() || down_rad.empty() || up_rad.empty()) return false;
    const auto [low, high] = std::ranges::minmax(strokes_cc);
    std::vector<double> heavy_cc;
    std::vector<double> light_cc;
    for (const double cc : strokes_cc) (cc < 0.5 * (low + high) ? heavy_cc : light_cc).push_back(cc);
    if (heavy_cc.empty() || median(heavy_cc) >= 0.0 || median(light_cc) <= 0.0) return false;
    segment.dive_buoyancy = {cm3 * median(heavy_cc)};
    segment.climb_buoyancy = {cm3 * median(light_cc)};
    segment.dive_pitch = {median(down_rad)};
    segment.climb_pitch = {median(up_rad)};
    std::vector<double> deep_m;
    std::vector<double> shallow_m;
    for (const Turn& turn : turns)
      (turn.deep ? deep_m : shallow_m).push_back(depth_of_command(turn, pump, low, high));
    segment.sinks = rate_after(turns, false);
    segment.rises = rate_after(turns, true);
    segment.turns_down_at = {median(deep_m)};
    segment.turns_up_at = {shallow_m.empty() ? 0.0 : median(shallow_m)};
    return true;
  }

  LogTable log_;
  ocean::LoggedAxes axes_;
  std::vector<std::size_t> axes_at_;  // for each row
  core::Violations found_;
};

}  // namespace

core::CubicMetres LoggedSegment::trim() const {
  if (!(sinks.value > 0.0) || !(rises.value > 0.0)) return {0.0};
  const double light_over_heavy = std::pow(rises.value / sinks.value, 2);
  return {(light_over_heavy * -dive_buoyancy.value - climb_buoyancy.value) / (1.0 + light_over_heavy)};
}

tl::expected<std::vector<LoggedSegment>, core::Violations> read_glider_log(std::string_view text) {
  auto table = LogTable::read(text);
  if (!table) return tl::unexpected(std::move(table.error()));
  return Reader{std::move(*table)}.read();
}

}  // namespace floeplan::simulation
