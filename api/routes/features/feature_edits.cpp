#include "api/routes/features/feature_edits.hpp"

#include "api/codec/bytes/json_text.hpp"
#include "api/codec/bytes/sha256.hpp"
#include "api/routes/request/feature_crs.hpp"
#include "api/routes/request/reply.hpp"
#include "storage/json/json.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// The feature in the body. Positions must be in CRS84, the only system for editing.
tl::expected<json, Response> read_feature(const Request& request) {
  const std::string type = request.header("content-type");
  if (!type.empty() && type.find("json") == std::string::npos) {
    return tl::unexpected(problem_reply<"no-geojson">(request));
  }
  const std::string crs = request.header("content-crs");
  if (!crs.empty() && crs != "<" + uri_of(FeatureCrs::crs84) + ">")
    return tl::unexpected(invalid(request, {{"Content-Crs", "must be <" + uri_of(FeatureCrs::crs84) + ">"}}));
  auto body = codec::parse_json(request.body);
  if (!body) return tl::unexpected(problem_reply<"invalid-json">(request, body.error()));
  if (!body->is_object())
    return tl::unexpected(invalid(request, {{"", "must be a GeoJSON Feature, an object"}}));
  return std::move(*body);
}

bool tag_fits(const Request& request, const json& feature) {
  const std::string wanted = request.header("if-match");
  return wanted.empty() || wanted == "*" || wanted.find('"' + feature_tag(feature)) != std::string::npos;
}

/// The feature that a request wants to change, or the problem if it cannot be changed.
tl::expected<json, Response> changeable(const FeatureCollection& collection, const Context& context,
                                        const Request& request, const std::string& id) {
  auto feature = collection.find(context, id);
  if (!feature) return tl::unexpected(no_such_feature(request, collection, id));
  const std::string objection = collection.editing->objection(context, id);
  if (!objection.empty()) {
    return tl::unexpected(problem_reply<"feature-from-a-file">(request, objection));
  }
  if (!tag_fits(request, *feature)) {
    return tl::unexpected(problem_reply<"changed-meanwhile">(request));
  }
  return std::move(*feature);
}

/// Answers 204 with the new entity tag of the feature.
Response changed(const FeatureCollection& collection, const Context& context, const std::string& id) {
  Response response;
  response.status = 204;
  if (const auto feature = collection.find(context, id))
    response.headers.emplace_back("ETag", '"' + feature_tag(*feature) + '"');
  return response;
}

}  // namespace

Response create_feature(const FeatureCollection& collection, const Context& context, const Request& request) {
  const auto feature = read_feature(request);
  if (!feature) return feature.error();
  sql::Transaction transaction{context.db};
  const auto id = collection.editing->create(context, *feature, request.now);
  if (!id) return invalid(request, id.error());
  transaction.commit();

  const std::string address = context.service.public_url + "/collections/" + collection.id + "/items/" + *id;
  Response response = changed(collection, context, *id);
  response.status = 201;
  response.headers.emplace_back("Location", address);
  return response;
}

Response replace_feature(const FeatureCollection& collection, const Context& context, const Request& request,
                         const std::string& id) {
  const auto feature = read_feature(request);
  if (!feature) return feature.error();
  sql::Transaction transaction{context.db};
  const auto before = changeable(collection, context, request, id);
  if (!before) return before.error();
  const auto replaced = collection.editing->replace(context, id, *feature, request.now);
  if (!replaced) return invalid(request, replaced.error());
  transaction.commit();
  return changed(collection, context, id);
}

Response update_feature(const FeatureCollection& collection, const Context& context, const Request& request,
                        const std::string& id) {
  const auto patch = read_feature(request);
  if (!patch) return patch.error();
  sql::Transaction transaction{context.db};
  auto feature = changeable(collection, context, request, id);
  if (!feature) return feature.error();
  feature->merge_patch(*patch);
  const auto replaced = collection.editing->replace(context, id, *feature, request.now);
  if (!replaced) return invalid(request, replaced.error());
  transaction.commit();
  return changed(collection, context, id);
}

Response remove_feature(const FeatureCollection& collection, const Context& context, const Request& request,
                        const std::string& id) {
  sql::Transaction transaction{context.db};
  const auto before = changeable(collection, context, request, id);
  if (!before) return before.error();
  collection.editing->remove(context, id, request.now);
  transaction.commit();
  Response response;
  response.status = 204;
  return response;
}

std::string feature_tag(const json& feature) {
  return codec::sha256(feature.dump(-1, ' ', false, json::error_handler_t::replace)).substr(0, 16);
}

Response no_such_feature(const Request& request, const FeatureCollection& collection, const std::string& id) {
  return problem_reply<"unknown-feature">(request, collection.title, id);
}

}  // namespace floeplan::routes
