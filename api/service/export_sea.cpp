#include "api/service/export_sea.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "storage/json/json.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::service {
namespace {

using nlohmann::json;
using repository::DatasetChoice;
using repository::EnvironmentQuery;

/// Area around a safe place: large enough for neighbouring nodes of a coarse ice grid, the coast, and
/// icebergs that may drift to it. The size is a judgement.
constexpr core::Metres around_place{10'000.0};

/// A query of the area without currents, wind and zones.
EnvironmentQuery without_motion(const geo::BoundingBox& area, core::UtcTime depart) {
  const DatasetChoice none{DatasetChoice::How::none, {}};
  EnvironmentQuery query;
  query.area = area;
  query.depart = depart;
  query.currents = none;
  query.wind = none;
  query.icebergs = none;
  query.zones = none;
  return query;
}

/// The ice of a product at a time that it describes: within its steps, or at the step that is held.
struct IceThen {
  std::shared_ptr<const ocean::IceField> ice;
  ocean::IceStanding standing{};
  core::UtcTime time;
};

/// The products that describe the time, the best first.
std::vector<IceThen> ice_then(const ocean::Environment& sea, core::UtcTime time) {
  std::vector<IceThen> products;
  const auto add = [&](const std::shared_ptr<const ocean::IceField>& ice) {
    if (!ice) return;
    const auto& steps_s = ice->samples().times_s.nodes();
    const double time_s = core::unix_seconds(time);
    const auto moment = ocean::ice_moment(steps_s, time_s);
    if (moment.is_known())
      products.push_back({ice, moment.standing,
                          core::from_unix_seconds(std::clamp(time_s, steps_s.front(), steps_s.back()))});
  };
  add(sea.ice);
  for (const auto& ice : sea.further_ice) add(ice);
  std::ranges::stable_sort(products, std::ranges::greater{}, &IceThen::standing);
  return products;
}

}  // namespace

std::optional<codec::PlanInputs> inputs_of(const repository::PlanRecord& record) {
  auto inputs = codec::parse_plan_inputs(json::parse(record.request_json));
  if (!inputs) return std::nullopt;
  codec::cover_way(*inputs, record.bounds);
  return std::move(*inputs);
}

vehicle::GliderProfile vehicle_of(const repository::PlanRecord& record, const planning::Plan& plan) {
  if (const auto inputs = inputs_of(record)) return inputs->request.vehicle;
  return vehicle::find_profile(plan.vehicle).value_or(vehicle::known_profiles().front());
}

std::vector<std::optional<mission::Shoal>> shoals_of(sql::Connection& db,
                                                     const repository::PlanRecord& record,
                                                     const planning::Plan& plan) {
  const auto inputs = inputs_of(record);
  if (!inputs) return {};
  EnvironmentQuery query = without_motion(inputs->data.area, plan.departure);
  query.bathymetry = inputs->data.bathymetry;
  query.ice = {DatasetChoice::How::none, {}};
  query.coastline = {DatasetChoice::How::none, {}};
  const auto sea = repository::load_environment(db, query);
  if (!sea || !sea->bathymetry) return {};
  return mission::shoals_along(*sea->bathymetry, plan);
}

mission::HoldOptions holds_of(sql::Connection& db, const repository::PlanRecord& record,
                              const planning::Plan& plan) {
  mission::HoldOptions holds;
  const auto inputs = inputs_of(record);
  if (!inputs) return holds;
  holds.radius = inputs->request.holds.radius;
  holds.vehicle = inputs->request.vehicle;
  if (!mission::has_holds(plan)) return holds;
  EnvironmentQuery query = inputs->data;
  const DatasetChoice none{DatasetChoice::How::none, {}};
  for (DatasetChoice* choice :
       {&query.bathymetry, &query.ice, &query.coastline, &query.icebergs, &query.zones})
    *choice = none;
  query.depart = plan.departure;
  const auto sea = repository::load_environment(db, query);
  if (sea) holds.currents = mission::hold_currents(*sea, plan, holds.vehicle);
  return holds;
}

std::optional<codec::SeaIce> sea_ice_of(sql::Connection& db, const repository::PlanRecord& record,
                                        const planning::Plan& plan, const geo::BoundingBox& area) {
  EnvironmentQuery query = without_motion(area, plan.departure);
  const DatasetChoice none{DatasetChoice::How::none, {}};
  query.bathymetry = none;
  query.coastline = none;
  query.ice = {DatasetChoice::How::named, {}};
  for (const auto& used : plan.datasets)
    if (used.kind == "ice" && repository::DatasetRepository{db}.find({used.id}))
      query.ice.ids.push_back({used.id});
  if (query.ice.ids.empty()) return std::nullopt;
  const auto sea = repository::load_environment(db, query);
  if (!sea) return std::nullopt;
  auto products = ice_then(*sea, plan.departure);
  if (products.empty()) return std::nullopt;
  const auto inputs = inputs_of(record);
  const auto rules = inputs ? inputs->request.under_ice : planning::UnderIceRules{};
  return codec::SeaIce{[products = std::move(products)](geo::LonLat place) -> std::optional<double> {
                         for (const IceThen& product : products)
                           if (const auto state = product.ice->at(place, product.time))
                             return state->concentration;
                         return std::nullopt;
                       },
                       rules.max_concentration_to_surface};
}

std::vector<mission::SafePlace> safe_places_of(sql::Connection& db, const repository::PlanRecord& record,
                                               const planning::Plan& plan,
                                               const std::vector<geo::LonLat>& places) {
  const auto inputs = inputs_of(record);
  std::vector<mission::SafePlace> found;
  for (const geo::LonLat place : places) {
    const geo::BoundingBox here{place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg};
    EnvironmentQuery query = without_motion(geo::grown(here, around_place), plan.departure);
    query.icebergs = {};
    if (inputs) {
      query.max_sighting_age = inputs->data.max_sighting_age;
      query.icebergs_as_of = repository::sightings_as_of(inputs->data);
    }
    query.iceberg_drift = false;
    query.zones = {};
    auto sea = repository::load_environment(db, query);
    found.push_back({place, sea ? std::move(*sea) : ocean::Environment{}});
  }
  return found;
}

}  // namespace floeplan::service
