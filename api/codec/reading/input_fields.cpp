#include "api/codec/reading/input_fields.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using fields::Field;
using fields::Kind;
using fields::Value;
using nlohmann::json;
using repository::DatasetChoice;

constexpr std::size_t most_datasets = 64;  // the largest number of ensemble members

std::string in_quotes(std::string_view word) { return '"' + std::string{word} + '"'; }

/// The allowed words with their meanings, for a message: `"add" (to currents without tides) or "only" (...)`.
std::string known_words(const std::vector<fields::Word>& words) {
  std::string rule;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) rule += i + 1 == words.size() ? " or " : ", ";
    rule += in_quotes(words[i].name);
    if (!words[i].meaning.empty()) rule += " (" + std::string{words[i].meaning} + ")";
  }
  return rule;
}

std::optional<Value> read_word(InputReader& reader, const Field& field) {
  const auto text = reader.text(std::string{field.name});
  if (!text) return std::nullopt;
  if (std::ranges::find(field.words, *text, &fields::Word::name) != field.words.end()) return *text;
  reader.refuse_member<"wrong-shape-found">(std::string{field.name}, known_words(field.words),
                                            in_quotes(*text));
  return std::nullopt;
}

/// Reads an array of ids; empty if it is wrong, which is a violation.
std::optional<Value> read_ids(InputReader& reader, const std::string& key, const json& ids) {
  DatasetChoice choice{DatasetChoice::How::named, {}};
  if (ids.size() > most_datasets) {
    reader.refuse_member<"too-many">(key, most_datasets, "ids", std::to_string(ids.size()));
    return std::nullopt;
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i].is_string()) {
      choice.ids.push_back({ids[i].get<std::string>()});
    } else {
      reader.refuse<"wrong-shape-found">("/" + key + "/" + std::to_string(i), "the id of a dataset",
                                         shown(ids[i]));
    }
  }
  return choice;
}

std::optional<Value> read_datasets(InputReader& reader, const Field& field) {
  const std::string key{field.name};
  const json* value = reader.member(key);
  if (value == nullptr) return std::nullopt;
  if (value->is_string()) {
    const auto& text = value->get_ref<const std::string&>();
    if (text == field.words.front().name) return DatasetChoice{DatasetChoice::How::newest, {}};
    if (text == field.words.back().name) return DatasetChoice{DatasetChoice::How::none, {}};
    return DatasetChoice{DatasetChoice::How::named, {{text}}};
  }
  const bool several = field.kind == Kind::datasets;
  if (several && value->is_array() && !value->empty()) return read_ids(reader, key, *value);
  reader.refuse_member<"wrong-shape-found">(key,
                                            in_quotes(field.words.front().name) + ", " +
                                                in_quotes(field.words.back().name) +
                                                (several ? ", an id or an array of ids" : " or an id"),
                                            shown(*value));
  return std::nullopt;
}

struct AsJson {
  const Field& field;

  json operator()(const auto& plain) const { return plain; }
  json operator()(const core::UtcTime& time) const { return core::iso8601(time); }
  json operator()(const DatasetChoice& choice) const {
    if (choice.how == DatasetChoice::How::newest) return field.words.front().name;
    if (choice.how == DatasetChoice::How::none) return field.words.back().name;
    if (choice.ids.size() == 1) return choice.ids.front().value;
    json ids = json::array();
    for (const auto& id : choice.ids) ids.push_back(id.value);
    return ids;
  }
};

/// Converts a value that was read to the table's type.
template <class T>
std::optional<Value> as_value(const std::optional<T>& read) {
  return read ? std::optional<Value>{*read} : std::nullopt;
}

}  // namespace

std::optional<Value> read_value(InputReader& reader, const Field& field) {
  const std::string key{field.name};
  switch (field.kind) {
    case Kind::number: return as_value(reader.number(key, {field.least, field.most}));
    case Kind::whole_number:
      return as_value(reader.integer(key, static_cast<int>(field.least), static_cast<int>(field.most)));
    case Kind::boolean: return as_value(reader.boolean(key));
    case Kind::word: return read_word(reader, field);
    case Kind::text: return as_value(reader.text(key));
    case Kind::time: return as_value(reader.time(key));
    case Kind::dataset:
    case Kind::datasets: return read_datasets(reader, field);
    case Kind::duration:
    case Kind::place:
    case Kind::places:
    case Kind::structure: break;
  }
  throw std::invalid_argument{key + " has a reader of its own"};
}

void write_value(const Field& field, const std::optional<Value>& value, json& inputs) {
  inputs[std::string{field.name}] = value ? std::visit(AsJson{field}, *value) : json();
}

}  // namespace floeplan::codec
