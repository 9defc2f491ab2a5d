#include "api/routes/mission_service.hpp"

#include <nlohmann/json.hpp>

#include "api/codec/plan_document.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::routes {

tl::expected<mission::GotoLists, core::Violations> mission_of(const repository::PlanRecord& record,
                                                              int number, core::UtcTime generated) {
  const planning::Plan plan = codec::parse_plan_document(nlohmann::json::parse(record.document_json));
  mission::GotoListOptions options;
  options.first_number = number;
  if (const auto profile = vehicle::find_profile(plan.vehicle))
    options.max_waypoints = profile->max_waypoints_per_list;
  options.plan_id = record.id.value;
  options.plan_name = record.name;
  options.generated = generated;
  options.written_by = "floeplan " FLOEPLAN_VERSION;
  return mission::write_goto_lists(plan, options);
}

}  // namespace floeplan::routes
