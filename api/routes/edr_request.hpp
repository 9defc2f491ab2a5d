#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/codec/wkt.hpp"
#include "api/routes/edr_field.hpp"
#include "api/routes/parameters.hpp"

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
  void refuse(const std::string& name, const std::string& rule);
  [[nodiscard]] core::Violations violations() const;

  /// The place, which must be there and of one of the kinds.
  [[nodiscard]] std::optional<codec::WktGeometry> coords(std::initializer_list<codec::WktKind> kinds,
                                                         const std::string& rule);
  [[nodiscard]] Wanted wanted();
  /// The depths to ask the data at; one without meaning where they have none.
  [[nodiscard]] std::vector<double> depths(const EdrShape& shape) const;

 private:
  [[nodiscard]] std::vector<std::size_t> parameters();

  const EdrCollection& collection_;  // borrowed
  const Request& request_;           // borrowed
  ParameterReader reader_;
  core::Violations violations_;
  std::optional<EdrLevels> levels_;
};

/// The moments to ask the data at: the one that was named, or the steps of the data in the period.
[[nodiscard]] std::vector<core::UtcTime> times_of(const EdrShape& shape, const TimeSpan& span);

}  // namespace floeplan::routes
