#include "api/routes/access/door_description.hpp"

#include "engine/core/letter_case.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// Patterns and templates differ where a parameter takes the rest of the path, and where one operation serves several
/// templates ("/processes/{process_id}/execution").
bool is_template_of(const Route& route, const std::string& path) {
  const std::string_view pattern = route.pattern;
  std::size_t at = 0;
  std::size_t in_path = 0;
  while (at < pattern.size() && in_path < path.size()) {
    if (pattern[at] == '{') {
      at = pattern.find('}', at) + 1;
      in_path = std::min(path.find('/', in_path), path.size());
    } else if (pattern[at++] != path[in_path++]) {
      return false;
    }
  }
  return at == pattern.size() && in_path == path.size();
}

void describe(json& operation, const Route& route) {
  const auto least = least_role(route);
  if (!least) {
    operation["security"] = json::array();
    return;
  }
  operation["security"] = {{{"token", json::array()}}, {{"login", json::array()}}};
  operation["x-role"] = repository::role_name(*least);
  for (const char* status : {"401", "403", "429"})
    operation["responses"][status] = {{"$ref", "#/components/responses/Problem"}};
}

}  // namespace

void describe_doors(json& document, const std::vector<Route>& routes) {
  for (auto& [path, operations] : document["paths"].items()) {
    for (const Route& route : routes) {
      const auto operation = operations.find(core::lower_case(route.method));
      if (operation != operations.end() && is_template_of(route, path)) describe(*operation, route);
    }
  }
}

}  // namespace floeplan::routes
