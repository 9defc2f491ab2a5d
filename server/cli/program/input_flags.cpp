#include "server/cli/program/input_flags.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "api/codec/bytes/json_text.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/flag_values.hpp"

namespace floeplan::cli {
namespace {

using fields::Field;
using fields::Kind;
using nlohmann::json;

std::string flag_of(const Field& field) { return "--" + std::string{field.flag}; }

json place_of(const std::string& flag, const std::string& text) {
  const auto place = parse_place(text);
  if (!place) throw flag_fault<"not-lon-lat">(flag, text, flag);
  return json::array({place->lon_deg, place->lat_deg});
}

/// Sets a member of an object in the inputs. If the request file has a value there that is no object, it
/// stays, so that the check of all inputs refuses it.
void set_inside(json& inputs, const std::string& object, const std::string& key, json value) {
  json& stated = inputs[object];
  if (stated.is_null() || stated.is_object()) stated[key] = std::move(value);
}

/// Sets the uncertainty's objective: "mean", or a quantile given as a number.
void set_robust(json& inputs, const std::string& text) {
  const auto numbers = parse_numbers(text);
  if (text != "mean" && (!numbers || numbers->size() != 1)) {
    throw flag_fault<"no-share-of-members">("--robust", text);
  }
  set_inside(inputs, "uncertainty", "objective", numbers ? "quantile" : "mean");
  if (numbers) set_inside(inputs, "uncertainty", "quantile", numbers->front());
}

/// Sets the objective: "time", "energy" or "weighted:W". Any other word is kept, so that the check of all
/// inputs refuses it.
void set_objective(json& inputs, const std::string& text) {
  const std::string weighted = "weighted:";
  inputs["objective"] = text;
  if (!text.starts_with(weighted)) return;
  const auto weight = parse_numbers(text.substr(weighted.size()));
  if (!weight || weight->size() != 1) {
    throw flag_fault<"objective-without-weight">("--objective", text);
  }
  inputs["objective"] = {{"time", 1.0}, {"energy", weight->front()}};
}

void set_spacing(json& inputs, const std::string& text) {
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() > 2) {
    throw flag_fault<"no-spacing">("--spacing", text);
  }
  inputs["spacing_m"] = numbers->size() == 1 ? json((*numbers)[0]) : json(*numbers);
}

void set_hours(json& inputs, const std::string& text) {
  const auto numbers = parse_numbers(text);
  if (!numbers) throw flag_fault<"no-hours">("--hours", text);
  inputs["hours"] = *numbers;
}

/// How to set a field whose flag has a special notation.
struct OwnWay {
  void (*set)(json& inputs, const std::string& text);
  const char* text;  // description for the help
};

/// Fields with a special notation, by their JSON pointers.
const std::map<std::string, OwnWay> own_ways{
    {"/uncertainty/objective", {set_robust, "mean, or a share of the members such as 0.9"}},
    {"/objective", {set_objective, "weighted:W counts each joule as W seconds"}},
    {"/spacing_m", {set_spacing, "as 1000 or 1000,500"}},
    {"/hours", {set_hours, "as 6 or 6,12,24"}},
    {"/goals_file",
     {[](json& inputs, const std::string& file) { inputs["goals_file"] = file_member(file); },
      ".ma, .mi, GPX, KML, GeoJSON, CSV, NMEA, Seaglider targets or an IMC plan"}},
    {"/areas",
     {[](json& inputs, const std::string& file) { inputs["areas"] = read_object(file, "file of areas"); },
      "a GeoJSON file, for example areas.geojson"}},
};

const OwnWay* own_way_of(const Field& field) {
  const auto found = field.kind == Kind::number ? own_ways.end() : own_ways.find(fields::pointer_of(field));
  return found == own_ways.end() ? nullptr : &found->second;
}

std::string number_text(double number) {
  char text[400];
  const auto end = std::to_chars(std::begin(text), std::end(text), number, std::chars_format::fixed).ptr;
  return {text, end};
}

/// The range of a number for the help: "; metres, 0 to 1000".
std::string range_text(const Field& field) {
  const std::string unit{fields::unit_in_words(field)};
  return (unit.empty() ? "; " : "; " + unit + (field.unit == "s" ? " or as PT2H" : "") + ", ") +
         number_text(field.least) + " to " + number_text(field.most);
}

struct UsualText {
  const Field& field;

  std::string operator()(bool) const { return ""; }
  std::string operator()(int number) const { return "; default " + std::to_string(number); }
  std::string operator()(double number) const { return "; default " + number_text(number); }
  std::string operator()(const std::string& text) const { return "; default " + text; }
  std::string operator()(const core::UtcTime&) const { return ""; }
  std::string operator()(const repository::DatasetChoice& choice) const {
    const bool none = choice.how == repository::DatasetChoice::How::none;
    return "; default " + std::string{(none ? field.words.back() : field.words.front()).name};
  }
};

/// Placeholder for the flag's value in the help; numbers and texts need none.
const char* value_text(const Field& field) {
  switch (field.kind) {
    case Kind::word: return "WORD";
    case Kind::time: return "TIME";
    case Kind::duration: return "DURATION";
    case Kind::place:
    case Kind::places: return "LON,LAT";
    case Kind::dataset: return "ID";
    case Kind::datasets: return "ID,ID";
    default: return "";
  }
}

bool is_usual(const Field& field) { return field.usual && std::get<bool>(*field.usual); }

/// Description of a value's notation on the command line.
std::string form_of(const Field& field) {
  if (const OwnWay* own_way = own_way_of(field)) return "; " + std::string{own_way->text};
  std::string words;
  switch (field.kind) {
    case Kind::number:
    case Kind::whole_number: return range_text(field);
    case Kind::word:
      for (const fields::Word& word : field.words)
        words += (words.empty() ? ": " : ", ") + std::string{word.name};
      return words;
    case Kind::place: return "; for example " + flag_of(field) + "=-53.20,69.20";
    case Kind::places: return "; may be repeated; for example " + flag_of(field) + "=-52.50,69.10";
    case Kind::datasets: return "";
    default: return "";
  }
}

/// What holds if a flag without a default in its field is not given, and else an example of its value.
std::string without_flag(const Field& field) {
  for (const std::string_view said : {"for example", "default", "without"})
    if (field.help.find(said) != std::string_view::npos) return "";
  if (field.kind == Kind::place || field.kind == Kind::places) return "";
  const std::string blank = field.form.blank.empty() ? "" : "; default: " + std::string{field.form.blank};
  if (field.kind == Kind::time) return "; for example 2026-11-20T06:00:00Z" + blank;
  if (!blank.empty()) return blank;
  const bool is_number = field.kind == Kind::number || field.kind == Kind::whole_number;
  if (is_number && field.group == fields::group::vehicle) return "; default: that of the vehicle";
  return is_number && !field.example.empty() ? "; for example " + std::string{field.example} : "";
}

/// The help of a flag: "Kept below the deepest keel when passing under; metres, 0 to 1000; default 20".
std::string help_of(const Field& field) {
  std::string help{field.help};
  if (!field.flag_sets.empty()) return help + "; this flag chooses " + std::string{field.flag_sets};
  if (field.kind == Kind::boolean && is_usual(field)) {
    help.front() = static_cast<char>(std::tolower(help.front()));
    return "Do not " + help;
  }
  help += form_of(field);
  return help + (field.usual ? std::visit(UsualText{field}, *field.usual) : without_flag(field));
}

/// The value of a flag as a member of the inputs; null if the flag is not given.
struct Said {
  const Field& field;

  json operator()(bool given) const {
    if (!given) return {};
    return field.flag_sets.empty() ? json(!is_usual(field)) : json(field.flag_sets);
  }
  json operator()(const std::optional<int>& number) const { return number ? json(*number) : json(); }
  json operator()(const std::optional<double>& number) const {
    if (!number) return {};
    // JSON has no number that is not finite, and null would mean that the flag is not given.
    return std::isfinite(*number) ? json(*number) : json("a number that is not finite");
  }
  json operator()(const std::optional<std::string>& text) const {
    if (!text) return {};
    if (field.kind == Kind::place) return place_of(flag_of(field), *text);
    if (field.kind != Kind::datasets) return *text;
    const auto ids = split_at_commas(*text);
    return ids.size() == 1 ? json(ids.front()) : json(ids);
  }
  json operator()(const std::vector<std::string>& texts) const {
    if (texts.empty()) return {};
    json places = json::array();
    for (const std::string& text : texts) places.push_back(place_of(flag_of(field), text));
    return places;
  }
};

/// Adds a flag for a number, and the flag that sets the smallest number if the field has one.
CLI::Option* add_number(CLI::App& command, const Field& field, const std::string& help,
                        std::optional<double>& number) {
  std::string names = flag_of(field);
  if (!field.former_flag.empty()) names += ",--" + std::string{field.former_flag};
  CLI::Option* const option = command.add_option(names, number, help);
  if (field.unit == "s") option->transform(seconds_or_duration());
  if (field.none_flag.empty()) return option;
  command
      .add_flag_callback(
          "--" + std::string{field.none_flag}, [&number, least = field.least] { number = least; },
          "The same as " + flag_of(field) + " " + number_text(field.least))
      ->group(std::string{field.group})
      ->excludes(option);
  return option;
}

/// Sixteen times the server's default limit. Parsing a longer text takes seconds before its content could be
/// refused.
constexpr std::size_t most_bytes = 16UL * 1024 * 1024;

}  // namespace

json read_object(const std::string& file, const std::string& what) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw std::runtime_error{messages::command_text<"file-not-readable">(what, file)};
  std::string text(most_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > most_bytes) throw BadDataError{messages::command_text<"file-too-long">(what, file)};
  json object;
  try {
    object = json::parse(text);
  } catch (const json::out_of_range&) {
    throw BadDataError{messages::command_text<"file-with-endless-number">(what, file)};
  } catch (const json::parse_error& error) {
    throw BadDataError{messages::command_text<"file-not-json">(what, file, error.byte)};
  }
  // The parser accepts texts that the server refuses: repeated keys, and unlimited nesting.
  if (const auto checked = codec::parse_json(text); !checked)
    throw BadDataError{messages::command_text<"json-file-refused">(what, file, checked.error())};
  if (!object.is_object()) throw BadDataError{messages::command_text<"file-no-json-object">(what, file)};
  return object;
}

json file_member(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  std::string text{std::istreambuf_iterator<char>{stream}, {}};
  if (!stream && text.empty())
    throw std::runtime_error{messages::command_text<"file-not-readable">("file", file)};
  return {{"name", std::filesystem::path{file}.filename().string()}, {"text", std::move(text)}};
}

void InputFlags::add_request(CLI::App& command, const std::string& inputs) {
  command.add_option("--request", request_file_, "JSON file with " + inputs + "; for example request.json");
}

void InputFlags::add(CLI::App& command, const std::vector<Field>& list) {
  for (const Field& field : list) {
    if (field.flag.empty()) continue;
    Flag& flag = flags_.emplace_back(Flag{.field = field, .given = {}});
    const std::string name = flag_of(field);
    const std::string help = help_of(field);
    CLI::Option* option = nullptr;
    if (field.kind == Kind::boolean || !field.flag_sets.empty()) {
      option = command.add_flag(name, flag.given.emplace<bool>(), help);
    } else if (field.kind == Kind::places) {
      option = command.add_option(name, flag.given.emplace<std::vector<std::string>>(), help)
                   ->allow_extra_args(false);
    } else if (field.kind == Kind::whole_number) {
      option = command.add_option(name, flag.given.emplace<std::optional<int>>(), help);
    } else if (field.kind == Kind::number) {
      option = add_number(command, field, help, flag.given.emplace<std::optional<double>>());
    } else {
      option = command.add_option(name, flag.given.emplace<std::optional<std::string>>(), help);
    }
    if (field.flag_sets.empty()) option->option_text(value_text(field));
    if (!field.group.empty()) option->group(std::string{field.group});
  }
}

json InputFlags::inputs() const {
  json inputs = request_file_ ? read_object(*request_file_, "request file") : json::object();
  for (const Flag& flag : flags_) {
    const auto* text = std::get_if<std::optional<std::string>>(&flag.given);
    if (const OwnWay* own_way = own_way_of(flag.field); own_way != nullptr && text != nullptr) {
      if (*text) own_way->set(inputs, **text);
      continue;
    }
    json said = std::visit(Said{flag.field}, flag.given);
    if (said.is_null()) continue;
    const std::string name{flag.field.name};
    if (flag.field.object.empty()) {
      inputs[name] = std::move(said);
    } else {
      set_inside(inputs, std::string{flag.field.object}, name, std::move(said));
    }
  }
  return inputs;
}

}  // namespace floeplan::cli
