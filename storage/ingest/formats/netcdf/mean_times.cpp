#include "storage/ingest/formats/netcdf/mean_times.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "engine/core/units.hpp"
#include "engine/messages/ingest_netcdf_messages.hpp"
#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/notation/cf_time.hpp"

namespace floeplan::ingest {
namespace {

bool is_mean_over(const NetcdfVariable& variable, const NetcdfVariable& time) {
  return std::ranges::any_of(cell_methods_of(variable), [&](const CellMethod& cell) {
    const bool over_years = cell.where.size() > 1 && cell.where[0] == "over" && cell.where[1] == "years";
    return cell.method == "mean" && !over_years &&
           std::ranges::any_of(
               cell.axes, [&](const std::string& axis) { return axis == "time" || axis == time.name(); });
  });
}

}  // namespace

Checked<AxisNodes> times_of_means(const NetcdfFile& file, const NetcdfVariable& variable,
                                  const NetcdfVariable& coordinate, AxisNodes stated, Messages& warnings) {
  constexpr double most_moved_s = 1.0;  // files round their times by less than this
  const NetcdfVariable* bounds = file.find(coordinate.attribute("bounds"));
  if (bounds == nullptr || !is_mean_over(variable, coordinate)) return stated;
  // Bounds have the unit and the calendar of their coordinate. Their own attributes only repeat these, and
  // are often incomplete.
  const auto decoder = CfTime::parse(coordinate.attribute("units"), coordinate.attribute("calendar"));
  if (!decoder) return refuse(decoder.error());
  const auto edges = bounds->read_all();
  if (!edges) return refuse(edges.error());
  if (edges->size() != 2 * stated.nodes.size()) return stated;

  bool moved = false;
  for (std::size_t i = 0; i < stated.nodes.size(); ++i) {
    const std::size_t row = stated.source[i];
    const auto begins = decoder->at((*edges)[2 * row]);
    const auto ends = decoder->at((*edges)[2 * row + 1]);
    if (!begins || !ends) return refuse(begins ? ends.error() : begins.error());
    const double middle_s = (core::unix_seconds(*begins) + core::unix_seconds(*ends)) / 2.0;
    if (std::abs(middle_s - stated.nodes[i]) <= most_moved_s) continue;
    moved = true;
    stated.nodes[i] = middle_s;
  }
  if (!moved) return stated;
  if (!std::ranges::is_sorted(stated.nodes, std::less_equal{}))
    return refuse(messages::ingest_netcdf_message<"means-out-of-order">(bounds->name(), coordinate.name()));
  warnings.push_back(
      messages::ingest_netcdf_message<"means-placed-in-the-middle">(variable.name(), bounds->name()));
  return stated;
}

}  // namespace floeplan::ingest
