#include "api/codec/reading/input_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "engine/geo/written_place.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

/// A number without trailing digits: "0.35", "5000".
std::string written(double value) { return json(value).dump(); }

/// A key escaped for a JSON pointer (RFC 6901).
std::string escaped(const std::string& key) {
  std::string result;
  for (const char c : key) {
    if (c == '~') {
      result += "~0";
    } else if (c == '/') {
      result += "~1";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string shown(const json& value) {
  if (value.is_structured()) return value.is_array() ? "an array" : "an object";
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() > 60) text = "a long text";
  return text;
}

std::string heights_left_out(std::size_t places) {
  return "the third number of " + (places == 1 ? "a position" : std::to_string(places) + " positions") +
         " (a height or depth) is left out: how deep the vehicle dives follows from its profile";
}

InputReader::InputReader(const json& object, std::string pointer)
    : object_{object}, pointer_{std::move(pointer)} {
  if (!object_.is_object()) refuse<"wrong-shape-found">(pointer_, "an object", shown(object_));
}

std::string InputReader::pointer_to(const std::string& key) const { return pointer_ + "/" + escaped(key); }

const json* InputReader::member(const std::string& key) {
  known_.insert(key);
  if (!object_.is_object()) return nullptr;
  const auto found = object_.find(key);
  return found == object_.end() || found->is_null() ? nullptr : &*found;
}

std::optional<std::string> InputReader::text(const std::string& key, std::size_t max_length) {
  const json* value = member(key);
  if (value == nullptr) return std::nullopt;
  if (!value->is_string()) {
    refuse_member<"wrong-shape-found">(key, "a text", shown(*value));
    return std::nullopt;
  }
  const auto& text = value->get_ref<const std::string&>();
  if (text.size() > max_length) {
    refuse_member<"too-long">(key, max_length, text.size());
    return std::nullopt;
  }
  return text;
}

std::optional<bool> InputReader::boolean(const std::string& key) {
  const json* value = member(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_boolean()) return value->get<bool>();
  refuse_member<"wrong-shape-found">(key, "true or false", shown(*value));
  return std::nullopt;
}

std::optional<double> InputReader::number(const std::string& key, NumberRange range) {
  const json* value = member(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_number()) {
    const double number = value->get<double>();
    if (std::isfinite(number) && number >= range.from && number <= range.to) return number;
  }
  refuse_member<"number-out-of-range">(key, written(range.from), written(range.to), shown(*value));
  return std::nullopt;
}

std::optional<int> InputReader::integer(const std::string& key, int from, int to) {
  const json* value = member(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_number()) {
    const double number = value->get<double>();
    if (number >= from && number <= to && number == std::floor(number)) return static_cast<int>(number);
  }
  refuse_member<"whole-number-out-of-range">(key, from, to, shown(*value));
  return std::nullopt;
}

std::optional<core::UtcTime> InputReader::time(const std::string& key) {
  const json* value = member(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_string()) {
    if (const auto time = core::parse_iso8601(value->get_ref<const std::string&>())) {
      return core::from_unix_seconds(std::round(core::unix_seconds(*time)));
    }
  }
  refuse_member<"wrong-shape-found">(key, "a time in ISO 8601 with its zone, as 2026-11-20T06:00:00Z",
                                     shown(*value));
  return std::nullopt;
}

std::optional<core::Seconds> InputReader::duration(const std::string& key) {
  const json* value = member(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_string()) {
    if (const auto duration = core::parse_iso8601_duration(value->get_ref<const std::string&>()))
      return duration;
  }
  refuse_member<"wrong-shape-found">(key, "a duration in ISO 8601, as PT1H or P1DT30M", shown(*value));
  return std::nullopt;
}

std::optional<geo::LonLat> InputReader::to_place(const json& value, const std::string& pointer) {
  constexpr std::string_view shape = "[longitude, latitude] in degrees";
  if (!value.is_array() || value.size() < 2 || value.size() > 3) {
    refuse<"wrong-shape-found">(
        pointer, shape, value.is_array() ? "an array of " + std::to_string(value.size()) : shown(value));
    return std::nullopt;
  }
  for (const json& number : value) {
    if (number.is_number()) continue;
    refuse<"wrong-shape-found">(pointer, shape, "an array with " + shown(number));
    return std::nullopt;
  }
  if (value.size() == 3 && value[2].get<double>() != 0.0) ++heights_;
  const auto place = geo::written_place(value[0].get<double>(), value[1].get<double>());
  if (!place) refuse<"not-on-the-globe">(pointer, shown(value[0]), shown(value[1]));
  return place;
}

std::optional<geo::LonLat> InputReader::place(const std::string& key) {
  const json* value = member(key);
  return value == nullptr ? std::nullopt : to_place(*value, pointer_to(key));
}

std::optional<std::vector<geo::LonLat>> InputReader::places(const json& value, const std::string& pointer,
                                                            std::size_t least, std::size_t most) {
  if (!value.is_array() || value.size() < least || value.size() > most) {
    refuse<"wrong-shape">(pointer, "an array of " + std::to_string(least) + " to " + std::to_string(most) +
                                       " positions [longitude, latitude]");
    return std::nullopt;
  }
  std::vector<geo::LonLat> result;
  for (std::size_t i = 0; i < value.size() && !is_full(); ++i) {
    if (const auto place = to_place(value[i], pointer + "/" + std::to_string(i))) result.push_back(*place);
  }
  if (result.size() != value.size()) return std::nullopt;
  return result;
}

std::optional<std::vector<geo::LonLat>> InputReader::places(const std::string& key, std::size_t least,
                                                            std::size_t most) {
  const json* value = member(key);
  return value == nullptr ? std::nullopt : places(*value, pointer_to(key), least, most);
}

void InputReader::require(const std::string& key, std::string_view what) {
  if (lacks(key)) refuse_member<"required">(key, what);
}

void InputReader::require_with(const std::string& other, const std::string& key, std::string_view what) {
  if (lacks(key)) refuse_member<"required-with">(key, other, what);
}

bool InputReader::lacks(const std::string& key) { return object_.is_object() && member(key) == nullptr; }

void InputReader::refuse_rest(const core::Violations& violations) {
  for (const core::Violation& violation : violations)
    if (!refused(violation.field)) faults_.take({violation});
}

void InputReader::refuse_unknown() {
  if (!object_.is_object()) return;
  std::string known;
  for (const auto& name : known_) known += (name == *known_.begin() ? "" : ", ") + name;
  bool is_first = true;
  for (const auto& [key, value] : object_.items()) {
    if (is_full()) return;
    if (known_.contains(key)) continue;
    if (is_first) refuse_member<"unknown-member">(key, known);
    if (!is_first) refuse_member<"another-unknown-member">(key);
    is_first = false;
  }
}

std::vector<std::string> InputReader::remarks() const {
  return heights_ == 0 ? std::vector<std::string>{} : std::vector{heights_left_out(heights_)};
}

bool InputReader::refused(const std::string& pointer) const {
  return std::ranges::any_of(violations(), [&](const core::Violation& violation) {
    return violation.field == pointer || violation.field.starts_with(pointer + "/");
  });
}

}  // namespace floeplan::codec
