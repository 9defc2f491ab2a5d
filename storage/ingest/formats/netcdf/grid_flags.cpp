#include "storage/ingest/formats/netcdf/grid_flags.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/messages/ingest_netcdf_messages.hpp"

namespace floeplan::ingest {
namespace {

void warn_once(Messages& warnings, messages::Message told) {
  if (std::ranges::find(warnings, told) == warnings.end()) warnings.push_back(std::move(told));
}

std::optional<std::size_t> position_in(const NetcdfVariable& flags, const NetcdfDimension& dimension) {
  const auto& all = flags.dimensions();
  const auto found = std::ranges::find(all, dimension.name, &NetcdfDimension::name);
  if (found == all.end() || found->size != dimension.size) return std::nullopt;
  return static_cast<std::size_t>(found - all.begin());
}

/// The variable's layout, with the dimension numbers of its flags; empty if the flags lack one of the
/// variable's horizontal dimensions, or have one that it lacks.
std::optional<NetcdfLayout> layout_beside(const NetcdfVariable& flags, const NetcdfVariable& variable,
                                          const NetcdfLayout& layout) {
  const auto moved = [&](std::size_t dimension) {
    return position_in(flags, variable.dimensions()[dimension]);
  };
  const auto x = moved(layout.x_dimension);
  const auto y = moved(layout.y_dimension);
  if (!x || !y) return std::nullopt;
  NetcdfLayout beside = layout;
  beside.x_dimension = *x;
  beside.y_dimension = *y;
  if (layout.time_dimension) beside.time_dimension = moved(*layout.time_dimension);
  if (layout.depth_dimension) beside.depth_dimension = moved(*layout.depth_dimension);
  for (std::size_t i = 0; i < flags.dimensions().size(); ++i)
    if (flags.dimensions()[i].size > 1 && i != *x && i != *y && i != beside.time_dimension &&
        i != beside.depth_dimension)
      return std::nullopt;
  return beside;
}

}  // namespace

GridFlags::GridFlags(const NetcdfFile& file, const NetcdfVariable& variable, const NetcdfLayout& layout,
                     Messages& warnings) {
  for (QualityFlags& flags : flags_named_by(file, variable)) {
    auto beside = flags.variable->is_numeric() ? layout_beside(*flags.variable, variable, layout)
                                               : std::optional<NetcdfLayout>{};
    if (!beside) {
      warn_once(warnings, messages::ingest_netcdf_message<"flags-not-read">(
                              flags.variable->name(), variable.name(),
                              flags.variable->is_numeric() ? "do not lie on its nodes" : "are no numbers"));
      continue;
    }
    if (flags.remark) warn_once(warnings, *flags.remark);
    flags_.push_back({std::move(flags), std::move(*beside)});
  }
}

Checked<std::vector<bool>> GridFlags::bad_among(const std::vector<double>& values, std::size_t time,
                                                std::size_t level, FlagCount& count) const {
  std::vector<bool> bad(values.size(), false);
  std::vector<bool> doubtful(values.size(), false);
  for (const Flags& flags : flags_) {
    const auto worth = read_slice(*flags.meaning.variable, flags.layout, time, level);
    if (!worth) return refuse(worth.error());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isnan(values[i])) continue;
      if (flags.meaning.forbids((*worth)[i])) bad[i] = true;
      if (flags.meaning.doubts((*worth)[i])) doubtful[i] = true;
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (bad[i])
      ++count.bad;
    else if (doubtful[i])
      ++count.doubtful;
  }
  return bad;
}

}  // namespace floeplan::ingest
