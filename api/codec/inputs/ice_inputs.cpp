#include "api/codec/inputs/ice_inputs.hpp"

#include "api/codec/reading/input_fields.hpp"
#include "api/fields/request_fields.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr const char* under_ice = "under_ice";

/// Calls `read` with a reader of the members of `under_ice`.
void read_members(InputReader& reader, const auto& read) {
  const json* object = reader.member(under_ice);
  if (object == nullptr) return;
  InputReader members{*object};
  read(members);
  members.refuse_unknown();
  reader.refuse_all("/under_ice", members.violations());
}

}  // namespace

void read_iceberg_rules(InputReader& reader, planning::IcebergRules& rules,
                        repository::EnvironmentQuery& data) {
  read_fields(reader, fields::margin_fields(), rules);
  read_fields(reader, fields::iceberg_fields(), rules);
  read_fields(reader, fields::sighting_fields(), data);
  data.iceberg_drift = rules.drift;
}

void write_iceberg_rules(const planning::IcebergRules& rules, const repository::EnvironmentQuery& data,
                         json& inputs) {
  write_fields(fields::margin_fields(), rules, inputs);
  write_fields(fields::iceberg_fields(), rules, inputs);
  write_fields(fields::sighting_fields(), data, inputs);
}

void read_under_ice(InputReader& reader, planning::UnderIceRules& rules) {
  read_members(reader, [&](InputReader& members) {
    read_fields(members, fields::passing_under_ice_fields(), rules);
    read_fields(members, fields::surfacing_fields(), rules);
  });
}

void write_under_ice(const planning::UnderIceRules& rules, json& inputs) {
  write_passing_under_ice(rules, inputs);
  write_fields(fields::surfacing_fields(), rules, inputs[under_ice]);
}

void read_passing_under_ice(InputReader& reader, planning::UnderIceRules& rules) {
  read_members(
      reader, [&](InputReader& members) { read_fields(members, fields::passing_under_ice_fields(), rules); });
}

void write_passing_under_ice(const planning::UnderIceRules& rules, json& inputs) {
  write_fields(fields::passing_under_ice_fields(), rules, inputs[under_ice]);
}

}  // namespace floeplan::codec
