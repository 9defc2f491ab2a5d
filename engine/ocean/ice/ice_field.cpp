#include "engine/ocean/ice/ice_field.hpp"

#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "engine/ocean/grids/bilinear.hpp"

namespace floeplan::ocean {

IceField::IceField(Samples samples) : samples_{std::move(samples)} {
  const std::size_t wanted = samples_.grid.size() * samples_.times_s.size();
  const bool thickness_fits = samples_.thickness_m.empty() || samples_.thickness_m.size() == wanted;
  if (samples_.concentration.size() != wanted || !thickness_fits) {
    throw std::invalid_argument{
        "ice needs one concentration for each node and time, and as many thicknesses or none"};
  }
}

std::optional<IceState> IceField::at(geo::LonLat place, core::UtcTime time) const {
  if (!std::isfinite(place.lon_deg) || !std::isfinite(place.lat_deg) ||
      !std::isfinite(core::unix_seconds(time))) {
    throw std::invalid_argument{"ice was asked for at a place or time that is not finite"};
  }
  const auto position = samples_.grid.locate(place);
  const auto when = samples_.times_s.locate(core::unix_seconds(time));
  if (!position || !when) return std::nullopt;
  const core::Seconds apart{samples_.times_s[when->upper] - samples_.times_s[when->lower]};
  if (apart > longest_ice_gap) return std::nullopt;

  const std::size_t slice = samples_.grid.size();
  const auto value = [&](const std::vector<float>& all) -> std::optional<double> {
    const auto at_time = [&](std::size_t time_index) {
      return bilinear(std::span{all}.subspan(time_index * slice, slice), samples_.grid.x().size(), *position);
    };
    const auto before = at_time(when->lower);
    if (!before || when->fraction == 0.0) return before;
    const auto after = at_time(when->upper);
    if (!after) return std::nullopt;
    return *before + when->fraction * (*after - *before);
  };
  const auto concentration = value(samples_.concentration);
  if (!concentration) return std::nullopt;
  IceState state{.concentration = *concentration, .thickness = std::nullopt};
  if (!samples_.thickness_m.empty()) {
    if (const auto thickness_m = value(samples_.thickness_m)) state.thickness = core::Metres{*thickness_m};
  }
  return state;
}

}  // namespace floeplan::ocean
