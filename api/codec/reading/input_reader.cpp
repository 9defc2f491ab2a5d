#include "api/codec/reading/input_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "engine/geo/written_place.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

/// A number as a person would write it: "0.35", "5000".
std::string written(double value) { return json(value).dump(); }

/// A key inside a JSON pointer (RFC 6901).
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
  if (!object_.is_object()) refuse(pointer_, "must be an object, not " + shown(object_));
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
    refuse(pointer_to(key), "must be a text, not " + shown(*value));
    return std::nullopt;
  }
  const auto& text = value->get_ref<const std::string&>();
  if (text.size() > max_length) {
    refuse(pointer_to(key),
           "must have at most " + std::to_string(max_length) + " bytes, not " + std::to_string(text.size()));
    return std::nullopt;
  }
  return text;
}

std::optional<bool> InputReader::boolean(const std::string& key) {
  const json* value = member(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_boolean()) return value->get<bool>();
  refuse(pointer_to(key), "must be true or false, not " + shown(*value));
  return std::nullopt;
}

std::optional<double> InputReader::number(const std::string& key, NumberRange range) {
  const json* value = member(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_number()) {
    const double number = value->get<double>();
    if (std::isfinite(number) && number >= range.from && number <= range.to) return number;
  }
  refuse(pointer_to(key), "must be a number from " + written(range.from) + " to " + written(range.to) +
                              ", not " + shown(*value));
  return std::nullopt;
}

std::optional<int> InputReader::integer(const std::string& key, int from, int to) {
  const json* value = member(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_number()) {
    const double number = value->get<double>();
    if (number >= from && number <= to && number == std::floor(number)) return static_cast<int>(number);
  }
  refuse(pointer_to(key), "must be a whole number from " + std::to_string(from) + " to " +
                              std::to_string(to) + ", not " + shown(*value));
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
  refuse(pointer_to(key),
         "must be a time in ISO 8601 with its zone, as 2026-11-20T06:00:00Z, not " + shown(*value));
  return std::nullopt;
}

std::optional<core::Seconds> InputReader::duration(const std::string& key) {
  const json* value = member(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_string()) {
    if (const auto duration = core::parse_iso8601_duration(value->get_ref<const std::string&>()))
      return duration;
  }
  refuse("/" + key, "must be a duration in ISO 8601, as PT1H or P1DT30M, not " + shown(*value));
  return std::nullopt;
}

std::optional<geo::LonLat> InputReader::to_place(const json& value, const std::string& pointer) {
  const std::string rule = "must be [longitude, latitude] in degrees, not ";
  if (!value.is_array() || value.size() < 2 || value.size() > 3) {
    refuse(pointer, rule + (value.is_array() ? "an array of " + std::to_string(value.size()) : shown(value)));
    return std::nullopt;
  }
  for (const json& number : value) {
    if (number.is_number()) continue;
    refuse(pointer, rule + "an array with " + shown(number));
    return std::nullopt;
  }
  if (value.size() == 3 && value[2].get<double>() != 0.0) ++heights_;
  const auto place = geo::written_place(value[0].get<double>(), value[1].get<double>());
  if (!place)
    refuse(pointer, "must have its longitude within -360 to 360 and its latitude within -90 to 90, not [" +
                        shown(value[0]) + ", " + shown(value[1]) + "]");
  return place;
}

std::optional<geo::LonLat> InputReader::place(const std::string& key) {
  const json* value = member(key);
  return value == nullptr ? std::nullopt : to_place(*value, pointer_to(key));
}

std::optional<std::vector<geo::LonLat>> InputReader::places(const json& value, const std::string& pointer,
                                                            std::size_t least, std::size_t most) {
  if (!value.is_array() || value.size() < least || value.size() > most) {
    refuse(pointer, "must be an array of " + std::to_string(least) + " to " + std::to_string(most) +
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

void InputReader::require(const std::string& key, const std::string& rule) {
  const bool absent = object_.is_object() && member(key) == nullptr;
  if (absent) refuse(pointer_to(key), rule);
}

void InputReader::refuse(const std::string& pointer, const std::string& rule) {
  core::note(violations_, {pointer, rule});
}

void InputReader::refuse_all(const std::string& pointer, const core::Violations& violations) {
  for (const core::Violation& violation : violations) refuse(pointer + violation.field, violation.rule);
}

void InputReader::refuse_member(const std::string& key, const std::string& rule) {
  refuse(pointer_to(key), rule);
}

void InputReader::refuse_unknown() {
  if (!object_.is_object()) return;
  std::string rule = "is not known; the known keys are ";
  for (const auto& name : known_) rule += (name == *known_.begin() ? "" : ", ") + name;
  for (const auto& [key, value] : object_.items()) {
    if (is_full()) return;
    if (known_.contains(key)) continue;
    refuse(pointer_to(key), rule);
    rule = "is not known either";
  }
}

std::vector<std::string> InputReader::remarks() const {
  return heights_ == 0 ? std::vector<std::string>{} : std::vector{heights_left_out(heights_)};
}

bool InputReader::refused(const std::string& pointer) const {
  return std::any_of(violations_.begin(), violations_.end(), [&](const core::Violation& violation) {
    return violation.field == pointer || violation.field.starts_with(pointer + "/");
  });
}

}  // namespace floeplan::codec
