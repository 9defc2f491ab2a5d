#include "api/codec/bytes/text_values.hpp"
#include "api/codec/documents/probe_document.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "api/service/probe_service.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"

namespace floeplan::routes {
namespace {

Response show_probe(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  reader.require("lon", "the longitude in degrees");
  reader.require("lat", "the latitude in degrees");
  const auto lon = reader.number("lon", -180.0, 360.0);
  const auto lat = reader.number("lat", -90.0, 90.0);
  const auto time = reader.time("time");
  const auto depth = reader.number("depth_m", 0.0, 12000.0);
  const auto departure = reader.time("departure");
  const auto max_age_days = reader.number("max_sighting_age_days", 0.0, 30.0);
  if (!reader.violations().empty()) return invalid(request, reader.violations());

  service::ProbeQuery query;
  // Only a longitude of 180 or more is wrapped, because wrapping can change the last digit, and the command
  // line does not.
  query.place = {*lon < 180.0 ? *lon : geo::wrap_longitude(*lon), *lat};
  query.time = time.value_or(request.now);
  if (depth) query.depth = core::Metres{*depth};
  query.departure = departure;
  if (max_age_days) query.max_sighting_age = core::Seconds{*max_age_days * 86'400.0};
  if (const auto ids = request.parameter("dataset")) {
    for (const std::string_view id : codec::split(*ids, ',')) {
      query.dataset_ids.emplace_back(id);
      if (!repository::DatasetRepository{context.db}.find({std::string{id}}))
        return problem_reply<"unknown-dataset">(request, std::string{id});
    }
  }
  const auto result = service::probe(context.db, query);
  return result ? json_reply(codec::probe_document(*result)) : invalid(request, result.error());
}

}  // namespace

std::vector<Route> probe_routes() {
  return {{"GET",
           "/probe",
           {"lon", "lat", "time", "depth_m", "dataset", "departure", "max_sighting_age_days"},
           show_probe}};
}

}  // namespace floeplan::routes
