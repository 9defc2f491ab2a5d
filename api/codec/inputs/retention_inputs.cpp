#include "api/codec/inputs/retention_inputs.hpp"

#include <array>
#include <cmath>

#include "api/codec/reading/input_reader.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using repository::DatasetKind;

constexpr double most_bytes = 1e15;
// Depths, coasts, tides and zones do not age.
constexpr std::array ageing{DatasetKind::currents,     DatasetKind::wind,     DatasetKind::ice,
                            DatasetKind::water_levels, DatasetKind::icebergs, DatasetKind::glider_tracks};

std::optional<std::int64_t> read_bytes(InputReader& reader) {
  const auto bytes = reader.number("max_bytes", {0.0, most_bytes});
  if (!bytes) return std::nullopt;
  if (*bytes == std::floor(*bytes)) return static_cast<std::int64_t>(*bytes);
  reader.refuse<"wrong-shape">("/max_bytes", "a whole number of bytes");
  return std::nullopt;
}

std::optional<DatasetKind> read_kind(InputReader& reader) {
  const auto name = reader.text("kind");
  if (!name || *name == "all") return std::nullopt;
  std::string known = "all";
  for (const DatasetKind kind : ageing) {
    if (repository::kind_name(kind) == *name) return kind;
    known += ", " + repository::kind_name(kind);
  }
  reader.refuse<"wrong-shape">("/kind", "one of " + known);
  return std::nullopt;
}

}  // namespace

tl::expected<RetentionInputs, core::Violations> parse_retention_inputs(const json& inputs) {
  if (!inputs.is_object())
    return tl::unexpected(core::Violations{messages::fault<"wrong-shape">("", "an object with rules")});
  InputReader reader{inputs};
  RetentionInputs read;
  read.rules.max_age = reader.duration("older_than");
  read.rules.max_bytes = read_bytes(reader);
  read.rules.kind = read_kind(reader);
  read.dry_run = reader.boolean("dry_run").value_or(false);
  reader.refuse_unknown();
  if (reader.violations().empty() && !read.rules.max_age && !read.rules.max_bytes)
    reader.refuse<"nothing-to-remove">("");
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());
  return read;
}

json retention_document(const std::vector<repository::StoredSize>& gone, bool dry_run) {
  json removed = json::array();
  for (const auto& each : gone) removed.push_back({{"id", each.dataset.id.value}, {"bytes", each.bytes}});
  return {{"removed", std::move(removed)}, {"dry_run", dry_run}};
}

}  // namespace floeplan::codec
