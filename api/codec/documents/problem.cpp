#include "api/codec/documents/problem.hpp"

#include "api/codec/bytes/document_values.hpp"
#include "engine/core/shown_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

nlohmann::json to_json(const problems::Problem& problem) {
  const bool whole_uri = problem.slug.starts_with("http");
  nlohmann::json document{{"type", whole_uri ? problem.slug : "/problems/" + problem.slug},
                          {"title", problem.title},
                          {"status", problem.status},
                          {"detail", core::excerpt(core::without_secrets(problem.detail))}};
  if (!problem.violations.empty()) document["errors"] = errors_json(problem.violations);
  return document;
}

}  // namespace floeplan::codec
