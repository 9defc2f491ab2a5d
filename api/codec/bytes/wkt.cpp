#include "api/codec/bytes/wkt.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

namespace floeplan::codec {
namespace {

constexpr std::size_t most_places = 10'000;
constexpr double longest_ever_s = 1e11;  // year 5138

/// Reads the text step by step. After the first step that fails, all further steps fail.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_{text} {}

  [[nodiscard]] bool fits() const { return fits_; }
  bool at_end() {
    skip_blanks();
    return rest_.empty();
  }
  /// The next word in upper case; empty if there is none.
  std::string word() {
    skip_blanks();
    std::string text;
    while (!rest_.empty() && std::isalpha(static_cast<unsigned char>(rest_.front())) != 0) {
      text += static_cast<char>(std::toupper(static_cast<unsigned char>(rest_.front())));
      rest_.remove_prefix(1);
    }
    return text;
  }
  bool take(char wanted) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != wanted) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void require(char wanted) { fits_ = take(wanted) && fits_; }
  double number() {
    skip_blanks();
    if (rest_.starts_with('+')) rest_.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) {
      fits_ = false;
      return 0.0;
    }
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  void refuse() { fits_ = false; }

 private:
  void skip_blanks() {
    while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0)
      rest_.remove_prefix(1);
  }

  std::string_view rest_;
  bool fits_{true};
};

struct Dimensions {
  bool z{false};
  bool m{false};
};

/// Reads a position; its longitude is not normalised.
WktPlace read_place(Scanner& scanner, Dimensions dimensions) {
  WktPlace result;
  result.place.lon_deg = scanner.number();
  result.place.lat_deg = scanner.number();
  if (dimensions.z) result.z_m = scanner.number();
  if (dimensions.m) {
    const double seconds = scanner.number();
    if (std::abs(seconds) > longest_ever_s) scanner.refuse();
    result.time = core::from_unix_seconds(seconds);
  }
  const bool somewhere = std::abs(result.place.lon_deg) <= 360.0 && std::abs(result.place.lat_deg) <= 90.0;
  if (!somewhere) scanner.refuse();
  return somewhere ? result : WktPlace{};
}

/// Reads "(place, place, ...)"; each place may have its own brackets, as in MULTIPOINT((1 2), (3 4)).
std::vector<WktPlace> read_written_places(Scanner& scanner, Dimensions dimensions) {
  std::vector<WktPlace> places;
  scanner.require('(');
  do {
    const bool bracket = scanner.take('(');
    places.push_back(read_place(scanner, dimensions));
    if (bracket) scanner.require(')');
    if (places.size() > most_places) scanner.refuse();
  } while (scanner.fits() && scanner.take(','));
  scanner.require(')');
  return places;
}

/// Reads the places as `read_written_places`, and brings their longitudes into [-180, 180).
std::vector<WktPlace> read_places(Scanner& scanner, Dimensions dimensions) {
  auto places = read_written_places(scanner, dimensions);
  for (WktPlace& place : places) place.place.lon_deg = geo::wrap_longitude(place.place.lon_deg);
  return places;
}

/// Reads a ring. Edges take the shorter way, but an edge of 360 degrees (from -180 to 180) goes around the
/// globe. It is divided in three, because its two ends are the same position.
geo::Ring read_ring(Scanner& scanner, Dimensions dimensions) {
  geo::Ring ring;
  std::optional<geo::LonLat> before;
  for (const WktPlace& corner : read_written_places(scanner, dimensions)) {
    const geo::LonLat place = corner.place;
    if (before && std::abs(place.lon_deg - before->lon_deg) == 360.0) {
      for (const double share : {1.0 / 3.0, 2.0 / 3.0}) {
        ring.push_back({geo::wrap_longitude(before->lon_deg + share * (place.lon_deg - before->lon_deg)),
                        before->lat_deg + share * (place.lat_deg - before->lat_deg)});
      }
    }
    ring.push_back({geo::wrap_longitude(place.lon_deg), place.lat_deg});
    before = place;
  }
  const bool closed = ring.size() >= 4 && ring.front() == ring.back();
  if (!closed) {
    scanner.refuse();
    return {};
  }
  ring.pop_back();
  return ring;
}

geo::Polygon read_polygon(Scanner& scanner, Dimensions dimensions) {
  geo::Polygon polygon;
  scanner.require('(');
  polygon.outer = read_ring(scanner, dimensions);
  while (scanner.fits() && scanner.take(',')) polygon.holes.push_back(read_ring(scanner, dimensions));
  scanner.require(')');
  return polygon;
}

std::vector<geo::Polygon> read_polygons(Scanner& scanner, Dimensions dimensions, bool several) {
  if (!several) return {read_polygon(scanner, dimensions)};
  std::vector<geo::Polygon> polygons;
  scanner.require('(');
  do {
    polygons.push_back(read_polygon(scanner, dimensions));
  } while (scanner.fits() && scanner.take(','));
  scanner.require(')');
  return polygons;
}

/// Removes "Z", "M" or "ZM" from the end of the type's name, or reads it as a separate word.
Dimensions read_dimensions(std::string& type, Scanner& scanner) {
  std::string letters = scanner.word();
  if (letters.empty()) {
    for (const std::string_view ending : {"ZM", "Z", "M"}) {
      if (!type.ends_with(ending)) continue;
      letters = ending;
      type.erase(type.size() - ending.size());
      break;
    }
  }
  if (!letters.empty() && letters != "Z" && letters != "M" && letters != "ZM") scanner.refuse();
  return {letters.starts_with('Z'), letters.ends_with('M')};
}

}  // namespace

std::optional<WktGeometry> parse_wkt(std::string_view text) {
  Scanner scanner{text};
  std::string type = scanner.word();
  const Dimensions dimensions = read_dimensions(type, scanner);
  WktGeometry geometry;
  geometry.has_z = dimensions.z;
  if (type == "POINT" || type == "MULTIPOINT") {
    geometry.kind = type == "POINT" ? WktKind::point : WktKind::multi_point;
    geometry.places = read_places(scanner, dimensions);
    if (type == "POINT" && geometry.places.size() != 1) scanner.refuse();
  } else if (type == "LINESTRING") {
    geometry.kind = WktKind::line;
    geometry.places = read_places(scanner, dimensions);
    if (geometry.places.size() < 2) scanner.refuse();
  } else if (type == "POLYGON" || type == "MULTIPOLYGON") {
    geometry.kind = WktKind::polygon;
    geometry.areas = read_polygons(scanner, dimensions, type == "MULTIPOLYGON");
  } else {
    return std::nullopt;
  }
  return scanner.fits() && scanner.at_end() ? std::optional{std::move(geometry)} : std::nullopt;
}

}  // namespace floeplan::codec
