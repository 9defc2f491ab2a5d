#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_mission_axes.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::ocean {

/// Source of the magnetic variation that relates a vehicle's axes to its UTM grid.
enum class VariationSource {
  log_axes,        // x_utm_to_lmc_00 and _01 in the log: the rotation itself
  log_variation,   // m_gps_mag_var in the log
  magnetic_model,  // computed: geo::declination_at at the place and time at which the mission began
};

/// Names in files: "x_utm_to_lmc", "m_gps_mag_var" or "world-magnetic-model".
[[nodiscard]] std::string_view source_name(VariationSource source);
[[nodiscard]] std::optional<VariationSource> parse_variation_source(std::string_view name);

/// The axes of a Slocum's currents, and their source.
struct VehicleAxes {
  geo::LocalMissionAxes axes;
  VariationSource source{};

  friend bool operator==(VehicleAxes, VehicleAxes) = default;
};

/// Text for the pilot: the zone, the variation and its source.
[[nodiscard]] std::string words_of(const VehicleAxes& known);

/// The values in one row of a Slocum's log that concern its axes, in the log's own units; empty if not
/// logged.
struct AxesRow {
  std::optional<core::UtcTime> time{};
  std::optional<geo::LonLat> fix{};
  std::optional<geo::LonLat> place{};     // fix or dead reckoning
  std::optional<double> cosine{};         // x_utm_to_lmc_00
  std::optional<double> sine{};           // x_utm_to_lmc_01
  std::optional<double> variation_rad{};  // m_gps_mag_var, west positive
  std::optional<double> utm_zone{};       // x_lmc_utm_zone_digit
  int segment{};                          // segment number of the mission; 0: the first, or not logged
};

/// Finds the axes of a Slocum's currents in its log. Takes the rows one after another from the first.
/// Variation  from x_utm_to_lmc_00 and _01, otherwise m_gps_mag_var, otherwise the World Magnetic Model. A
///            vehicle sets its axes once, at the beginning of its mission, so the first value counts. A value
///            of exactly 0 is skipped if another follows: vehicles log it before the receiver gives one
/// Zone       from x_lmc_utm_zone_digit, otherwise that of the first fix, otherwise of the first place
/// Edges      In a log of several missions the axes change at the row where x_utm_to_lmc changes. Values
///            outside the range of their sensor are skipped
class LoggedAxes {
 public:
  /// Returns  the number of the axes that are valid from this row on
  std::size_t note(const AxesRow& row);

  /// The axes with a number that `note` returned, by all rows so far.
  /// Outside  nullopt if they are unknown: no place at all, or neither a variation nor a time within the
  ///          period of the model
  [[nodiscard]] std::optional<VehicleAxes> axes(std::size_t number) const;

  /// Reasons to doubt the axes, for the pilot: a variation that is impossible or far from the model's; a zone
  /// that may be a different one, because of the UTM's exceptions or because the mission began before the
  /// log.
  [[nodiscard]] std::vector<std::string> doubts(std::size_t number) const;

 private:
  /// The values found for one mission.
  struct Mission {
    std::optional<double> turn_rad;  // angle of the axes from the UTM grid
    std::optional<double> variation_rad;
    std::optional<int> utm_zone;
    std::optional<geo::LonLat> fix;
    std::optional<geo::LonLat> place;
    std::optional<core::UtcTime> began;
    std::optional<double> impossible_variation;  // m_gps_mag_var outside the range of angles
    int segment{};                               // segment of the mission at which the log begins
  };

  [[nodiscard]] std::optional<geo::LonLat> origin(std::size_t number) const;

  std::vector<Mission> missions_{1};
  bool begun_{false};
};

}  // namespace floeplan::ocean
