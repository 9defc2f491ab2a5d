#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "api/codec/route_files/route_file.hpp"

namespace {

using namespace floeplan;

void expect(bool held) {
  if (!held) std::abort();
}

/// An accepted route is on the globe and within the limit of places; a refused one has a reason.
void check(const char* name, std::string_view bytes) {
  constexpr std::size_t most_places = 10'000;
  const auto read = codec::read_route_file(name, bytes);
  if (!read) {
    expect(!read.error().empty());
    return;
  }
  expect(!read->places.empty() && read->places.size() <= most_places);
  for (const geo::LonLat& place : read->places) {
    expect(place.lon_deg >= -180.0 && place.lon_deg < 180.0 && std::abs(place.lat_deg) <= 90.0);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  check("route", bytes);
  check("goto_l10.ma", bytes);
  return 0;
}
