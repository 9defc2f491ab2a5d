#include "api/codec/iceberg_inputs.hpp"

#include <nlohmann/json.hpp>

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr double day_s = 86'400.0;

}  // namespace

void read_iceberg_rules(InputReader& reader, planning::IcebergRules& rules,
                        repository::EnvironmentQuery& data) {
  if (const auto margin = reader.number("margin_m", {0.0, 100'000.0})) rules.margin = {*margin};
  if (const auto drift = reader.boolean("icebergs_drift")) rules.drift = *drift;
  if (const auto most = reader.number("max_inflation_m", {0.0, 100'000.0})) rules.max_inflation = {*most};
  if (const auto days = reader.number("max_sighting_age_days", {0.0, 30.0})) {
    data.max_sighting_age = core::Seconds{*days * day_s};
  }
  data.iceberg_drift = rules.drift;
}

void write_iceberg_rules(const planning::IcebergRules& rules, const repository::EnvironmentQuery& data,
                         json& inputs) {
  inputs["margin_m"] = rules.margin.value;
  inputs["icebergs_drift"] = rules.drift;
  inputs["max_inflation_m"] = rules.max_inflation.value;
  inputs["max_sighting_age_days"] = data.max_sighting_age.count() / day_s;
}

}  // namespace floeplan::codec
