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

/// What every query asks besides its place.
struct Wanted {
  TimeSpan span;
  std::vector<std::size_t> parameters;  // indices
};

/// The parameter z: "R4/0/50": four levels from 0 on, 50 apart; "0/200": the levels of the data in between; "0,50,100";
/// "0".
struct EdrLevels {
  std::vector<double> values;
  std::optional<std::pair<double, double>> between;
};

/// A query of OGC API - EDR with what is wrong with it.
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

  /// The place, which must be there and of one of the kinds; a Z of it is a depth.
  [[nodiscard]] std::optional<codec::WktGeometry> coords(std::initializer_list<codec::WktKind> kinds,
                                                         const std::string& rule);
  /// The box of a cube; one of six numbers states the depths, too.
  [[nodiscard]] std::optional<geo::BoundingBox> box();
  [[nodiscard]] Wanted wanted();
  /// Takes the depth that is part of the place (POINT Z); it counts instead of the parameter z.
  void take_depth(double depth_m) { levels_ = EdrLevels{.values = {depth_m}, .between = {}}; }
  /// Refuses several depths, of which the answer would hold one.
  void want_one_depth();
  /// Whether the query asks for the levels between two depths, both below the surface.
  [[nodiscard]] bool wants_levels_below() const {
    return levels_ && levels_->between && levels_->between->first > 0.0;
  }
  /// The depths to ask the data at; empty where they have none, and where no level of theirs lies between those asked
  /// for.
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

/// The moments to ask the data at: the one that was named, or the steps of the data in the period.
[[nodiscard]] std::vector<core::UtcTime> times_of(const EdrShape& shape, const TimeSpan& span);

}  // namespace floeplan::routes
