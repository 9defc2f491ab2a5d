#include "api/codec/documents/dataset_document.hpp"

#include "api/codec/bytes/document_values.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
nlohmann::json dataset_document(const repository::Dataset& dataset, const std::vector<core::UtcTime>& times,
                                std::span<const repository::Dataset> all) {
  const auto& bounds = dataset.bounds;
  nlohmann::json document{{"id", dataset.id.value},
                          {"kind", repository::kind_name(dataset.kind)},
                          {"name", dataset.name},
                          {"variables", dataset.variables},
                          {"bbox", {bounds.west_deg, bounds.south_deg, bounds.east_deg, bounds.north_deg}},
                          {"time_start", optional_time(dataset.time_start)},
                          {"time_end", optional_time(dataset.time_end)},
                          {"run", optional_time(dataset.run)},
                          {"rows_accepted", dataset.rows_accepted},
                          {"rows_refused", dataset.rows_refused},
                          {"warnings", dataset.warnings},
                          {"file_name", dataset.provenance.file_name},
                          {"file_size_bytes", dataset.provenance.file_size_bytes},
                          {"sha256", dataset.provenance.sha256},
                          {"ingested", core::iso8601(dataset.provenance.ingested)},
                          {"tool_version", dataset.provenance.tool_version}};
  if (const auto stale = repository::stale_mark(dataset, all)) {
    document["stale"] = stale->text;
    if (stale->better) document["better_id"] = stale->better->value;
  }
  if (repository::has_steps(dataset.kind)) {
    auto& listed = document["times"] = nlohmann::json::array();
    if (times.size() <= max_listed_times) {
      for (const auto time : times) listed.push_back(core::iso8601(time));
    }
  }
  return document;
}

nlohmann::json dataset_refs_json(const std::vector<ocean::DatasetRef>& datasets) {
  nlohmann::json result = nlohmann::json::array();
  for (const auto& dataset : datasets) {
    result.push_back(
        {{"id", dataset.id}, {"kind", dataset.kind}, {"name", dataset.name}, {"sha256", dataset.sha256}});
    const auto add = [&](const char* key, const std::optional<core::UtcTime>& time) {
      if (time) result.back()[key] = core::iso8601(*time);
    };
    add("run", dataset.run);
    add("from", dataset.from);
    add("until", dataset.until);
  }
  return result;
}

ocean::DatasetRef parse_dataset_ref(const nlohmann::json& document) {
  const auto text = [&](const char* key) { return document.at(key).get<std::string>(); };
  const auto time = [&](const char* key) {
    return document.contains(key) ? core::parse_iso8601(text(key)) : std::nullopt;
  };
  return {text("id"), text("kind"), text("name"), text("sha256"), time("run"), time("from"), time("until")};
}

}  // namespace floeplan::codec
