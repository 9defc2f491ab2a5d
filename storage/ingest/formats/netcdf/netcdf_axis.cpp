#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "engine/messages/ingest_netcdf_messages.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

AxisRole role_of_standard_name(const std::string& name) {
  if (name == "longitude") return AxisRole::longitude;
  if (name == "latitude") return AxisRole::latitude;
  if (name == "depth" || name == "height" || name == "altitude") return AxisRole::depth;
  if (name == "time") return AxisRole::time;
  if (name == "projection_x_coordinate") return AxisRole::projected_x;
  if (name == "projection_y_coordinate") return AxisRole::projected_y;
  if (contains_any(name, {"ocean_s", "ocean_sigma", "ocean_double_sigma"})) return AxisRole::model_level;
  const bool of_the_air = name.starts_with("atmosphere_") && name.ends_with("_coordinate");
  if (of_the_air || contains_any(name, {"model_level", "sea_floor", "pressure"}))
    return AxisRole::other_level;
  return AxisRole::unknown;
}

AxisRole role_of_name(const std::string& name) {
  if (name == "lon" || name == "longitude" || name == "long" || name == "nav_lon") return AxisRole::longitude;
  if (name == "lat" || name == "latitude" || name == "nav_lat") return AxisRole::latitude;
  if (name == "depth" || name == "lev" || name == "deptht" || name == "depthu" || name == "depthv")
    return AxisRole::depth;
  if (name == "time" || name == "ocean_time" || name == "time_counter" || name == "mt") return AxisRole::time;
  if (name == "x") return AxisRole::projected_x;
  if (name == "y") return AxisRole::projected_y;
  if (name.starts_with("s_rho") || name.starts_with("sig")) return AxisRole::model_level;
  return AxisRole::unknown;
}

std::optional<messages::Message> first_missing(const std::string& name, const std::vector<double>& values) {
  if (std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    return std::nullopt;
  return messages::ingest_netcdf_message<"axis-with-gaps">(name);
}

// Enough digits to show which values are out of order, or that a latitude is beyond a pole.
constexpr int digits = 12;

/// The range of all values as text: "-90.5 to 90".
std::string extent_text(const std::vector<double>& values) {
  const auto [least, greatest] = std::ranges::minmax(values);
  return number(least, digits) + " to " + number(greatest, digits);
}

AxisNodes in_file_order(std::vector<double> values) {
  AxisNodes axis{std::move(values), {}};
  axis.source.resize(axis.nodes.size());
  std::iota(axis.source.begin(), axis.source.end(), std::size_t{0});
  return axis;
}

}  // namespace

AxisRole role_of(const NetcdfVariable& coordinate) {
  if (const AxisRole role = role_of_standard_name(lower(coordinate.attribute("standard_name")));
      role != AxisRole::unknown)
    return role;

  const std::string unit = coordinate.attribute("units");
  if (is_degrees_east(unit)) return AxisRole::longitude;
  if (is_degrees_north(unit)) return AxisRole::latitude;
  if (contains_any(lower(unit), {" since "})) return AxisRole::time;
  if (is_pressure_unit(unit)) return AxisRole::other_level;

  const std::string axis = coordinate.attribute("axis");
  const std::string name = lower(coordinate.name());
  const AxisRole by_name = role_of_name(name);
  const bool is_length = length_factor(unit).has_value();
  if (by_name == AxisRole::depth && !unit.empty() && !is_length) return AxisRole::other_level;
  if (by_name != AxisRole::unknown) return by_name;
  if (axis == "T") return AxisRole::time;
  if (axis == "Z" || !coordinate.attribute("positive").empty())
    return is_length ? AxisRole::depth : AxisRole::other_level;
  if (axis == "X" && length_factor(unit)) return AxisRole::projected_x;
  if (axis == "Y" && length_factor(unit)) return AxisRole::projected_y;
  return AxisRole::unknown;
}

Checked<AxisNodes> monotonic_nodes(const std::string& name, std::vector<double> values) {
  if (values.empty())
    return refuse(messages::ingest_netcdf_message<"axis-empty">("the coordinate \"" + name + "\""));
  if (const auto missing = first_missing(name, values)) return refuse(*missing);

  AxisNodes axis = in_file_order(std::move(values));
  const bool falls = axis.nodes.front() > axis.nodes.back();
  if (falls) {
    std::reverse(axis.nodes.begin(), axis.nodes.end());
    std::reverse(axis.source.begin(), axis.source.end());
  }
  const auto disorder = std::adjacent_find(axis.nodes.begin(), axis.nodes.end(), std::greater_equal<>{});
  if (disorder != axis.nodes.end()) {
    const double one = falls ? *(disorder + 1) : *disorder;
    const double next = falls ? *disorder : *(disorder + 1);
    return refuse(messages::ingest_netcdf_message<"axis-out-of-order">(
        name, falls ? "fall" : "rise", number(one, digits), number(next, digits)));
  }
  return axis;
}

Checked<AxisNodes> longitude_nodes(const std::string& name, std::vector<double> values) {
  const std::vector<double> stated = values;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] < values[i - 1] && values[i - 1] - values[i] > 180.0) values[i] += 360.0;

  auto axis = monotonic_nodes(name, std::move(values));
  if (!axis) return axis;
  if (axis->nodes.front() < -540.0 || axis->nodes.back() > 720.0)
    return refuse(messages::ingest_netcdf_message<"longitudes-not-degrees">(name, extent_text(stated)));

  const double full_turn = axis->nodes.front() + 360.0 - 1e-6;
  while (axis->nodes.size() > 1 && axis->nodes.back() >= full_turn) {
    axis->nodes.pop_back();
    axis->source.pop_back();
  }
  return axis;
}

Checked<AxisNodes> latitude_nodes(const std::string& name, std::vector<double> values) {
  auto axis = monotonic_nodes(name, std::move(values));
  if (!axis) return axis;
  if (axis->nodes.front() < -90.0 - 1e-6 || axis->nodes.back() > 90.0 + 1e-6)
    return refuse(
        messages::ingest_netcdf_message<"latitudes-beyond-the-poles">(name, extent_text(axis->nodes)));
  axis->nodes.front() = std::max(axis->nodes.front(), -90.0);
  axis->nodes.back() = std::min(axis->nodes.back(), 90.0);
  return axis;
}

Checked<AxisNodes> sorted_nodes(const std::string& name, std::vector<double> values) {
  if (values.empty())
    return refuse(messages::ingest_netcdf_message<"axis-empty">("the time axis \"" + name + "\""));
  AxisNodes axis = in_file_order(std::move(values));
  const std::vector<double> unsorted = axis.nodes;
  std::sort(axis.source.begin(), axis.source.end(),
            [&](std::size_t a, std::size_t b) { return unsorted[a] < unsorted[b]; });
  std::transform(axis.source.begin(), axis.source.end(), axis.nodes.begin(),
                 [&](std::size_t i) { return unsorted[i]; });
  if (std::adjacent_find(axis.nodes.begin(), axis.nodes.end()) != axis.nodes.end())
    return refuse(messages::ingest_netcdf_message<"times-twice">(name));
  return axis;
}

}  // namespace floeplan::ingest
