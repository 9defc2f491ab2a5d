#include "api/codec/bytes/foreign_members.hpp"

#include "storage/json/json.hpp"

namespace floeplan::codec {

using nlohmann::json;

std::string text_at(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

std::optional<double> number_at(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? std::optional{found->get<double>()} : std::nullopt;
}

}  // namespace floeplan::codec
