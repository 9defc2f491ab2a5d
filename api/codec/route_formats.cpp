#include "api/codec/route_formats.hpp"

#include "engine/core/violation_list.hpp"

namespace floeplan::codec {

std::string at_line(int line) { return "line " + std::to_string(line); }

tl::unexpected<core::Violations> route_fault(const std::string& where, const std::string& rule) {
  return tl::unexpected(core::Violations{{where, rule}});
}

std::optional<geo::LonLat> place_of(std::optional<double> lon, std::optional<double> lat, int line,
                                    core::Violations& faults) {
  if (lon && lat && geo::is_valid({*lon, *lat})) return geo::LonLat{*lon, *lat};
  core::note(faults, {at_line(line), "is no longitude and latitude in degrees, longitude -180 to 360"});
  return std::nullopt;
}

}  // namespace floeplan::codec
