#include "api/codec/document_values.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

using nlohmann::json;

double document_degrees(double degrees) { return std::round(degrees * 1e7) / 1e7; }

json optional_time(const std::optional<core::UtcTime>& time) {
  return time ? json(core::iso8601(*time)) : json();
}

core::UtcTime stored_time(const json& object, const char* key) {
  const auto time = core::parse_iso8601(object.at(key).get<std::string>());
  if (!time) throw std::runtime_error{std::string{"a stored plan has no valid time "} + key};
  return *time;
}

}  // namespace floeplan::codec
