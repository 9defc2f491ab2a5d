#include "api/routes/edr/edr_request.hpp"

#include <algorithm>

#include "api/codec/bytes/text_values.hpp"
#include "api/routes/request/feature_crs.hpp"

namespace floeplan::routes {
namespace {

constexpr std::size_t most_levels = 1000;

/// The range as levels. A range with equal ends is this depth, not only levels that are exactly there.
EdrLevels levels_between(double a, double b) {
  if (a == b) return {.values = {a}, .between = {}};
  return {.values = {}, .between = std::minmax(a, b)};
}

std::optional<EdrLevels> parse_z(const std::string& text) {
  const auto parts = codec::split(text, '/');
  std::vector<std::optional<double>> numbers;
  for (const auto& part : parts.size() > 1 ? parts : codec::split(text, ','))
    numbers.push_back(codec::parse_number(part));
  EdrLevels levels;
  if (parts.size() == 3 && parts[0].starts_with('R')) {
    const auto count = codec::parse_number(parts[0].substr(1));
    if (!count || *count < 1.0 || *count > most_levels || !numbers[1] || !numbers[2]) return std::nullopt;
    for (int i = 0; i < static_cast<int>(*count); ++i) levels.values.push_back(*numbers[1] + i * *numbers[2]);
    return levels;
  }
  if (std::any_of(numbers.begin(), numbers.end(), [](const auto& number) { return !number; }))
    return std::nullopt;
  if (parts.size() == 2) {
    levels = levels_between(*numbers[0], *numbers[1]);
  } else if (parts.size() == 1 && numbers.size() <= most_levels) {
    for (const auto& number : numbers) levels.values.push_back(*number);
  } else {
    return std::nullopt;
  }
  return levels;
}

bool above_the_surface(const EdrLevels& levels) {
  return (levels.between && levels.between->first < 0.0) ||
         std::ranges::any_of(levels.values, [](double depth_m) { return depth_m < 0.0; });
}

}  // namespace

core::Violations EdrRequest::violations() const {
  core::Violations all = reader_.violations();
  all.insert(all.end(), violations_.begin(), violations_.end());
  return all;
}

std::optional<codec::WktGeometry> EdrRequest::coords(std::initializer_list<codec::WktKind> kinds,
                                                     const std::string& rule) {
  const auto text = request_.parameter("coords");
  auto geometry = text ? codec::parse_wkt(*text) : std::nullopt;
  if (!geometry || std::find(kinds.begin(), kinds.end(), geometry->kind) == kinds.end()) {
    refuse<"required">("coords", rule + ", longitude first");
    return std::nullopt;
  }
  if (std::ranges::any_of(geometry->places, [](const auto& place) { return place.z_m && *place.z_m < 0.0; }))
    refuse<"negative-depth">("coords");
  return geometry;
}

std::optional<geo::BoundingBox> EdrRequest::box() {
  reader_.require("bbox", "west,south,east,north in degrees");
  const auto box = reader_.bbox_with_depths();
  if (!box) return std::nullopt;
  if (!box->depths_m) return box->area;
  const auto [from, to] = *box->depths_m;
  if (!collection_.has_depths) {
    refuse<"wrong-shape">("bbox", "four numbers, west,south,east,north: this collection has no depths");
  } else if (request_.parameter("z")) {
    refuse<"depths-given-twice">("bbox");
  } else if (from < 0.0 || from > to) {
    refuse<"wrong-box-with-depths">("bbox");
  }
  levels_ = levels_between(from, to);
  return box->area;
}

Wanted EdrRequest::wanted() {
  Wanted result;
  result.span = reader_.datetime();
  result.parameters = parameters();
  if (const auto crs = request_.parameter("crs"); crs && parse_crs(*crs) != FeatureCrs::crs84) {
    refuse<"wrong-shape">(
        "crs",
        "CRS84 or its URI, longitude first; EPSG:4326 means latitude first, which this collection is "
        "not given in");
  }
  read_z();
  return result;
}

void EdrRequest::read_z() {
  const auto z = request_.parameter("z");
  if (!z) return;
  levels_ = parse_z(*z);
  if (!levels_ || above_the_surface(*levels_)) {
    refuse<"wrong-shape">("z",
                          "metres below the surface, positive down: one, several, from/to or Rn/first/step");
  }
}

void EdrRequest::want_one_depth() {
  if (levels_ && (levels_->between || levels_->values.size() > 1))
    refuse<"wrong-shape">("z", "one depth here; a LINESTRING Z gives each place its own");
}

std::vector<double> EdrRequest::depths(const EdrShape& shape) const {
  if (shape.depths_m.empty() || !levels_) return shape.depths_m;
  if (!levels_->between) return levels_->values;
  std::vector<double> inside;
  for (const double depth : shape.depths_m) {
    if (depth >= levels_->between->first && depth <= levels_->between->second) inside.push_back(depth);
  }
  return inside;
}

std::vector<std::size_t> EdrRequest::parameters() {
  std::vector<std::size_t> chosen;
  const auto text = request_.parameter("parameter-name") ? request_.parameter("parameter-name")
                                                         : request_.parameter("parameter_names");
  for (std::size_t i = 0; i < collection_.parameters.size(); ++i)
    if (!text) chosen.push_back(i);
  if (!text) return chosen;
  for (const auto& name : codec::split(*text, ',')) {
    const auto found = std::ranges::find(collection_.parameters, name, &codec::CoverageParameter::id);
    if (found == collection_.parameters.end()) {
      refuse<"unknown-parameter">("parameter-name", name);
      continue;
    }
    const auto index = static_cast<std::size_t>(found - collection_.parameters.begin());
    if (std::ranges::find(chosen, index) == chosen.end()) chosen.push_back(index);
  }
  return chosen;
}

std::vector<core::UtcTime> times_of(const EdrShape& shape, const TimeSpan& span) {
  if (shape.times.empty()) return {};
  if (span.from && span.to && *span.from == *span.to) return {*span.from};
  std::vector<core::UtcTime> times;
  for (const auto time : shape.times) {
    if ((!span.from || time >= *span.from) && (!span.to || time <= *span.to)) times.push_back(time);
  }
  return times;
}

}  // namespace floeplan::routes
