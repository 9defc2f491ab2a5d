#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/codec/bytes/wkt.hpp"
#include "api/routes/edr/edr_field.hpp"
#include "api/routes/request/parameters.hpp"

namespace floeplan::routes {

/// What a query requests besides its place.
struct Wanted {
  TimeSpan span;
  std::vector<std::size_t> parameters;  // indices of the parameters
};

/// The parameter z: "R4/0/50" four levels from 0 on, 50 m apart; "0/200" all levels of the data in between;
/// "0,50,100" or "0" single levels.
struct EdrLevels {
  std::vector<double> values;
  std::optional<std::pair<double, double>> between;
};

/// Reads an OGC API - EDR query and collects its faults.
class EdrRequest {
 public:
  EdrRequest(const EdrCollection& collection, const Request& request)
      : collection_{collection}, request_{request}, reader_{request} {}

  [[nodiscard]] ParameterReader& reader() { return reader_; }
  template <messages::Code code, class... Given>
  void refuse(const std::string& name, const Given&... values) {
    violations_.push_back(parameter_fault<code>(name, values...));
  }
  [[nodiscard]] core::Violations violations() const;

  /// Reads the place, which is required and must be of one of the `kinds`; the Z of the place is a depth.
  [[nodiscard]] std::optional<codec::WktGeometry> coords(std::initializer_list<codec::WktKind> kinds,
                                                         const std::string& rule);
  /// Reads the box of a cube query; a box of six numbers also gives the depths.
  [[nodiscard]] std::optional<geo::BoundingBox> box();
  [[nodiscard]] Wanted wanted();
  /// Sets the depth that is part of the place (POINT Z); it replaces the parameter z.
  void take_depth(double depth_m) { levels_ = EdrLevels{.values = {depth_m}, .between = {}}; }
  /// Adds a violation if several depths are requested, because the answer has only one.
  void want_one_depth();
  /// Whether the query asks for the levels between two depths, both below the surface.
  [[nodiscard]] bool wants_levels_below() const {
    return levels_ && levels_->between && levels_->between->first > 0.0;
  }
  /// The depths at which to sample the data; empty if the data have none, or none of their levels is in the
  /// requested range.
  [[nodiscard]] std::vector<double> depths(const EdrShape& shape) const;

 private:
  [[nodiscard]] std::vector<std::size_t> parameters();
  void read_z();

  const EdrCollection& collection_;  // borrowed
  const Request& request_;           // borrowed
  ParameterReader reader_;
  core::Violations violations_;
  std::optional<EdrLevels> levels_;
};

/// The times at which to sample the data: the requested time, or the steps of the data in the period.
[[nodiscard]] std::vector<core::UtcTime> times_of(const EdrShape& shape, const TimeSpan& span);

}  // namespace floeplan::routes
