#include "api/codec/bytes/json_text.hpp"
#include "api/codec/documents/dataset_document.hpp"
#include "api/codec/inputs/retention_inputs.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "api/routes/request/store_trouble.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/datasets/retention.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

std::vector<core::UtcTime> times_of(sql::Connection& db, const repository::Dataset& dataset) {
  std::vector<core::UtcTime> times;
  const bool has_steps = repository::has_steps(dataset.kind);
  if (!has_steps) return times;
  const auto shape = repository::FieldRepository{db}.shape(dataset.id);
  if (!shape || !shape->times_s) return times;
  for (const double time_s : shape->times_s->nodes()) times.push_back(core::from_unix_seconds(time_s));
  return times;
}

Response list_datasets(const Context& context, const Request&, const PathParameters&) {
  auto [whole, damaged] = repository::DatasetRepository{context.db}.list_past_damage();
  json datasets = json::array();
  for (const auto& dataset : whole) {
    const bool has_times = sql::meets_no_damage(
        [&] { datasets.push_back(codec::dataset_document(dataset, times_of(context.db, dataset), whole)); });
    if (!has_times) damaged.push_back({.kind = "dataset", .id = dataset.id.value});
  }
  json list{{"datasets", std::move(datasets)}};
  name_damaged(list, damaged);
  return json_reply(list);
}

Response show_dataset(const Context& context, const Request& request, const PathParameters& path) {
  const auto dataset = repository::DatasetRepository{context.db}.find({path.at("dataset_id")});
  if (!dataset) return problem_reply<"unknown-dataset">(request, path.at("dataset_id"));
  return json_reply(
      codec::dataset_document(*dataset, times_of(context.db, *dataset),
                              repository::DatasetRepository{context.db}.list_past_damage().whole));
}

Response remove_dataset(const Context& context, const Request& request, const PathParameters& path) {
  if (!repository::DatasetRepository{context.db}.remove({path.at("dataset_id")})) {
    return problem_reply<"unknown-dataset">(request, path.at("dataset_id"));
  }
  Response response;
  response.status = 204;
  return response;
}

/// Removes datasets by rules, not by a list of ids; the answer and the audit log name the removed ones.
Response prune_datasets(const Context& context, const Request& request, const PathParameters&) {
  const auto body = codec::parse_json(request.body);
  if (!body) return problem_reply<"invalid-json">(request, body.error());
  const auto inputs = codec::parse_retention_inputs(*body);
  if (!inputs) return invalid(request, inputs.error());
  const auto gone =
      inputs->dry_run
          ? repository::beyond_retention(repository::stored_sizes(context.db), inputs->rules, request.now)
          : repository::remove_beyond_retention(context.db, inputs->rules, request.now);
  return json_reply(codec::retention_document(gone, inputs->dry_run));
}

}  // namespace

std::vector<Route> dataset_routes() {
  return {{"GET", "/datasets", {}, list_datasets},
          {"GET", "/datasets/{dataset_id}", {}, show_dataset},
          {"DELETE", "/datasets/{dataset_id}", {}, remove_dataset, Access::admin},
          {"POST", "/datasets/prune", {}, prune_datasets, Access::admin}};
}

}  // namespace floeplan::routes
