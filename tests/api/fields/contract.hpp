#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// The parts of the contract with clients that describe the fields of requests. They are made from the table
/// of the fields.
namespace floeplan::fields {

/// The OpenAPI document, with the schemas PlanInputs, EvaluateInputs, ReachInputs and Vehicle as the table of
/// the fields gives them. A field whose kind is `structure` keeps its schema and gets its description from
/// the table.
/// Errors   throws std::out_of_range where the document lacks the object that a field is a member of
[[nodiscard]] nlohmann::ordered_json with_fields(nlohmann::ordered_json document);

/// Members of those schemas that the table does not know, as "PlanInputs/under_ice/deepest".
[[nodiscard]] std::vector<std::string> unknown_members(const nlohmann::ordered_json& document);

/// The source file of the browser client that describes the fields: web/src/contract/request_fields.ts.
[[nodiscard]] std::string client_source();

/// The fuzzers' dictionary with every name and word of the fields.
[[nodiscard]] std::string with_names(const std::string& dictionary);

}  // namespace floeplan::fields
