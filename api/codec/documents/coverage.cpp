#include "api/codec/documents/coverage.hpp"

#include <cmath>

#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

json values_json(const std::vector<std::optional<double>>& values) {
  json result = json::array();
  for (const auto& value : values) {
    // Rounded to 1e-4, which is finer than all data (0.1 mm or 0.1 mm/s).
    result.push_back(value ? json(std::round(*value * 1e4) / 1e4) : json());
  }
  return result;
}

json times_json(const std::vector<core::UtcTime>& times) {
  json result = json::array();
  for (const auto time : times) result.push_back(core::iso8601(time));
  return result;
}

json referencing(bool has_z, bool has_t) {
  json systems = json::array();
  systems.push_back(
      {{"coordinates", {"x", "y"}},
       {"system", {{"type", "GeographicCRS"}, {"id", "http://www.opengis.net/def/crs/OGC/1.3/CRS84"}}}});
  if (has_z) {
    const json axis{
        {"name", {{"en", "depth below the surface"}}}, {"direction", "down"}, {"unit", {{"symbol", "m"}}}};
    systems.push_back({{"coordinates", json::array({"z"})},
                       {"system", {{"type", "VerticalCRS"}, {"cs", {{"csAxes", json::array({axis})}}}}}});
  }
  if (has_t) {
    systems.push_back({{"coordinates", json::array({"t"})},
                       {"system", {{"type", "TemporalRS"}, {"calendar", "Gregorian"}}}});
  }
  return systems;
}

json parameters_json(const std::vector<CoverageParameter>& parameters) {
  json result = json::object();
  for (const auto& parameter : parameters) result[parameter.id] = parameter_json(parameter);
  return result;
}

json ranges_json(const std::vector<CoverageParameter>& parameters,
                 const std::vector<std::vector<std::optional<double>>>& values, const json& axis_names,
                 const json& shape) {
  json ranges = json::object();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    json range{{"type", "NdArray"}, {"dataType", "float"}};
    if (!axis_names.empty()) {
      range["axisNames"] = axis_names;
      range["shape"] = shape;
    }
    range["values"] = values_json(values[i]);
    ranges[parameters[i].id] = std::move(range);
  }
  return ranges;
}

json source_json(const CoverageSource& source) {
  json result{{"dataset_id", source.dataset_id}, {"dataset_name", source.dataset_name}};
  if (!source.further_ids.empty()) result["further_dataset_ids"] = source.further_ids;
  if (!source.sampling.empty()) result["sampling"] = source.sampling;
  return result;
}

std::string domain_type(const CoverageGrid& grid) {
  const bool one_place = grid.x_deg.size() == 1 && grid.y_deg.size() == 1;
  if (!one_place || (grid.t.size() > 1 && grid.z_m.size() > 1)) return "Grid";
  if (grid.t.size() > 1) return "PointSeries";
  return grid.z_m.size() > 1 ? "VerticalProfile" : "Point";
}

}  // namespace

json parameter_json(const CoverageParameter& parameter) {
  return {{"type", "Parameter"},
          {"description", parameter.label},
          {"unit",
           {{"label", parameter.unit},
            {"symbol", {{"value", parameter.unit}, {"type", "http://www.opengis.net/def/uom/UCUM/"}}}}},
          {"observedProperty",
           {{"id", "https://vocab.nerc.ac.uk/standard_name/" + parameter.id}, {"label", parameter.label}}}};
}

json coverage_json(const CoverageGrid& grid) {
  const std::string type = domain_type(grid);
  json axes{{"x", {{"values", grid.x_deg}}}, {"y", {{"values", grid.y_deg}}}};
  json axis_names = json::array();
  json shape = json::array();
  const auto add = [&](const char* name, std::size_t size, bool always) {
    if (size == 0 || (type != "Grid" && !always)) return;
    axis_names.push_back(name);
    shape.push_back(size);
  };
  add("t", grid.t.size(), type == "PointSeries");
  add("z", grid.z_m.size(), type == "VerticalProfile");
  add("y", grid.y_deg.size(), false);
  add("x", grid.x_deg.size(), false);
  if (!grid.z_m.empty()) axes["z"] = {{"values", grid.z_m}};
  if (!grid.t.empty()) axes["t"] = {{"values", times_json(grid.t)}};
  json coverage{{"type", "Coverage"},
                {"domain",
                 {{"type", "Domain"},
                  {"domainType", type},
                  {"axes", std::move(axes)},
                  {"referencing", referencing(!grid.z_m.empty(), !grid.t.empty())}}},
                {"parameters", parameters_json(grid.parameters)},
                {"ranges", ranges_json(grid.parameters, grid.values, axis_names, shape)}};
  if (!grid.source.dataset_id.empty()) coverage["source"] = source_json(grid.source);
  return coverage;
}

json coverage_json(const CoverageTrajectory& trajectory) {
  const bool has_z = trajectory.places.front().z_m.has_value();
  const bool has_t = trajectory.places.front().time.has_value();
  json coordinates = json::array();
  if (has_t) coordinates.push_back("t");
  coordinates.push_back("x");
  coordinates.push_back("y");
  if (has_z) coordinates.push_back("z");
  json tuples = json::array();
  for (const auto& place : trajectory.places) {
    json tuple = json::array();
    if (has_t) tuple.push_back(core::iso8601(*place.time));
    tuple.push_back(place.place.lon_deg);
    tuple.push_back(place.place.lat_deg);
    if (has_z) tuple.push_back(*place.z_m);
    tuples.push_back(std::move(tuple));
  }
  const json composite{{"dataType", "tuple"}, {"coordinates", coordinates}, {"values", std::move(tuples)}};
  json coverage{{"type", "Coverage"},
                {"domain",
                 {{"type", "Domain"},
                  {"domainType", "Trajectory"},
                  {"axes", {{"composite", composite}}},
                  {"referencing", referencing(has_z, has_t)}}},
                {"parameters", parameters_json(trajectory.parameters)},
                {"ranges", ranges_json(trajectory.parameters, trajectory.values, json::array({"composite"}),
                                       json::array({trajectory.places.size()}))}};
  if (!trajectory.source.dataset_id.empty()) coverage["source"] = source_json(trajectory.source);
  return coverage;
}

json coverage_collection(std::vector<json> coverages) {
  return {{"type", "CoverageCollection"}, {"coverages", std::move(coverages)}};
}

}  // namespace floeplan::codec
