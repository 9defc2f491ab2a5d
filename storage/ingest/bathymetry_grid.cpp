#include "storage/ingest/bathymetry_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "storage/ingest/text.hpp"
#include "storage/repository/field_repository.hpp"

namespace floeplan::ingest {
namespace {

constexpr float deepest_m = 12000.0F;
constexpr float highest_m = 9000.0F;
constexpr float missing = std::numeric_limits<float>::quiet_NaN();

/// Numbers that producers write for "missing". 9999 also is a depth: it counts only if nothing else is as
/// large.
bool is_marker(float value, bool nothing_else_is_large) {
  constexpr std::array markers{32767.0F, 32768.0F, 99999.0F, 999999.0F};
  const float size = std::abs(value);
  if (size == 9999.0F) return nothing_else_is_large;
  return size >= 1e6F || std::find(markers.begin(), markers.end(), size) != markers.end();
}

std::int64_t leave_out_markers(std::vector<float>& values) {
  const bool nothing_else_is_large = std::none_of(values.begin(), values.end(), [](float v) {
    return std::abs(v) > 9000.0F && std::abs(v) != 9999.0F && !is_marker(v, false);
  });
  std::int64_t count = 0;
  for (float& value : values) {
    if (!is_marker(value, nothing_else_is_large)) continue;
    value = missing;
    ++count;
  }
  return count;
}

VerticalEvidence evidence_of(const RawBathymetry& raw) {
  VerticalEvidence evidence{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                            false};
  for (const float value : raw.values_m) {
    if (std::isnan(value)) continue;
    evidence.lowest_m = std::min(evidence.lowest_m, static_cast<double>(value));
    evidence.highest_m = std::max(evidence.highest_m, static_cast<double>(value));
  }
  const ocean::Axis& x = raw.grid.x();
  const ocean::Axis& y = raw.grid.y();
  evidence.covers_the_globe = std::holds_alternative<geo::GeographicFrame>(raw.grid.frame()) &&
                              x.back() - x.front() + x.mean_step() > 359.0 &&
                              y.back() - y.front() + y.mean_step() > 170.0;
  return evidence;
}

std::optional<std::string> fault_of_depths(const RawBathymetry& raw, const std::vector<float>& depths_m) {
  const auto fault = std::find_if(depths_m.begin(), depths_m.end(),
                                  [](float depth) { return depth > deepest_m || depth < -highest_m; });
  if (fault == depths_m.end()) return std::nullopt;
  const auto node = static_cast<std::size_t>(fault - depths_m.begin());
  const geo::LonLat at = raw.grid.place(node % raw.grid.x().size(), node / raw.grid.x().size());
  const std::string what = *fault > 0.0F ? "a depth of " + number(static_cast<double>(*fault)) + " m"
                                         : "land " + number(static_cast<double>(-*fault)) + " m high";
  return "\"" + raw.description.name + "\" has " + what + " at longitude " + number(at.lon_deg) +
         ", latitude " + number(at.lat_deg) +
         "; there is none on Earth; the unit is wrong, or a marker for missing values is not " +
         "declared; ask the producer";
}

/// The least depth of each cell, positive down; empty when every cell is as deep as its node.
std::vector<float> shoalest_of(const RawBathymetry& raw, VerticalSense sense,
                               const std::vector<float>& depths_m) {
  const std::vector<float>& bounds = sense == VerticalSense::up ? raw.highest_m : raw.lowest_m;
  if (bounds.empty()) return {};
  std::vector<float> shoalest = depths_m;
  for (std::size_t i = 0; i < shoalest.size(); ++i) {
    const float bound = sense == VerticalSense::up ? 0.0F - bounds[i] : bounds[i];
    if (bound < shoalest[i]) shoalest[i] = bound;  // of a missing one nothing is known: it compares as false
  }
  return shoalest == depths_m ? std::vector<float>{} : shoalest;
}

}  // namespace

Checked<PreparedDataset> prepare_bathymetry(RawBathymetry raw, const std::optional<std::string>& positive) {
  PreparedDataset data;
  data.kind = repository::DatasetKind::bathymetry;
  data.variables = {raw.description.name};
  data.warnings = raw.warnings;
  if (const std::int64_t markers = leave_out_markers(raw.values_m); markers > 0)
    data.warnings.push_back(
        std::to_string(markers) +
        " values are markers for \"missing\" that the file does not declare; they were left out");

  const VerticalEvidence evidence = evidence_of(raw);
  if (evidence.lowest_m > evidence.highest_m)
    return refuse("every value of \"" + raw.description.name +
                  "\" is missing; there is nothing to store; check the area of your download");
  const auto finding = vertical_sense_of(positive, raw.description, evidence);
  if (!finding) return refuse(finding.error());
  if (finding->warning) data.warnings.push_back(*finding->warning);

  auto depths_m = std::make_shared<std::vector<float>>(std::move(raw.values_m));
  if (finding->sense == VerticalSense::up)
    for (float& value : *depths_m) value = 0.0F - value;
  if (const auto fault = fault_of_depths(raw, *depths_m)) return refuse(*fault);

  auto shoalest_m = std::make_shared<const std::vector<float>>(shoalest_of(raw, finding->sense, *depths_m));

  data.bounds = raw.grid.bounds();
  data.rows_accepted = static_cast<std::int64_t>(raw.grid.size());
  data.write = [grid = std::move(raw.grid), depths_m, shoalest_m](
                   sqlite::Connection& db,
                   const repository::DatasetId& id) -> tl::expected<void, std::string> {
    repository::FieldRepository fields{db};
    fields.create(id, {grid, std::nullopt, std::nullopt});
    fields.write_slice(id, "depth_m", 0, 0, *depths_m);
    if (!shoalest_m->empty()) fields.write_slice(id, "shoalest_m", 0, 0, *shoalest_m);
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
