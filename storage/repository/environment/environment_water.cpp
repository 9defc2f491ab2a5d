#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>
#include <utility>

#include "engine/core/shown_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/data_messages.hpp"
#include "engine/ocean/currents/nearest_water.hpp"
#include "storage/repository/environment/environment_draft.hpp"
#include "storage/repository/environment/environment_parts.hpp"

namespace floeplan::repository {
namespace {

std::string in_metres(double length_m) { return std::to_string(std::lround(length_m)) + " m"; }

/// The currents as used in the plan: their mean over time if they are held steady.
std::shared_ptr<const ocean::CurrentGrid> as_they_count(const ocean::Environment& environment,
                                                        std::shared_ptr<const ocean::CurrentGrid> currents) {
  const bool varies = currents && currents->samples().times_s.size() > 1;
  if (!environment.steady_currents || !varies) return currents;
  return std::make_shared<const ocean::CurrentGrid>(currents->time_mean());
}

/// Upper limit of the time steps that are read of a dataset, or of its runs that are joined.
std::size_t most_steps(const EnvironmentDraft& draft, const Dataset& dataset,
                       const std::vector<JoinedPart>& parts) {
  const auto steps_of = [&](const Dataset& one) -> std::size_t {
    const auto shape = FieldRepository{draft.db}.shape(one.id);
    return shape && shape->times_s ? shape->times_s->size() : 1;
  };
  if (parts.empty()) return steps_of(dataset);
  std::size_t steps = 0;
  for (const JoinedPart& part : parts) steps += steps_of(part.dataset);
  return steps;
}

/// Reads the currents of the area and those that carry icebergs, at once if that needs few more samples. `read` is a
/// function of a CurrentsBox; `steps`: the most that it reads. Those that carry icebergs have at most as many samples as
/// the area's or 32 million, two floats each (256 MB), divided among the members of an ensemble.
/// Returns false if there are none.
template <class Read>
bool adopt_currents(EnvironmentDraft& draft, const Dataset& dataset, std::size_t members,
                    std::size_t steps_at_most, const Read& read) {
  constexpr std::size_t most_samples = 32'000'000;
  const CurrentsBox of_area{draft.query.area, draft.query.dive_depth};
  const auto of_drift = drift_box(
      draft, dataset, steps_at_most,
      std::max(most_samples / members, steps_at_most * most_samples_a_step(draft, dataset, of_area)));
  const auto of_both = of_drift ? box_of_both(draft, dataset, of_area, *of_drift) : std::nullopt;
  auto currents = read(of_both.value_or(of_area));
  if (!currents) return false;
  const std::string name = title(dataset);
  const auto& samples = currents->samples();
  if (!samples.depths_m) {
    draft.tell(messages::data_message<"currents-without-depth">(name));
  } else if (samples.depths_m->size() == 1) {
    draft.tell(messages::data_message<"currents-of-one-level">(name, in_metres(samples.depths_m->front())));
  } else if (samples.depths_m->back() < draft.query.dive_depth.value) {
    draft.tell(messages::data_message<"currents-above-dives">(name, in_metres(samples.depths_m->back()),
                                                              in_metres(draft.query.dive_depth.value)));
  }

  const std::size_t steps = samples.times_s.size();
  const auto covered = period_of(dataset);
  if (!covered) {
    draft.tell(messages::data_message<"currents-without-time">(name));
  } else if (draft.query.steady && steps == 1) {
    draft.tell(messages::data_message<"currents-held-steady">(name, covered->from));
  } else if (draft.query.steady) {
    draft.tell(messages::data_message<"currents-held-at-mean">(name, steps, period_text(*covered)));
  }

  if (covered && draft.query.steady) {
    const core::Seconds away = std::max(covered->from - draft.query.depart, draft.query.depart - covered->to);
    if (away.count() > 0.0)
      draft.tell(messages::data_message<"currents-of-another-time">(name, period_text(*covered),
                                                                    away.count() / 86'400.0));
  }

  draft.environment.steady_currents = draft.query.steady || !covered;
  draft.environment.currents = as_they_count(draft.environment, std::move(currents));
  if (of_drift) {
    draft.environment.drift_currents =
        of_both ? draft.environment.currents : as_they_count(draft.environment, read(*of_drift));
  }
  return true;
}

bool covers_end(const Period& period, const EnvironmentQuery& query) {
  return !query.until || covers(period, query.until->time);
}

/// Adds the violation. `periods` lists the period of each dataset; `begins`: one of them covers the
/// departure.
void refuse_period(EnvironmentDraft& draft, const std::string& periods, bool begins) {
  const bool at_end = draft.query.until && (begins || draft.query.may_begin_later);
  const std::string input = at_end ? draft.query.until->input : "depart";
  const core::UtcTime time = at_end ? draft.query.until->time : draft.query.depart;
  draft.violations.push_back(
      messages::fault<"outside-the-currents">("/" + input, time, periods, at_end ? "Stay" : "Depart"));
}

/// Where the nearest water of the currents lies: "120 km south of the middle of this area, at -12.0000,
/// 70.0000". For currents whose box reaches the area, although their water does not: a bent grid or a mesh
/// fills its box only in part. Empty if there is no water within 1000 km.
std::optional<std::string> where_its_water_is(const EnvironmentDraft& draft, const Dataset& dataset) {
  const geo::BoundingBox area = named_area(draft.query);
  const double middle_lon = area.west_deg + geo::width_deg(area) / 2.0;
  const geo::LonLat middle{middle_lon > 180.0 ? middle_lon - 360.0 : middle_lon,
                           (area.south_deg + area.north_deg) / 2.0};
  auto first = period_of(dataset);
  if (first) first->to = first->from;
  for (const double reach_m : {100'000.0, 300'000.0, 1'000'000.0}) {
    const auto currents =
        read_currents(draft, dataset, {geo::grown(area, core::Metres{reach_m}), std::nullopt}, first);
    const auto water = currents ? ocean::nearest_water(*currents, middle) : std::nullopt;
    if (!water) continue;
    const geo::GeodesicLine line = geo::geodesic_between(middle, *water);
    std::ostringstream text;
    text << std::lround(line.length.value / 1000.0) << " km " << geo::compass_point(line.course_at_start)
         << " of the middle of this area, at " << std::fixed << std::setprecision(4) << water->lon_deg << ", "
         << water->lat_deg;
    return text.str();
  }
  return std::nullopt;
}

/// Refuses named currents without a node in the area.
void refuse_currents_elsewhere(EnvironmentDraft& draft, const Dataset& dataset) {
  if (const auto where = where_its_water_is(draft, dataset))
    return draft.refuse<"water-elsewhere">(DatasetKind::currents, title(dataset), *where);
  draft.refuse<"no-node-near">(DatasetKind::currents, title(dataset));
}

/// Several currents are members of an ensemble. All of them must be usable; the plan is made with the first.
void add_ensemble(EnvironmentDraft& draft, const std::vector<Dataset>& found) {
  const EnvironmentQuery& query = draft.query;
  std::vector<std::shared_ptr<const ocean::CurrentGrid>> members;
  std::vector<std::shared_ptr<const ocean::CurrentGrid>> drift_members;
  bool all_steady = true;
  bool none_steady = true;
  for (const Dataset& dataset : found) {
    auto period = query.steady ? std::nullopt : period_of(dataset);
    if (period && !(covers_begin(*period, query) && covers_end(*period, query))) {
      refuse_period(draft, coverage_text(dataset, *period), covers_begin(*period, query));
      continue;
    }
    if (period) {
      auto& begin = draft.environment.currents_begin;
      begin = begin ? std::max(*begin, period->from) : period->from;
      period->from = drift_start(draft);
    }
    const auto read = [&](const CurrentsBox& box) { return read_currents(draft, dataset, box, period); };
    if (!adopt_currents(draft, dataset, found.size(), most_steps(draft, dataset, {}), read)) {
      refuse_currents_elsewhere(draft, dataset);
      continue;
    }
    draft.cite(dataset);
    members.push_back(draft.environment.currents);
    if (draft.environment.drift_currents) drift_members.push_back(draft.environment.drift_currents);
    all_steady = all_steady && draft.environment.steady_currents;
    none_steady = none_steady && !draft.environment.steady_currents;
  }
  if (!all_steady && !none_steady) {
    draft.refuse<"members-of-two-sorts">(DatasetKind::currents);
  }
  if (members.empty()) return;
  draft.environment.currents = members.front();
  draft.environment.members = std::move(members);
  if (drift_members.empty()) return;
  draft.environment.drift_currents = drift_members.front();
  draft.environment.drift_members = std::move(drift_members);
}

/// If currents are stored, a pilot expects them to be used. If none intersects the area, coordinates are
/// probably wrong.
void refuse_other_waters(EnvironmentDraft& draft) {
  if (draft.query.currents.how != DatasetChoice::How::newest || draft.query.tides.wanted()) return;
  std::vector<std::string> elsewhere;
  for (const Dataset& dataset : draft.stored) {
    if (dataset.kind != DatasetKind::currents) continue;
    const auto where =
        geo::intersects(dataset.bounds, draft.query.area) ? where_its_water_is(draft, dataset) : std::nullopt;
    elsewhere.push_back(title(dataset) + (where ? " has its nearest water " + *where
                                                : " covers " + geo::bounds_text(dataset.bounds)));
  }
  if (elsewhere.empty()) return;
  draft.refuse<"no-currents-reach">(DatasetKind::currents, geo::bounds_text(named_area(draft.query)),
                                    core::shortened_list(elsewhere));
}

void add_currents(EnvironmentDraft& draft) {
  const EnvironmentQuery& query = draft.query;
  const auto found =
      candidates(draft.stored, DatasetKind::currents, query.currents, query.area, draft.violations);
  const bool named = query.currents.how == DatasetChoice::How::named;
  if (named && query.currents.ids.size() > 1) {
    return add_ensemble(draft, found);
  }

  std::string periods_missed;
  bool begins = false;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Dataset& dataset = found[i];
    const auto parts = query.steady ? std::vector<JoinedPart>{} : joined_parts(draft, found, i, named);
    const auto period = query.steady ? std::nullopt : joined_period(dataset, parts);
    begins = begins || (period && covers_begin(*period, query));
    if (period && !(covers_begin(*period, query) && covers_end(*period, query))) {
      periods_missed += (periods_missed.empty() ? "" : "; ") + coverage_text(dataset, *period);
      continue;
    }
    const auto read = [&](const CurrentsBox& box) {
      return parts.empty() ? read_currents(draft, dataset, box, std::nullopt)
                           : read_joined(draft, parts, box, drift_start(draft));
    };
    if (!adopt_currents(draft, dataset, 1, most_steps(draft, dataset, parts), read)) continue;
    if (period) draft.environment.currents_begin = period->from;
    return parts.empty() ? draft.cite(dataset) : cite_joined(draft, parts);
  }

  if (!periods_missed.empty()) return refuse_period(draft, periods_missed, begins);
  if (named && !found.empty()) refuse_currents_elsewhere(draft, found.front());
  if (!named) refuse_other_waters(draft);
  if (!named)
    tell_of_gap(draft, query.currents, messages::data_message<"currents-left-out">(),
                messages::data_message<"currents-missing">(geo::bounds_text(named_area(query))));
}

/// Tides are computed for as long as the drift of icebergs is followed, or the request needs currents.
ocean::TidePeriod period_of_tides(const EnvironmentDraft& draft) {
  constexpr core::Seconds longest{30.0 * 86400.0};
  core::UtcTime end = draft.query.depart + longest;
  if (draft.query.until) end = std::max(end, draft.query.until->time + longest);
  return {drift_start(draft), end};
}

}  // namespace

void add_water(EnvironmentDraft& draft) {
  const TidesQuery& query = draft.query.tides;
  const bool alone = query.wanted() && query.mode == TidesMode::only;
  if (alone && draft.query.currents.how == DatasetChoice::How::named)
    draft.refuse<"named-currents-left-out">(DatasetKind::tides);
  if (!alone) add_currents(draft);
  const Tides tides = load_tides(draft.db, draft.stored, query, draft.query.area, draft.violations);
  if (!query.wanted() || !query.mode || !draft.violations.empty()) return;
  if (!alone && !draft.environment.currents) {
    draft.refuse<"no-currents-for-tides">(DatasetKind::tides);
    return;
  }
  const ocean::TidePeriod period = period_of_tides(draft);
  lay_tides(draft.environment, tides, *query.mode, period);
  if (draft.query.iceberg_drift && !draft.environment.icebergs.empty()) {
    const geo::BoundingBox reached = geo::grown(draft.query.area, reach_of_drift);
    lay_drift_tides(draft.environment, load_again(draft.db, tides, reached), *query.mode, period);
  }
}

}  // namespace floeplan::repository
