#include "api/codec/data_inputs.hpp"

#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using How = repository::DatasetChoice::How;

constexpr std::size_t max_ensemble = 64;

constexpr const char* newest = "newest";
constexpr const char* all = "all";

/// The choice without a word (`absent`); `unnamed`, which leaves it to the kind; "none"; an id; or (where `several`) an
/// array of ids.
repository::DatasetChoice read_choice(InputReader& reader, const std::string& key, bool several,
                                      repository::DatasetChoice absent = {},
                                      const std::string& unnamed = newest) {
  const json* value = reader.member(key);
  if (value == nullptr) return absent;
  const std::string rule = "must be \"" + unnamed + "\", \"none\"" +
                           (several ? ", an id or an array of ids, not " : " or an id, not ");
  if (value->is_string()) {
    const auto& text = value->get_ref<const std::string&>();
    if (text == unnamed) return {How::newest, {}};
    if (text == "none") return {How::none, {}};
    return {How::named, {{text}}};
  }
  repository::DatasetChoice choice{How::named, {}};
  if (several && value->is_array() && value->size() > max_ensemble) {
    reader.refuse("/" + key, "must have at most " + std::to_string(max_ensemble) + " ids, not " +
                                 std::to_string(value->size()));
    return {};
  }
  if (!several || !value->is_array() || value->empty()) {
    reader.refuse("/" + key, rule + shown(*value));
    return {};
  }
  for (std::size_t i = 0; i < value->size(); ++i) {
    const json& id = (*value)[i];
    if (id.is_string()) {
      choice.ids.push_back({id.get<std::string>()});
    } else {
      reader.refuse("/" + key + "/" + std::to_string(i), "must be the id of a dataset, not " + shown(id));
    }
  }
  return choice;
}

json choice_json(const repository::DatasetChoice& choice, const char* otherwise = newest) {
  if (choice.how == How::newest) return otherwise;
  if (choice.how == How::none) return "none";
  if (choice.ids.size() == 1) return choice.ids.front().value;
  json ids = json::array();
  for (const auto& id : choice.ids) ids.push_back(id.value);
  return ids;
}

std::optional<repository::TidesMode> read_tides_mode(InputReader& reader) {
  const auto text = reader.text("tides_mode");
  if (!text) return std::nullopt;
  if (*text == "add") return repository::TidesMode::add;
  if (*text == "only") return repository::TidesMode::only;
  reader.refuse("/tides_mode",
                "must be \"add\" (to currents without tides) or \"only\" (tidal currents alone), not \"" +
                    *text + "\"");
  return std::nullopt;
}

json tides_mode_json(const std::optional<repository::TidesMode>& mode) {
  if (!mode) return {};
  return *mode == repository::TidesMode::add ? "add" : "only";
}

}  // namespace

void read_data(InputReader& reader, repository::EnvironmentQuery& data) {
  data.currents = read_choice(reader, "currents", true);
  data.steady = reader.boolean("steady").value_or(false);
  data.tides.choice = read_choice(reader, "tides", true, {How::none, {}});
  data.tides.mode = read_tides_mode(reader);
  data.wind = read_choice(reader, "wind", false);
  data.bathymetry = read_choice(reader, "bathymetry", true);
  data.ice = read_choice(reader, "ice", false);
  data.icebergs = read_choice(reader, "icebergs", true);
  data.icebergs_as_of = reader.time("icebergs_as_of");
  data.coastline = read_choice(reader, "coastline", false);
  data.zones = read_choice(reader, "zones", true, {}, all);
}

void write_data(const repository::EnvironmentQuery& data, json& inputs) {
  inputs["currents"] = choice_json(data.currents);
  inputs["steady"] = data.steady;
  inputs["tides"] = choice_json(data.tides.choice);
  inputs["tides_mode"] = tides_mode_json(data.tides.mode);
  inputs["wind"] = choice_json(data.wind);
  inputs["bathymetry"] = choice_json(data.bathymetry);
  inputs["ice"] = choice_json(data.ice);
  inputs["icebergs"] = choice_json(data.icebergs);
  inputs["icebergs_as_of"] = data.icebergs_as_of ? json(core::iso8601(*data.icebergs_as_of)) : json();
  inputs["coastline"] = choice_json(data.coastline);
  inputs["zones"] = choice_json(data.zones, all);
}

}  // namespace floeplan::codec
