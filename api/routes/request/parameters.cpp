#include "api/routes/request/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "api/codec/bytes/text_values.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::routes {
namespace {

constexpr std::size_t most_places = 1000;

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  constexpr std::size_t most = 6;
  std::vector<double> numbers;
  for (const auto part : codec::split(text, ',')) {
    const auto number = codec::parse_number(part);
    if (!number || numbers.size() == most) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<core::UtcTime> parse_time(const std::string& text) {
  if (const auto time = core::parse_iso8601(text)) return time;
  return core::parse_iso8601(text + "Z");
}

/// The box with longitudes in the usual range; the map of a client may have been moved around the globe.
geo::BoundingBox normalised(double west, double south, double east, double north) {
  if (east - west >= 360.0) return {-180.0, south, 180.0, north};
  const double wrapped_west = geo::wrap_longitude(west);
  const double wrapped_east = east == 180.0 ? 180.0 : geo::wrap_longitude(east);
  return {wrapped_west, south, wrapped_east, north};
}

}  // namespace

void ParameterReader::require(const std::string& name, const std::string& what) {
  if (!request_.parameter(name)) refuse<"required">(name, what);
}

std::optional<double> ParameterReader::number(const std::string& name, double from, double to) {
  const auto text = request_.parameter(name);
  if (!text) return std::nullopt;
  const auto value = codec::parse_number(*text);
  if (value && *value >= from && *value <= to) return value;
  refuse<"wrong-shape">(name, "a number from " + std::to_string(from) + " to " + std::to_string(to));
  return std::nullopt;
}

std::optional<std::int64_t> ParameterReader::integer(const std::string& name, std::int64_t from,
                                                     std::int64_t to) {
  const auto text = request_.parameter(name);
  if (!text) return std::nullopt;
  const auto value = codec::parse_integer(*text);
  if (value && *value >= from && *value <= to) return value;
  refuse<"wrong-shape">(name, "a whole number from " + std::to_string(from) + " to " + std::to_string(to));
  return std::nullopt;
}

std::optional<std::string> ParameterReader::one_of(const std::string& name,
                                                   const std::vector<std::string>& values) {
  auto text = request_.parameter(name);
  if (!text || std::find(values.begin(), values.end(), *text) != values.end()) return text;
  std::string choices = "one of";
  for (const auto& value : values) choices += " " + value;
  refuse<"wrong-shape">(name, choices);
  return std::nullopt;
}

bool ParameterReader::flag(const std::string& name) {
  const auto text = request_.parameter(name);
  if (!text || *text == "false") return false;
  if (*text != "true") refuse<"wrong-shape">(name, "true or false");
  return *text == "true";
}

int ParameterReader::limit() {
  constexpr std::int64_t most = 10'000;
  const auto value = integer("limit", 1, INT64_MAX);
  return static_cast<int>(std::min(value.value_or(100), most));
}

std::int64_t ParameterReader::after() { return integer("after", 0, INT64_MAX).value_or(0); }

FeatureCrs ParameterReader::crs(const std::string& name) {
  const auto uri = request_.parameter(name);
  if (!uri) return FeatureCrs::crs84;
  const auto known = parse_crs(*uri);
  std::string choices = "one of";
  for (const auto& candidate : crs_uris()) choices += " " + candidate;
  if (!known) refuse<"wrong-shape">(name, choices);
  return known.value_or(FeatureCrs::crs84);
}

std::optional<geo::BoundingBox> ParameterReader::bbox(FeatureCrs crs) {
  const auto box = read_box(crs, false);
  return box ? std::optional{box->area} : std::nullopt;
}

std::optional<BoxWithDepths> ParameterReader::bbox_with_depths() { return read_box(FeatureCrs::crs84, true); }

std::optional<BoxWithDepths> ParameterReader::read_box(FeatureCrs crs, bool with_depths) {
  const auto text = request_.parameter("bbox");
  if (!text) return std::nullopt;
  const auto numbers = parse_numbers(*text);
  if (!with_depths && numbers && numbers->size() == 6) {
    refuse<"wrong-shape">("bbox",
                          "four numbers here, west,south,east,north: heights and depths are not searched");
    return std::nullopt;
  }
  if (!numbers || (numbers->size() != 4 && numbers->size() != 6)) {
    refuse<"wrong-shape">("bbox", with_depths ? "four numbers, west,south,east,north, or six, "
                                                "west,south,from,east,north,to with the depths from and to"
                                              : "four numbers: west,south,east,north");
    return std::nullopt;
  }
  const std::size_t half = numbers->size() / 2;
  const auto [west, south] = to_lon_lat({(*numbers)[0], (*numbers)[1]}, crs);
  const auto [east, north] = to_lon_lat({(*numbers)[half], (*numbers)[half + 1]}, crs);
  if (south > north || south < -90.0 || north > 90.0 || std::abs(west) > 540.0 || std::abs(east) > 540.0) {
    refuse<"box-not-on-the-globe">("bbox");
    return std::nullopt;
  }
  BoxWithDepths box{normalised(west, south, east, north), {}};
  if (half == 3) box.depths_m = {(*numbers)[2], (*numbers)[5]};
  return box;
}

std::optional<std::vector<geo::LonLat>> ParameterReader::places(const std::string& name) {
  const auto text = request_.parameter(name);
  if (!text) return std::nullopt;
  std::vector<geo::LonLat> places;
  std::string_view rest = *text;
  while (places.size() <= most_places) {
    const auto end = rest.find(';');
    const auto numbers = parse_numbers(rest.substr(0, end));
    if (!numbers || numbers->size() != 2 || !geo::is_valid({(*numbers)[0], (*numbers)[1]})) break;
    places.push_back({(*numbers)[0], (*numbers)[1]});
    if (end == std::string_view::npos) return places;
    rest.remove_prefix(end + 1);
  }
  refuse<"wrong-shape">(name, "places as lon,lat;lon,lat in degrees, at most 1000");
  return std::nullopt;
}

std::optional<core::UtcTime> ParameterReader::time(const std::string& name) {
  const auto text = request_.parameter(name);
  if (!text) return std::nullopt;
  const auto value = parse_time(*text);
  if (!value) refuse<"wrong-shape">(name, "a time in ISO 8601, as 2026-11-20T06:00:00Z");
  return value;
}

TimeSpan ParameterReader::datetime() {
  const auto text = request_.parameter("datetime");
  if (!text) return {};
  constexpr std::string_view shape =
      "a time in ISO 8601 or a period as 2026-11-20T00:00:00Z/.., the earlier end first";
  const auto slash = text->find('/');
  if (slash == std::string::npos) {
    const auto instant = parse_time(*text);
    if (!instant) refuse<"wrong-shape">("datetime", shape);
    return {instant, instant};
  }
  const auto open = [](const std::string& end) { return end.empty() || end == ".."; };
  const std::string first = text->substr(0, slash);
  const std::string second = text->substr(slash + 1);
  TimeSpan span;
  if (!open(first)) span.from = parse_time(first);
  if (!open(second)) span.to = parse_time(second);
  const bool wrong = (!open(first) && !span.from) || (!open(second) && !span.to) ||
                     (span.from && span.to && *span.to < *span.from);
  if (!wrong) return span;
  refuse<"wrong-shape">("datetime", shape);
  return {};
}

}  // namespace floeplan::routes
