#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/routes/request/feature_crs.hpp"
#include "api/routes/request/message.hpp"
#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/fault.hpp"

namespace floeplan::routes {

/// A period; an empty end is open; an instant has two equal ends.
struct TimeSpan {
  std::optional<core::UtcTime> from;
  std::optional<core::UtcTime> to;
};

/// A box. Given by six numbers, it also has two depths, in the order in which they were given.
struct BoxWithDepths {
  geo::BoundingBox area;
  std::optional<std::pair<double, double>> depths_m;
};

/// A violation of a query parameter, with the message of this code.
template <messages::Code code, class... Given>
[[nodiscard]] core::Violation parameter_fault(const std::string& name, const Given&... values) {
  core::Violation violation = messages::fault<code>("?" + name, values...);
  violation.rule = "the query parameter \"" + name + "\" " + violation.rule;
  return violation;
}

/// Reads query parameters and collects their faults. A parameter that is absent or wrong is empty.
class ParameterReader {
 public:
  explicit ParameterReader(const Request& request) : request_{request} {}

  [[nodiscard]] std::optional<double> number(const std::string& name, double from, double to);
  [[nodiscard]] std::optional<std::int64_t> integer(const std::string& name, std::int64_t from,
                                                    std::int64_t to);
  [[nodiscard]] std::optional<std::string> one_of(const std::string& name,
                                                  const std::vector<std::string>& values);
  [[nodiscard]] bool flag(const std::string& name);
  /// The page size: default 100, at least 1; more than 10000 counts as 10000.
  [[nodiscard]] int limit();
  /// Key of the last row of the page before; 0 for the first page.
  [[nodiscard]] std::int64_t after();
  /// Reads four numbers; longitudes may exceed 180. Six numbers are refused, because the data have no depths.
  [[nodiscard]] std::optional<geo::BoundingBox> bbox(FeatureCrs crs = FeatureCrs::crs84);
  /// Four numbers, or six: minx,miny,minz,maxx,maxy,maxz.
  [[nodiscard]] std::optional<BoxWithDepths> bbox_with_depths();
  /// A known reference system; default CRS84.
  [[nodiscard]] FeatureCrs crs(const std::string& name);
  /// Positions as "lon,lat;lon,lat", at most 1000.
  [[nodiscard]] std::optional<std::vector<geo::LonLat>> places(const std::string& name);
  /// A time in ISO 8601. Without a zone it counts as UTC, because some clients of the standard omit it.
  [[nodiscard]] std::optional<core::UtcTime> time(const std::string& name);
  /// An instant, or a period; ".." or an empty text is an open end.
  [[nodiscard]] TimeSpan datetime();

  void require(const std::string& name, const std::string& rule);
  [[nodiscard]] const core::Violations& violations() const { return violations_; }

 private:
  template <messages::Code code, class... Given>
  void refuse(const std::string& name, const Given&... values) {
    violations_.push_back(parameter_fault<code>(name, values...));
  }
  [[nodiscard]] std::optional<BoxWithDepths> read_box(FeatureCrs crs, bool with_depths);

  const Request& request_;  // borrowed
  core::Violations violations_;
};

}  // namespace floeplan::routes
