#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "storage/json/json.hpp"

namespace floeplan::cli {

/// The flags of `plan`, `evaluate`, `check` and `reach` that are members of a process's `inputs`, under the same names
/// with underscores. Flags win over the members of a request file.
class InputFlags {
 public:
  /// Departure, vehicle, margin and data: what all of them take.
  void add_voyage(CLI::App& command);
  /// Objective, waits, battery and ice: what a route has to obey.
  void add_route_rules(CLI::App& command);
  /// The file of which flags are members; `inputs` says whose inputs it holds.
  void add_request(CLI::App& command, const std::string& inputs);
  /// Where a route from a file starts.
  void add_start(CLI::App& command);
  void add_route_name(CLI::App& command);
  /// Places, grid, search and refinement: what only `plan` takes.
  void add_planning(CLI::App& command);

  /// Place, times, grid and ice: what `reach` takes besides.
  void add_reach(CLI::App& command);

  /// The inputs. Throws CLI::ValidationError (wrong usage) for a flag whose text cannot be read; for a request file
  /// throws what `read_object` does.
  [[nodiscard]] nlohmann::json inputs() const;

 private:
  /// What the ice lets pass, and for how long.
  void add_passing_under_ice(CLI::App& command);
  void set_under_ice(nlohmann::json& inputs) const;

  std::optional<std::string> request_file_;
  std::optional<std::string> from_;
  std::optional<std::string> to_;
  std::optional<std::string> goals_file_;
  std::optional<std::string> route_name_;
  std::vector<std::string> via_;
  std::optional<std::string> depart_;
  std::optional<std::string> depart_until_;
  std::optional<std::string> depart_step_;
  std::optional<std::string> arrive_by_;
  std::optional<std::string> hours_;
  std::optional<std::string> vehicle_;
  std::optional<double> speed_m_s_;
  std::optional<double> pitch_deg_;
  std::optional<double> climb_to_m_;
  std::optional<double> dive_depth_m_;
  std::optional<double> altimeter_margin_m_;
  std::optional<double> battery_j_;
  std::optional<double> battery_start_share_;
  bool best_order_{false};
  std::optional<int> members_;
  std::optional<double> current_error_m_s_;
  std::optional<double> error_length_m_;
  std::optional<double> error_time_s_;
  std::optional<std::string> robust_;
  std::optional<std::string> arrive_before_;
  std::optional<std::string> spacing_m_;
  std::optional<int> sectors_;
  std::optional<std::string> method_;
  std::optional<std::string> objective_;
  std::optional<int> max_waypoints_;
  std::optional<double> max_leg_m_;
  std::optional<double> refine_seconds_;
  std::optional<std::string> thruster_;
  bool require_battery_{false};
  bool no_refine_{false};
  bool no_optimality_gap_{false};
  std::optional<std::string> currents_;
  std::optional<std::string> tides_;
  std::optional<std::string> tides_mode_;
  bool steady_{false};
  std::optional<std::string> bathymetry_;
  std::optional<std::string> ice_;
  std::optional<std::string> icebergs_;
  std::optional<std::string> icebergs_as_of_;
  std::optional<double> max_concentration_to_surface_;
  std::optional<double> margin_below_ice_m_;
  std::optional<double> max_time_without_surfacing_s_;
  std::optional<double> surfacing_interval_s_;
  bool escape_plan_{false};
  std::optional<std::string> coastline_;
  std::optional<std::string> wind_;
  std::optional<std::string> zones_;
  std::optional<double> margin_m_;
  std::optional<std::string> areas_file_;
  bool no_iceberg_drift_{false};
  std::optional<double> max_inflation_m_;
  std::optional<double> max_sighting_age_days_;
  std::optional<double> max_loiter_s_;
  std::optional<double> encounter_weight_s_;
  bool pass_under_{false};
  std::optional<double> keel_clearance_m_;
  std::optional<double> draft_uncertainty_;
  std::optional<std::string> name_;
};

/// The JSON object that a file holds; `what` names the file in a message. Throws std::runtime_error when it cannot be
/// read, and BadDataError where the server would not take its text and when it is longer than 16 MB.
[[nodiscard]] nlohmann::json read_object(const std::string& file, const std::string& what);

/// A file as the inputs take it: {"name": ..., "text": ...}. Throws std::runtime_error when it cannot be read.
[[nodiscard]] nlohmann::json file_member(const std::string& file);

}  // namespace floeplan::cli
