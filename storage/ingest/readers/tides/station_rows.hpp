#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/tide/prediction.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/repository/fields/tide_repository.hpp"

namespace floeplan::ingest {

/// A harmonic constant as its file gives it.
struct ConstituentRow {
  std::string name;
  double amplitude{};
  double phase_deg{};  // behind Greenwich
  std::optional<double> speed_deg_h;
};

/// Collects the constants of one station.
class StationRows {
 public:
  /// `metres` is the length of the unit of the amplitude. Rows without an amplitude and unknown constituents add nothing.
  /// Errors   an amplitude below 0 or over 20 m, a phase beyond two turns, a speed of another constituent, one twice
  [[nodiscard]] Checked<bool> add(const ConstituentRow& row, double metres);

  [[nodiscard]] std::vector<tide::HarmonicConstant> constants() && { return std::move(constants_); }
  /// Tells of the unknown constituents.
  void warn(Messages& warnings) const;

 private:
  std::vector<tide::HarmonicConstant> constants_;
  std::vector<std::string> unknown_;
  double unknown_m_{};
};

/// Degrees an hour.
[[nodiscard]] double speed_deg_h(tide::Constituent constituent);
/// Whether a file's speed is that of the constituent, within what lists round to: 0.001 degrees an hour.
[[nodiscard]] bool is_speed_of(tide::Constituent constituent, double stated_deg_h);

/// Metres in one of a unit; empty where it is none of length.
[[nodiscard]] std::optional<double> metres_of(const std::string& unit);

/// Errors   no station, or one without constants
[[nodiscard]] Checked<PreparedDataset> prepared_stations(std::vector<repository::TideStation> stations,
                                                         Messages warnings);

}  // namespace floeplan::ingest
