#include "tests/api/fields/contract.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "api/fields/process_fields.hpp"

namespace floeplan::fields {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t longest_text = 200;
constexpr std::size_t most_datasets = 64;

struct Schema {
  std::string name;
  std::vector<Field> fields;
  std::string object{};  // that the whole schema stands for
};

std::vector<Schema> schemas() {
  return {{"PlanInputs", fields_of(Process::plan_route)},
          {"EvaluateInputs", fields_of(Process::evaluate_route)},
          {"ReachInputs", fields_of(Process::reach)},
          {"Vehicle", fields_of_vehicle(), "vehicle"}};
}

std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  std::istringstream text{std::string{path}};
  for (std::string part; std::getline(text, part, '/');) parts.push_back(part);
  return parts;
}

/// The schema of an object's members, also where the object is one of several forms.
ordered_json& members_of(ordered_json& schema) {
  if (schema.contains("properties")) return schema["properties"];
  for (ordered_json& form : schema["oneOf"])
    if (form.contains("properties")) return form["properties"];
  throw std::out_of_range{"a schema has no members"};
}

/// The members of the schema among which the field stands.
ordered_json& home_of(const Field& field, const Schema& schema, ordered_json& document) {
  ordered_json* home = &members_of(document["components"]["schemas"][schema.name]);
  for (const std::string& part : parts_of(field.object))
    if (part != schema.object) home = &members_of(home->at(part));
  return *home;
}

/// 500 rather than 500.0.
ordered_json number(double value) {
  const bool is_whole = value == std::round(value) && std::abs(value) < 1e15;
  return is_whole ? ordered_json(static_cast<std::int64_t>(value)) : ordered_json(value);
}

std::string_view text_of(const repository::DatasetChoice& choice, const Field& field) {
  return choice.how == repository::DatasetChoice::How::none ? field.words.back().name
                                                            : field.words.front().name;
}

ordered_json usual_json(const Field& field) {
  struct AsJson {
    const Field& field;

    ordered_json operator()(bool value) const { return value; }
    ordered_json operator()(int value) const { return value; }
    ordered_json operator()(double value) const { return number(value); }
    ordered_json operator()(const std::string& value) const { return value; }
    ordered_json operator()(const core::UtcTime&) const { return nullptr; }
    ordered_json operator()(const repository::DatasetChoice& choice) const { return text_of(choice, field); }
  };
  return field.usual ? std::visit(AsJson{field}, *field.usual) : ordered_json();
}

ordered_json words_json(const Field& field) {
  ordered_json words = ordered_json::array();
  for (const Word& word : field.words) words.push_back(word.name);
  return words;
}

ordered_json place_schema() {
  return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 3}};
}

ordered_json number_schema(const Field& field, const char* type) {
  return {{"type", type}, {"minimum", number(field.least)}, {"maximum", number(field.most)}};
}

/// Without its default and description.
ordered_json bare_schema(const Field& field, const ordered_json& present) {
  switch (field.kind) {
    case Kind::number: return number_schema(field, "number");
    case Kind::whole_number: return number_schema(field, "integer");
    case Kind::boolean: return {{"type", "boolean"}};
    case Kind::word: return {{"type", "string"}, {"enum", words_json(field)}};
    case Kind::text: return {{"type", "string"}, {"maxLength", longest_text}};
    case Kind::time: return {{"type", "string"}, {"format", "date-time"}};
    case Kind::duration: return {{"type", "string"}, {"format", "duration"}, {"example", field.example}};
    case Kind::place: return place_schema();
    case Kind::places: return {{"type", "array"}, {"items", place_schema()}};
    case Kind::dataset: return {{"type", "string"}};
    case Kind::datasets:
      return {{"oneOf",
               {{{"type", "string"}},
                {{"type", "array"},
                 {"items", {{"type", "string"}}},
                 {"minItems", 1},
                 {"maxItems", most_datasets}}}}};
    case Kind::structure: return present;
  }
  return {};
}

std::string description_of(const Field& field) {
  std::string text{field.help};
  const std::string_view unit = field.kind == Kind::number ? unit_in_words(field) : "";
  if (!text.empty() && !unit.empty()) text.append(", ").append(unit);
  if (!field.details.empty()) text.append(". ").append(field.details);
  return text;
}

ordered_json schema_of(const Field& field, const ordered_json& present) {
  ordered_json schema = bare_schema(field, present);
  if (present.contains("nullable")) schema["nullable"] = present["nullable"];
  if (const ordered_json usual = usual_json(field); !usual.is_null())
    (field.kind == Kind::datasets ? schema["oneOf"][0] : schema)["default"] = usual;
  if (const std::string text = description_of(field); !text.empty()) schema["description"] = text;
  return schema;
}

/// The number of units of the request in one unit of the form.
double factor_of(const Form& form) {
  static const std::map<std::string_view, double> factors{{"h", 3600.0}, {"%", 0.01}, {"% ice", 0.01},
                                                          {"km", 1e3},   {"kJ", 1e3}, {"MJ", 1e6}};
  const auto found = factors.find(form.unit);
  return found == factors.end() ? 1.0 : found->second;
}

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::number: return "number";
    case Kind::whole_number: return "whole_number";
    case Kind::boolean: return "boolean";
    case Kind::word: return "word";
    case Kind::text: return "text";
    case Kind::time: return "time";
    case Kind::duration: return "duration";
    case Kind::place: return "place";
    case Kind::places: return "places";
    case Kind::dataset: return "dataset";
    case Kind::datasets: return "datasets";
    case Kind::structure: return "structure";
  }
  return "";
}

/// The name of a field in the set-up of the client: "under_ice.escape_plan".
std::string name_in_client(const Field& field) {
  return field.object.empty() ? std::string{field.name}
                              : std::string{field.object}.append(".").append(field.name);
}

ordered_json told_to_client(const Field& field) {
  ordered_json told{{"kind", name_of(field.kind)}};
  const auto tell = [&told](const char* key, const ordered_json& value, bool is_told) {
    if (is_told) told[key] = value;
  };
  tell("words", words_json(field), field.kind == Kind::word);
  tell("usual", usual_json(field), field.usual.has_value());
  tell("flag", field.flag, !field.flag.empty());
  tell("group", field.group, !field.group.empty());
  tell("label", field.form.label, !field.form.label.empty());
  tell("unit", field.form.unit, !field.form.unit.empty());
  tell("factor", number(factor_of(field.form)), factor_of(field.form) != 1.0);
  tell("blank", field.form.blank, !field.form.blank.empty());
  tell("hint", field.form.hint, !field.form.hint.empty());
  return told;
}

/// One line for each member, as a person would write it.
std::string one_by_one(const ordered_json& value, const std::string& begin, const std::string& end) {
  std::string text = begin + "\n";
  for (const auto& [key, member] : value.items())
    text += "  " + (value.is_object() ? ordered_json(key).dump() + ": " : "") + member.dump() + ",\n";
  return text + end;
}

std::string names_source(const std::string& constant, const std::vector<Field>& fields) {
  ordered_json names = ordered_json::array();
  for (const Field& field : fields) names.push_back(name_in_client(field));
  return one_by_one(names, "export const " + constant + " = [", "] as const;\n");
}

/// "\"margin_m\"", with the quotes of JSON escaped.
std::string entry_of(std::string_view word) { return "\"\\\"" + std::string{word} + "\\\"\""; }

}  // namespace

ordered_json with_fields(ordered_json document) {
  for (const Schema& schema : schemas()) {
    for (const Field& field : schema.fields) {
      ordered_json& home = home_of(field, schema, document);
      const std::string name{field.name};
      home[name] = schema_of(field, home.contains(name) ? home[name] : ordered_json::object());
    }
  }
  return document;
}

std::vector<std::string> unknown_members(const ordered_json& document) {
  ordered_json copy = document;
  std::vector<std::string> unknown;
  for (const Schema& schema : schemas()) {
    std::set<std::string> objects{""};
    std::set<std::string> known;
    for (const Field& field : schema.fields) {
      objects.emplace(field.object);
      known.insert(pointer_of(field));
      if (!field.object.empty()) known.insert("/" + std::string{field.object});
    }
    if (!schema.object.empty()) objects.erase("");
    for (const std::string& object : objects) {
      const Field any{.name = "any", .object = object};
      for (const auto& member : home_of(any, schema, copy).items()) {
        const Field named{.name = member.key(), .object = object};
        if (!known.contains(pointer_of(named))) unknown.push_back(schema.name + pointer_of(named));
      }
    }
  }
  return unknown;
}

std::string client_source() {
  ordered_json all = ordered_json::object();
  for (const Field& field : fields_of(Process::plan_route))
    all[name_in_client(field)] = told_to_client(field);
  // A vehicle has many fields; only those in forms are added here.
  for (const Field& field : fields_of_vehicle())
    if (field.object == "vehicle" && !field.form.label.empty() && !all.contains(std::string{field.name}))
      all[name_in_client(field)] = told_to_client(field);
  return "/** Made from the table of request fields (api/fields); CONTRIBUTING says how. */\n\n" +
         one_by_one(all, "export const requestFields = {", "} as const;\n") + "\n" +
         "/** What a route is judged under. */\n" + names_source("namesOfConditions", conditions_of_route()) +
         "\n" + "/** What isochrones are asked for with. */\n" +
         names_source("namesOfReach", fields_of(Process::reach));
}

std::string with_names(const std::string& dictionary) {
  std::istringstream text{dictionary};
  std::string comments;
  std::set<std::string> entries;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with('#')) {
      comments += line + "\n";
    } else if (!line.empty()) {
      entries.insert(line);
    }
  }
  for (const Schema& schema : schemas()) {
    for (const Field& field : schema.fields) {
      entries.insert(entry_of(field.name));
      for (const Word& word : field.words) entries.insert(entry_of(word.name));
    }
  }
  for (const std::string& entry : entries) comments += entry + "\n";
  return comments;
}

}  // namespace floeplan::fields
