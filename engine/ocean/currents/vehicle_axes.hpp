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

/// Source of the magnetic variation by which a vehicle's axes are turned from its grid.
enum class VariationSource {
  log_axes,        // the log's: x_utm_to_lmc_00 and _01, the turn itself
  log_variation,   // the log's: m_gps_mag_var
  magnetic_model,  // ours: geo::declination_at where and when the mission began
};

/// "x_utm_to_lmc", "m_gps_mag_var" or "world-magnetic-model".
[[nodiscard]] std::string_view source_name(VariationSource source);
[[nodiscard]] std::optional<VariationSource> parse_variation_source(std::string_view name);

/// Axes of a Slocum's currents, and how they are known.
struct VehicleAxes {
  geo::LocalMissionAxes axes;
  VariationSource source{};

  friend bool operator==(VehicleAxes, VehicleAxes) = default;
};

/// For the pilot: what the currents were turned by.
[[nodiscard]] std::string words_of(const VehicleAxes& known);

/// What one row of a Slocum's log says of its axes, in the log's own units; empty where it says nothing.
struct AxesRow {
  std::optional<core::UtcTime> time{};
  std::optional<geo::LonLat> fix{};
  std::optional<geo::LonLat> place{};     // fixed or reckoned
  std::optional<double> cosine{};         // x_utm_to_lmc_00
  std::optional<double> sine{};           // x_utm_to_lmc_01
  std::optional<double> variation_rad{};  // m_gps_mag_var, west positive
  std::optional<double> utm_zone{};       // x_lmc_utm_zone_digit
  int segment{};                          // of its mission; 0: the first, or not told
};

/// Finds the axes of a Slocum's currents in its log, row after row from the first.
/// Variation  x_utm_to_lmc_00 and _01, else m_gps_mag_var, else the World Magnetic Model. A vehicle sets its axes once,
///            when its mission begins: the first variation counts, and none of exactly 0 beside another, as is logged
///            before the receiver has told one
/// Zone       x_lmc_utm_zone_digit, else that of the first fix, else of the first place
/// Edges      a log of several missions has other axes from the row on where x_utm_to_lmc changes. Numbers that can be
///            none of their sensor are passed over
class LoggedAxes {
 public:
  /// Returns  the number of the axes that hold from this row on
  std::size_t note(const AxesRow& row);

  /// The axes of a number that `note` gave, by all rows so far.
  /// Outside  nullopt where nothing tells them: no place at all, or neither a variation nor a time within the model's
  [[nodiscard]] std::optional<VehicleAxes> axes(std::size_t number) const;

  /// What makes the axes doubtful, for the pilot: a variation that is impossible or far from the model's; a zone that
  /// may be another, by the exceptions of the UTM or because the mission began before the log.
  [[nodiscard]] std::vector<std::string> doubts(std::size_t number) const;

 private:
  /// What is known of the axes of one mission.
  struct Mission {
    std::optional<double> turn_rad;  // of the axes from the grid
    std::optional<double> variation_rad;
    std::optional<int> utm_zone;
    std::optional<geo::LonLat> fix;
    std::optional<geo::LonLat> place;
    std::optional<core::UtcTime> began;
    std::optional<double> impossible_variation;  // m_gps_mag_var that is no angle in its unit
    int segment{};                               // of the mission, where the log begins
  };

  [[nodiscard]] std::optional<geo::LonLat> origin(std::size_t number) const;

  std::vector<Mission> missions_{1};
  bool begun_{false};
};

}  // namespace floeplan::ocean
