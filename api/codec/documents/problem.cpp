#include "api/codec/documents/problem.hpp"

#include "engine/core/shown_text.hpp"
#include "engine/core/violation_list.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

nlohmann::json to_json(const problems::Problem& problem) {
  const bool whole_uri = problem.slug.starts_with("http");
  nlohmann::json document{{"type", whole_uri ? problem.slug : "/problems/" + problem.slug},
                          {"title", problem.title},
                          {"status", problem.status},
                          {"detail", core::excerpt(core::without_secrets(problem.detail))}};
  if (!problem.violations.empty()) {
    auto& errors = document["errors"] = nlohmann::json::array();
    for (const auto& violation : core::shortened(problem.violations)) {
      errors.push_back({{"pointer", core::excerpt(core::without_secrets(violation.field))},
                        {"detail", core::excerpt(core::without_secrets(violation.rule))}});
    }
  }
  return document;
}

}  // namespace floeplan::codec
