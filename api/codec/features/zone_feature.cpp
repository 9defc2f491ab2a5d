#include "api/codec/features/zone_feature.hpp"

#include "api/codec/inputs/zone_inputs.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

using nlohmann::json;

json zone_feature(const repository::StoredZone& stored) {
  json feature = areas_json({stored.zone}).at("features").at(0);
  feature["id"] = stored.row;
  feature["properties"]["dataset_id"] = stored.dataset.value;
  return feature;
}

tl::expected<ocean::Zone, core::Violations> parse_zone_feature(const json& feature) {
  const json wrapped{{"areas", feature}};
  InputReader reader{wrapped};
  auto zones = read_areas(reader);
  core::Violations violations = reader.violations();
  for (auto& violation : violations) violation.field.erase(0, std::string_view{"/areas"}.size());
  if (violations.empty() && zones.size() != 1)
    violations.push_back(messages::fault<"wrong-shape">("/geometry", "one Polygon; make a feature of each"));
  if (violations.empty()) violations = zones.front().violations();
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  return std::move(zones.front());
}

}  // namespace floeplan::codec
