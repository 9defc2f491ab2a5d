#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// What the contract with clients says of the fields of requests, made from their table.
namespace floeplan::fields {

/// The OpenAPI document with the schemas of the fields as their table has them: of PlanInputs, EvaluateInputs, ReachInputs
/// and Vehicle. What has a shape of its own keeps its schema and gets its description.
/// Errors   throws std::out_of_range where the document lacks the object that a field is a member of
[[nodiscard]] nlohmann::ordered_json with_fields(nlohmann::ordered_json document);

/// Members of those schemas that the table does not know, as "PlanInputs/under_ice/deepest".
[[nodiscard]] std::vector<std::string> unknown_members(const nlohmann::ordered_json& document);

/// The source of the browser client that tells it of the fields: web/src/contract/request_fields.ts.
[[nodiscard]] std::string client_source();

/// The fuzzers' dictionary with every name and word of the fields.
[[nodiscard]] std::string with_names(const std::string& dictionary);

}  // namespace floeplan::fields
