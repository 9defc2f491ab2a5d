#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/tide/prediction.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/repository/fields/tide_repository.hpp"

namespace floeplan::ingest {

/// A harmonic constant with the values of its file.
struct ConstituentRow {
  std::string name;
  double amplitude{};
  double phase_deg{};  // phase lag behind the equilibrium tide at Greenwich
  std::optional<double> speed_deg_h;
};

/// Collects the constants of one station.
class StationRows {
 public:
  /// Adds a constant. `metres` is the length of one unit of the amplitude. Rows without an amplitude and
  /// unknown constituents are ignored.
  /// Errors   an amplitude below 0 or over 20 m; a phase over two turns; a speed of another constituent; a
  ///          constituent twice
  [[nodiscard]] Checked<bool> add(const ConstituentRow& row, double metres);

  [[nodiscard]] std::vector<tide::HarmonicConstant> constants() && { return std::move(constants_); }
  /// Adds a warning that names the unknown constituents.
  void warn(Messages& warnings) const;

 private:
  std::vector<tide::HarmonicConstant> constants_;
  std::vector<std::string> unknown_;
  double unknown_m_{};
};

/// Speed of a constituent in degrees per hour.
[[nodiscard]] double speed_deg_h(tide::Constituent constituent);
/// Whether a file's speed is that of the constituent, within the usual rounding of 0.001 degrees per hour.
[[nodiscard]] bool is_speed_of(tide::Constituent constituent, double stated_deg_h);

/// Metres per unit; empty if it is not a unit of length.
[[nodiscard]] std::optional<double> metres_of(const std::string& unit);

/// The dataset of the stations.
/// Errors   no station, or one without constants
[[nodiscard]] Checked<PreparedDataset> prepared_stations(std::vector<repository::TideStation> stations,
                                                         Messages warnings);

}  // namespace floeplan::ingest
