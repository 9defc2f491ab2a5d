#include "api/codec/route_files/route_formats.hpp"

#include "engine/core/violation_list.hpp"
#include "engine/geo/written_place.hpp"

namespace floeplan::codec {

std::string at_line(int line) { return "line " + std::to_string(line); }

tl::unexpected<core::Violations> route_fault(const std::string& where, const std::string& rule) {
  return tl::unexpected(core::Violations{{where, rule}});
}

std::optional<geo::LonLat> place_of(std::optional<double> lon, std::optional<double> lat, int line,
                                    core::Violations& faults) {
  if (lon && lat)
    if (const auto place = geo::written_place(*lon, *lat)) return place;
  core::note(faults, {at_line(line), "is no longitude and latitude in degrees, longitude -360 to 360"});
  return std::nullopt;
}

}  // namespace floeplan::codec
