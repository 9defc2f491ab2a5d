#include "engine/ocean/iceberg_drift.hpp"

#include <algorithm>
#include <cmath>

#include "api/codec/bytes/text_values.hpp"
#include "api/codec/documents/dataset_document.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// Limits chosen for a picture and a quick answer: the currents of the whole box have to be read.
constexpr double widest_deg = 10.0;
constexpr double highest_deg = 5.0;
constexpr core::Seconds longest{10.0 * 86400.0};
constexpr std::size_t most_bergs = 500;

double rounded(double value, double per_unit) { return std::round(value * per_unit) / per_unit; }

/// The drift of a berg as columns, in steps of at most an hour: expected position and its error.
json drift_of(const ocean::Iceberg& iceberg, const ocean::Environment& sea, core::UtcTime until) {
  json berg{{"berg_id", iceberg.id},
            {"observed", core::iso8601(iceberg.observed)},
            {"safe_length_m", ocean::safe_length(iceberg).value}};
  for (const char* column : {"time", "lon", "lat", "error_m"}) berg[column] = json::array();
  for (const ocean::IcebergFix& fix : ocean::forecast_drift(iceberg, sea, until)) {
    berg["time"].push_back(core::iso8601(fix.time));
    berg["lon"].push_back(rounded(fix.place.lon_deg, 1e5));
    berg["lat"].push_back(rounded(fix.place.lat_deg, 1e5));
    berg["error_m"].push_back(rounded(ocean::expected_error(iceberg, fix.time).value, 1.0));
  }
  return berg;
}

json drift_document(const ocean::Environment& sea, core::UtcTime until) {
  json bergs = json::array();
  const std::size_t shown = std::min(sea.icebergs.size(), most_bergs);
  for (std::size_t i = 0; i < shown; ++i) bergs.push_back(drift_of(sea.icebergs[i], sea, until));
  return {{"bergs", std::move(bergs)},
          {"numberMatched", sea.icebergs.size()},
          {"datasets", codec::dataset_refs_json(sea.datasets)}};
}

/// A choice of datasets from ids separated by commas; without the parameter the planner's default.
repository::DatasetChoice named(const Request& request, const std::string& parameter) {
  const auto ids = request.parameter(parameter);
  if (!ids) return {};
  repository::DatasetChoice choice{repository::DatasetChoice::How::named, {}};
  for (const std::string_view id : codec::split(*ids, ',')) choice.ids.push_back({std::string{id}});
  return choice;
}

core::Violations faults_of(const geo::BoundingBox& area, core::UtcTime as_of, core::UtcTime until) {
  core::Violations faults;
  if (area.east_deg - area.west_deg > widest_deg || area.north_deg - area.south_deg > highest_deg)
    faults.push_back({"?bbox", "must be at most 10 degrees wide and 5 degrees high"});
  if (until < as_of || until - as_of > longest)
    faults.push_back({"?until", "must be at most ten days after as_of"});
  return faults;
}

Response show_drift(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  reader.require("bbox", "west,south,east,north in degrees");
  reader.require("as_of", "the moment after which no sighting counts");
  reader.require("until", "the moment up to which the drift is asked");
  const auto area = reader.bbox();
  const auto as_of = reader.time("as_of");
  const auto until = reader.time("until");
  const auto max_age_days = reader.number("max_sighting_age_days", 0.0,
                                          ocean::largest_sighting_age.count() / 86'400.0);
  const auto departure = reader.time("departure");
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  if (const auto faults = faults_of(*area, *as_of, *until); !faults.empty()) return invalid(request, faults);

  repository::EnvironmentQuery query;
  query.area = *area;
  query.depart = std::min(*as_of, departure.value_or(*as_of));
  query.may_begin_later = true;
  query.icebergs_as_of = *as_of;
  query.icebergs = named(request, "dataset");
  if (max_age_days) query.max_sighting_age = core::Seconds{*max_age_days * 86'400.0};
  query.currents = named(request, "currents");
  for (auto* unused : {&query.bathymetry, &query.ice, &query.coastline, &query.zones})
    unused->how = repository::DatasetChoice::How::none;
  const auto sea = repository::load_environment(context.db, query);
  if (!sea) return invalid(request, sea.error());
  return json_reply(drift_document(*sea, *until));
}

}  // namespace

std::vector<Route> iceberg_drift_routes() {
  return {{"GET",
           "/map/drift",
           {"bbox", "as_of", "until", "dataset", "max_sighting_age_days", "departure", "currents"},
           show_drift}};
}

}  // namespace floeplan::routes
