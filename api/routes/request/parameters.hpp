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

/// A period, open where empty; an instant has both ends equal.
struct TimeSpan {
  std::optional<core::UtcTime> from;
  std::optional<core::UtcTime> to;
};

/// A box, and between which depths where six numbers say so, in their order.
struct BoxWithDepths {
  geo::BoundingBox area;
  std::optional<std::pair<double, double>> depths_m;
};

/// What a row of requests says of a query parameter.
template <messages::Code code, class... Given>
[[nodiscard]] core::Violation parameter_fault(const std::string& name, const Given&... values) {
  core::Violation violation = messages::fault<code>("?" + name, values...);
  violation.rule = "the query parameter \"" + name + "\" " + violation.rule;
  return violation;
}

/// Reads query parameters and collects what is wrong with them. Absent or wrong: empty, the latter noted.
class ParameterReader {
 public:
  explicit ParameterReader(const Request& request) : request_{request} {}

  [[nodiscard]] std::optional<double> number(const std::string& name, double from, double to);
  [[nodiscard]] std::optional<std::int64_t> integer(const std::string& name, std::int64_t from,
                                                    std::int64_t to);
  [[nodiscard]] std::optional<std::string> one_of(const std::string& name,
                                                  const std::vector<std::string>& values);
  [[nodiscard]] bool flag(const std::string& name);
  /// The page size: 100 unless told, at least 1; larger than 10000 counts as 10000.
  [[nodiscard]] int limit();
  /// Key of the last row of the page before; 0 for the first page.
  [[nodiscard]] std::int64_t after();
  /// Four numbers. Longitudes may run past 180. Six are refused: the data asked for have no depths.
  [[nodiscard]] std::optional<geo::BoundingBox> bbox(FeatureCrs crs = FeatureCrs::crs84);
  /// Four numbers, or six: minx,miny,minz,maxx,maxy,maxz.
  [[nodiscard]] std::optional<BoxWithDepths> bbox_with_depths();
  /// A reference system that is known; CRS84 unless told.
  [[nodiscard]] FeatureCrs crs(const std::string& name);
  /// Places as "lon,lat;lon,lat", at most 1000.
  [[nodiscard]] std::optional<std::vector<geo::LonLat>> places(const std::string& name);
  /// ISO 8601; a time without zone counts as UTC, as some clients of the standard write it.
  [[nodiscard]] std::optional<core::UtcTime> time(const std::string& name);
  /// An instant, or a period with ".." or nothing for an open end.
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
