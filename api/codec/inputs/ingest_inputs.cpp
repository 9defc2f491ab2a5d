#include "api/codec/inputs/ingest_inputs.hpp"

#include <algorithm>
#include <limits>

#include "api/codec/reading/input_reader.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr std::size_t most_uploads = 1'000;

std::vector<std::string> read_uploads(InputReader& reader) {
  const json* ids = reader.member("uploads");
  std::vector<std::string> uploads;
  const bool listed = ids != nullptr && ids->is_array() && !ids->empty() && ids->size() <= most_uploads;
  if (!listed) {
    reader.refuse<"wrong-shape">("/uploads", "an array of 1 to 1000 ids of uploads; POST /uploads gives one");
    return uploads;
  }
  for (std::size_t i = 0; i < ids->size(); ++i) {
    const std::string pointer = "/uploads/" + std::to_string(i);
    if (!(*ids)[i].is_string()) {
      reader.refuse<"wrong-shape">(pointer, "the id of an upload, a text");
      continue;
    }
    auto id = (*ids)[i].get<std::string>();
    if (std::ranges::find(uploads, id) != uploads.end()) reader.refuse<"given-twice">(pointer);
    uploads.push_back(std::move(id));
  }
  return uploads;
}

/// A text that must be one of `values`; any other text is a violation.
std::optional<std::string> choice(InputReader& reader, const std::string& key,
                                  const std::vector<std::string>& values) {
  auto text = reader.text(key);
  if (!text || std::ranges::find(values, *text) != values.end()) return text;
  std::string all;
  for (const std::string& value : values) all += (all.empty() ? "" : ", ") + value;
  reader.refuse<"wrong-shape">("/" + key, "one of " + all);
  return std::nullopt;
}

}  // namespace

tl::expected<IngestInputs, core::Violations> parse_ingest_inputs(const json& document) {
  InputReader reader{document};
  IngestInputs inputs;
  constexpr double largest = std::numeric_limits<double>::max();
  inputs.uploads = read_uploads(reader);
  inputs.name = reader.text("name");
  const auto kind = choice(reader, "kind",
                           {"auto", "bathymetry", "currents", "ice", "icebergs", "coastline", "tides", "wind",
                            "water-levels", "zones", "glider-tracks"});
  if (kind && *kind != "auto") inputs.kind = repository::parse_kind(*kind);
  inputs.crs = reader.text("crs");
  inputs.positive = choice(reader, "positive", {"up", "down"});
  inputs.variable = reader.text("variable");
  inputs.missing = reader.number("missing", {-largest, largest});
  inputs.time = reader.time("time");
  inputs.at = reader.place("at");
  inputs.unit = choice(reader, "unit", {"m", "cm", "mm", "ft", "share", "percent"});
  inputs.zone_kind = choice(reader, "zone_kind", {"no_go", "stay_in"});
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());
  return inputs;
}

json to_json(const IngestInputs& inputs) {
  json document{{"uploads", inputs.uploads}};
  if (inputs.name) document["name"] = *inputs.name;
  if (inputs.kind) document["kind"] = repository::kind_name(*inputs.kind);
  if (inputs.crs) document["crs"] = *inputs.crs;
  if (inputs.positive) document["positive"] = *inputs.positive;
  if (inputs.variable) document["variable"] = *inputs.variable;
  if (inputs.missing) document["missing"] = *inputs.missing;
  if (inputs.time) document["time"] = core::iso8601(*inputs.time);
  if (inputs.at) document["at"] = {inputs.at->lon_deg, inputs.at->lat_deg};
  if (inputs.unit) document["unit"] = *inputs.unit;
  if (inputs.zone_kind) document["zone_kind"] = *inputs.zone_kind;
  return document;
}

}  // namespace floeplan::codec
