#include "api/codec/iceberg_inputs.hpp"

#include "storage/json/json.hpp"

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
  if (const auto under = reader.boolean("pass_under_icebergs")) rules.pass_under = *under;
  if (const auto clearance = reader.number("keel_clearance_m", {0.0, 1000.0}))
    rules.keel_clearance = {*clearance};
  if (const auto share = reader.number("draft_uncertainty", {0.0, 2.0})) rules.draft_uncertainty = *share;
}

void write_iceberg_rules(const planning::IcebergRules& rules, const repository::EnvironmentQuery& data,
                         json& inputs) {
  inputs["margin_m"] = rules.margin.value;
  inputs["icebergs_drift"] = rules.drift;
  inputs["max_inflation_m"] = rules.max_inflation.value;
  inputs["pass_under_icebergs"] = rules.pass_under;
  inputs["keel_clearance_m"] = rules.keel_clearance.value;
  inputs["draft_uncertainty"] = rules.draft_uncertainty;
  inputs["max_sighting_age_days"] = data.max_sighting_age.count() / day_s;
}

}  // namespace floeplan::codec
