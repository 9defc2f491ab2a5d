#include "api/codec/inputs/echo_inputs.hpp"

#include <algorithm>

#include "api/codec/reading/input_reader.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr std::size_t longest_text = 10'000;
constexpr std::size_t most_numbers = 10'000;
constexpr int longest_pause_s = 10;  // limited because a worker is occupied during the pause

/// The input without the object {"value": ...} around it, which may state its media type.
json unwrapped(const json& input) {
  return input.is_object() && input.contains("value") ? input.at("value") : input;
}

bool is_text(const json& value) {
  return value.is_string() && value.get_ref<const std::string&>().size() <= longest_text;
}

bool is_text_or_integer(const json& value) { return is_text(value) || value.is_number_integer(); }

bool are_numbers(const json& value) {
  return value.is_array() && value.size() <= most_numbers &&
         std::all_of(value.begin(), value.end(), [](const json& number) { return number.is_number(); });
}

bool is_box(const json& value) {
  if (!value.is_object() || !value.contains("bbox")) return false;
  const json& corners = value.at("bbox");
  return are_numbers(corners) && (corners.size() == 4 || corners.size() == 6) &&
         value.value("crs", json("")).is_string() &&
         value.size() == (value.contains("crs") ? std::size_t{2} : std::size_t{1});
}

struct EchoInput {
  const char* name;
  bool (*fits)(const json&);
  const char* shape;
};

constexpr EchoInput known_inputs[]{
    {"echo", is_text, "a text of at most 10000 bytes"},
    {"text", is_text, "a text of at most 10000 bytes"},
    {"value", is_text_or_integer, "a text of at most 10000 bytes or a whole number"},
    {"numbers", are_numbers, "an array of at most 10000 numbers"},
    {"region", is_box, "an object with \"bbox\", four or six numbers, and at most a \"crs\" beside it"},
};

}  // namespace

tl::expected<EchoInputs, core::Violations> parse_echo_inputs(const json& inputs) {
  if (!inputs.is_object())
    return tl::unexpected(core::Violations{messages::fault<"wrong-shape">("", "an object")});
  json plain = inputs;
  for (json& input : plain) input = unwrapped(input);

  InputReader reader{plain};
  EchoInputs result{.values = json::object(), .pause = {}};
  for (const EchoInput& known : known_inputs) {
    const json* value = reader.member(known.name);
    if (value == nullptr) continue;
    if (!known.fits(*value)) reader.refuse<"wrong-shape">(std::string{"/"} + known.name, known.shape);
    result.values[known.name] = *value;
  }
  result.pause = core::Seconds{reader.integer("pause", 0, longest_pause_s).value_or(0) * 1.0};
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());
  return result;
}

json to_json(const EchoInputs& inputs) {
  json document = inputs.values;
  document["pause"] = static_cast<int>(inputs.pause.count());
  return document;
}

}  // namespace floeplan::codec
