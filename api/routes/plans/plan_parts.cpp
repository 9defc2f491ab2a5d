#include "api/codec/features/plan_feature.hpp"
#include "api/routes/features/feature_collection.hpp"
#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::PlanRecord;
using repository::PlanRepository;

// The key of a part is the plan's row times this number plus the part's index; a plan has at most 10,000
// waypoints.
constexpr std::int64_t most_parts = 16'384;
constexpr int plans_at_once = 100;
/// If the filter matches more plans, their parts are not counted.
constexpr std::int64_t most_plans_counted = 1000;

using PartsOf = std::vector<codec::PlanPart> (*)(const PlanRecord&);

bool meets(const codec::PlanPart& part, const FeatureQuery& query) {
  if (query.span.from && part.end < *query.span.from) return false;
  if (query.span.to && part.begin > *query.span.to) return false;
  return !query.area || geo::intersects(*query.area, part.bounds);
}

/// A page of the parts of all plans, or of the requested plan, plan after plan.
FeaturePage parts_page(const Context& context, const FeatureQuery& query, PartsOf parts_of) {
  const PlanRepository plans{context.db};
  repository::PlanFilter filter{.area = query.area, .from = query.span.from, .to = query.span.to};
  if (const auto found = query.filters.find("plan_id"); found != query.filters.end())
    filter.id = repository::PlanId{found->second};
  bool counted = false;
  (void)sql::meets_no_damage([&] { counted = plans.count(filter) <= most_plans_counted; });

  FeaturePage page;
  if (counted) page.matched = 0;
  std::int64_t row = counted ? 0 : query.after / most_parts - 1;
  while (true) {
    const auto some = plans.list_past_damage(filter, row, plans_at_once);
    page.damaged.insert(page.damaged.end(), some.damaged.begin(), some.damaged.end());
    for (const PlanRecord& plan : some.whole) {
      const auto parts = parts_of(plan);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::int64_t key = plan.row * most_parts + static_cast<std::int64_t>(i) + 1;
        if (!meets(parts[i], query)) continue;
        if (page.matched) ++*page.matched;
        if (key <= query.after || page.next) continue;
        page.features.push_back(parts[i].feature);
        if (std::ssize(page.features) == query.limit) page.next = key;
      }
    }
    if (std::ssize(some.whole) < plans_at_once || (page.next && !counted)) return page;
    row = some.whole.back().row;
  }
}

/// Finds a part by its id: the plan's id, a dot and the part's index.
std::optional<json> find_part(const Context& context, const std::string& id, PartsOf parts_of) {
  const auto dot = id.rfind('.');
  const auto index = dot == std::string::npos ? std::nullopt : key_of(id.substr(dot + 1));
  const auto plan = index ? PlanRepository{context.db}.find({id.substr(0, dot)}) : std::nullopt;
  if (!plan || *index < 0) return std::nullopt;
  auto parts = parts_of(*plan);
  if (*index >= std::ssize(parts)) return std::nullopt;
  return std::move(parts[static_cast<std::size_t>(*index)].feature);
}

FeatureExtent plan_part_extent(sql::Connection&) { return {}; }

tl::expected<FeaturePage, problems::Problem> list_legs(const Context& context, const FeatureQuery& query) {
  return parts_page(context, query, codec::plan_legs);
}
std::optional<json> find_leg(const Context& context, const std::string& id) {
  return find_part(context, id, codec::plan_legs);
}
tl::expected<FeaturePage, problems::Problem> list_waypoints(const Context& context,
                                                            const FeatureQuery& query) {
  return parts_page(context, query, codec::plan_waypoints);
}
std::optional<json> find_waypoint(const Context& context, const std::string& id) {
  return find_part(context, id, codec::plan_waypoints);
}

}  // namespace

FeatureCollection plan_leg_collection() {
  return {.id = "plan-legs",
          .title = "Legs of plans",
          .description = "From one waypoint of a plan to the next, with times, speed, depth and energy.",
          .schema = "PlanLeg",
          .item_name = "leg_id",
          .filters = {"plan_id"},
          .extent = plan_part_extent,
          .list = list_legs,
          .find = find_leg};
}

FeatureCollection waypoint_collection() {
  return {.id = "waypoints",
          .title = "Waypoints of plans",
          .description = "Where plans turn, and when.",
          .schema = "PlanWaypoint",
          .item_name = "waypoint_id",
          .filters = {"plan_id"},
          .extent = plan_part_extent,
          .list = list_waypoints,
          .find = find_waypoint};
}

}  // namespace floeplan::routes
