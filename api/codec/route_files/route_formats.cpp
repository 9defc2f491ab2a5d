#include "api/codec/route_files/route_formats.hpp"

#include "engine/geo/written_place.hpp"

namespace floeplan::codec {

std::string at_line(int line) { return "line " + std::to_string(line); }

std::optional<geo::LonLat> place_of(std::optional<double> lon, std::optional<double> lat, int line,
                                    core::Violations& faults) {
  if (lon && lat)
    if (const auto place = geo::written_place(*lon, *lat)) return place;
  core::note(faults, messages::fault<"no-place-in-line">(at_line(line)));
  return std::nullopt;
}

}  // namespace floeplan::codec
