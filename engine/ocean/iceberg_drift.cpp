#include "engine/ocean/iceberg_drift.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>

#include "engine/geo/geodesic.hpp"
#include "engine/ocean/ice/iceberg_draft.hpp"
#include "engine/ocean/ice/iceberg_wind.hpp"

namespace floeplan::ocean {
namespace {

constexpr core::Seconds hour{3600.0};
/// Weather that pushed a berg aside lasts about this long.
constexpr core::Seconds fading{24.0 * 3600.0};
/// Shortest and longest time between two sightings from which a drift is derived. Sightings closer in time
/// show mainly their own errors (kilometres). Sightings further apart show past weather instead of the drift
/// of the next day.
constexpr core::Seconds shortest_observation{6.0 * 3600.0};
constexpr core::Seconds longest_observation{72.0 * 3600.0};
/// Greatest speed of a drift. A berg that seems to drift faster than any current is two bergs with one name.
constexpr core::MetresPerSecond fastest_drift{2.0};

geo::VelocityEn mean_velocity(const IcebergFix& from, const IcebergFix& to) {
  const geo::GeodesicLine line = geo::geodesic_between(from.place, to.place);
  const core::MetresPerSecond speed{line.length.value / (to.time - from.time).count()};
  return {line.course_at_start.east() * speed, line.course_at_start.north() * speed};
}

/// The drift from an earlier sighting, long enough before, to the last one.
struct ObservedDrift {
  IcebergFix from;
  geo::VelocityEn velocity;
};

std::optional<ObservedDrift> observed_drift(const Iceberg& iceberg) {
  const IcebergFix last{iceberg.place, iceberg.observed};
  for (const IcebergFix& fix : std::views::reverse(iceberg.earlier)) {
    const core::Seconds span = last.time - fix.time;
    if (span < shortest_observation) continue;
    if (span > longest_observation) return std::nullopt;
    const geo::VelocityEn velocity = mean_velocity(fix, last);
    if (geo::strength(velocity) > fastest_drift) return std::nullopt;
    return ObservedDrift{fix, velocity};
  }
  return std::nullopt;
}

/// The currents that move icebergs; null: none.
const CurrentGrid* carrying(const Environment& environment) {
  return environment.drift_currents ? environment.drift_currents.get() : environment.currents.get();
}

geo::LonLat moved(geo::LonLat from, geo::VelocityEn velocity, core::Seconds duration) {
  const core::Metres distance{geo::strength(velocity).value * duration.count()};
  return geo::geodesic_destination(from, geo::Bearing::towards(velocity.east.value, velocity.north.value),
                                   distance);
}

/// The forces on one iceberg, and the velocity that they give it.
class Drift {
 public:
  Drift(const Iceberg& iceberg, const Environment& environment)
      : environment_{environment},
        draft_{drift_draft(iceberg)},
        length_{safe_length(iceberg)},
        last_{iceberg.place, iceberg.observed},
        observed_{observed_drift(iceberg)} {
    if (observed_) besides_forces_ = besides_forces(*observed_);
  }

  [[nodiscard]] geo::VelocityEn velocity(const IcebergFix& at) const {
    const auto current = over_draft(at);
    const auto wind = by_wind(at);
    if (!current && observed_) return observed_->velocity;
    const geo::VelocityEn forced = sum(current.value_or(geo::VelocityEn{}), wind.value_or(geo::VelocityEn{}));
    // If the wind during the observed drift is unknown, it is part of the remainder. It must not be added a
    // second time.
    if (!current || (wind && !wind_was_known_)) return forced;
    const double left = std::exp(-((at.time - last_.time) / fading));
    return {forced.east + left * besides_forces_.east, forced.north + left * besides_forces_.north};
  }

  /// The end of a step that begins at `begin`: after an hour, or earlier where currents or wind begin or end.
  /// So the whole step is with or without these data.
  [[nodiscard]] core::UtcTime end_of_step(core::UtcTime begin) const {
    core::UtcTime end = begin + hour;
    for (const CurrentGrid* const forces : {carrying(environment_), environment_.wind.get()}) {
      if (forces == nullptr || (environment_.steady_currents && forces != environment_.wind.get())) continue;
      for (const double time_s : {forces->times_s().front(), forces->times_s().back()}) {
        const core::UtcTime change = core::from_unix_seconds(time_s);
        if (begin < change && change < end) end = change;
      }
    }
    return end;
  }

  [[nodiscard]] bool knows_the_current(const IcebergFix& at) const { return over_draft(at).has_value(); }

  /// Uses the mean depth, not the least of the cell. A forecast that holds a berg too early would leave the
  /// water open into which it drifts; the position error grows in both cases.
  [[nodiscard]] bool is_aground(geo::LonLat place) const {
    if (!environment_.bathymetry) return false;
    const auto bed = environment_.bathymetry->depth(place);
    return bed && *bed <= draft_;
  }

 private:
  /// Mean current over the draft; empty if it is unknown.
  [[nodiscard]] std::optional<geo::VelocityEn> over_draft(const IcebergFix& at) const {
    if (!carrying(environment_)) return std::nullopt;
    const CurrentGrid& currents = *carrying(environment_);
    if (environment_.steady_currents) return currents.depth_average(at.place, draft_, 0);
    const auto when = currents.times_s().locate(core::unix_seconds(at.time));
    if (!when) return std::nullopt;
    const auto before = currents.depth_average(at.place, draft_, when->lower);
    if (!before || when->fraction == 0.0) return before;
    const auto after = currents.depth_average(at.place, draft_, when->upper);
    if (!after) return std::nullopt;
    return geo::VelocityEn{before->east + when->fraction * (after->east - before->east),
                           before->north + when->fraction * (after->north - before->north)};
  }

  /// Velocity that the wind adds to that of the water; empty if the wind is unknown.
  [[nodiscard]] std::optional<geo::VelocityEn> by_wind(const IcebergFix& at) const {
    if (!environment_.wind) return std::nullopt;
    const auto wind = environment_.wind->at(at.place, core::Metres{0.0}, at.time);
    if (!wind) return std::nullopt;
    return moved_by_wind(*wind, length_, at.place.lat_deg);
  }

  /// The observed drift minus the current, and minus the effect of the wind if that is known all along; zero
  /// if the current is unknown anywhere.
  [[nodiscard]] geo::VelocityEn besides_forces(const ObservedDrift& observed) {
    const IcebergFix& from = observed.from;
    const core::Seconds span = last_.time - from.time;
    const int samples = static_cast<int>(std::ceil(span / hour));
    const core::Seconds step = span / samples;
    geo::VelocityEn of_current{};
    geo::VelocityEn of_wind{};
    wind_was_known_ = true;
    for (int i = 0; i < samples; ++i) {
      const core::Seconds elapsed = (i + 0.5) * step;
      const IcebergFix at{moved(from.place, observed.velocity, elapsed), from.time + elapsed};
      const auto current = over_draft(at);
      const auto wind = by_wind(at);
      if (!wind) wind_was_known_ = false;
      if (!current) return {};
      of_current = sum(of_current, *current);
      of_wind = sum(of_wind, wind.value_or(geo::VelocityEn{}));
    }
    if (!wind_was_known_) of_wind = {};
    const double share = 1.0 / samples;
    return {observed.velocity.east - share * (of_current.east + of_wind.east),
            observed.velocity.north - share * (of_current.north + of_wind.north)};
  }

  const Environment& environment_;
  core::Metres draft_;
  core::Metres length_;
  IcebergFix last_;
  std::optional<ObservedDrift> observed_;
  geo::VelocityEn besides_forces_{};
  bool wind_was_known_{false};  // all along the observed drift
};

}  // namespace

std::vector<IcebergFix> forecast_drift(const Iceberg& iceberg, const Environment& environment,
                                       core::UtcTime until, const std::stop_token& stop) {
  const Drift drift{iceberg, environment};
  std::vector<IcebergFix> fixes{{iceberg.place, iceberg.observed}};
  while (fixes.back().time < until && !stop.stop_requested()) {
    const IcebergFix& at = fixes.back();
    const core::UtcTime end = drift.end_of_step(at.time);
    const core::Seconds step = end - at.time;
    const IcebergFix middle{moved(at.place, drift.velocity(at), 0.5 * step), at.time + 0.5 * step};
    const geo::LonLat next = moved(at.place, drift.velocity(middle), step);
    fixes.push_back({drift.is_aground(next) ? at.place : next, end});
  }
  return fixes;
}

core::UtcTime forecast_needs_from(const Iceberg& iceberg) {
  const auto observed = observed_drift(iceberg);
  return observed ? observed->from.time : iceberg.observed;
}

bool is_current_known(const Iceberg& iceberg, const Environment& environment, core::UtcTime from,
                      core::UtcTime until, const std::stop_token& stop) {
  const Drift drift{iceberg, environment};
  return std::ranges::all_of(forecast_drift(iceberg, environment, until, stop), [&](const IcebergFix& at) {
    return at.time < from || at.time > until || drift.is_aground(at.place) || drift.knows_the_current(at);
  });
}

DriftBasis drift_basis(const Iceberg& iceberg, const Environment& environment, core::UtcTime until,
                       const std::stop_token& stop) {
  const Drift drift{iceberg, environment};
  const std::vector<IcebergFix> fixes = forecast_drift(iceberg, environment, until, stop);
  DriftBasis basis;
  std::vector<IcebergFix> part;
  const auto end_part = [&] {
    if (part.size() > basis.known.size()) basis.known = part;
    part.clear();
  };
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    const IcebergFix& from = fixes[i - 1];
    if (drift.is_aground(from.place) || drift.knows_the_current(from)) {
      if (part.empty()) part.push_back(from);
      part.push_back(fixes[i]);
    } else {
      basis.unknown += std::min(fixes[i].time, until) - from.time;
      end_part();
    }
  }
  end_part();
  return basis;
}

core::Metres expected_error(const Iceberg& iceberg, core::UtcTime time) {
  const double stated_m = iceberg.position_uncertainty.value_or(core::Metres{0.0}).value;
  const core::Seconds age = time - iceberg.observed;
  return {stated_m + error_growth.value * std::abs(age.count())};
}

}  // namespace floeplan::ocean
