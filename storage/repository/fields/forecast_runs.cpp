#include "storage/repository/fields/forecast_runs.hpp"

#include <algorithm>
#include <utility>

#include "engine/ocean/grids/point_velocities.hpp"

namespace floeplan::repository {
namespace {

struct Step {
  double time_s{};
  std::size_t run{};
};

/// All steps that no newer run covers, ascending.
std::vector<Step> steps_in_force(std::span<const std::vector<double>> runs_s) {
  std::vector<Step> steps;
  for (std::size_t run = 0; run < runs_s.size(); ++run) {
    for (const double time_s : runs_s[run]) {
      const auto newer = runs_s.first(run);
      const bool replaced = std::ranges::any_of(newer, [&](const std::vector<double>& other) {
        return !other.empty() && other.front() <= time_s && time_s <= other.back();
      });
      if (!replaced) steps.push_back({time_s, run});
    }
  }
  std::ranges::sort(steps, {}, &Step::time_s);
  return steps;
}

double longest_step(const std::vector<double>& times_s) {
  double longest = 0.0;
  for (std::size_t i = 1; i < times_s.size(); ++i) longest = std::max(longest, times_s[i] - times_s[i - 1]);
  return longest;
}

bool follows(const Step& before, const Step& after, std::span<const std::vector<double>> runs_s) {
  constexpr double rounding_s = 1.0;  // rounding of times that a file states as fractions of a day
  if (before.run == after.run) return true;
  const double allowed = std::max(longest_step(runs_s[before.run]), longest_step(runs_s[after.run]));
  return after.time_s - before.time_s <= allowed + rounding_s;
}

std::vector<RunSteps> runs_of(std::span<const Step> steps) {
  std::vector<RunSteps> result;
  for (const Step& step : steps) {
    if (result.empty() || result.back().run != step.run)
      result.push_back({step.run, step.time_s, step.time_s});
    result.back().last_s = step.time_s;
  }
  return result;
}

bool same_axis(const ocean::Axis& a, const ocean::Axis& b) { return a.nodes() == b.nodes(); }

bool same_product(const Dataset& a, const FieldShape& shape_a, const Dataset& b, const FieldShape& shape_b) {
  if (a.variables != b.variables || shape_a.depths_m.has_value() != shape_b.depths_m.has_value())
    return false;
  if (shape_a.depths_m && !same_axis(*shape_a.depths_m, *shape_b.depths_m)) return false;
  return shape_a.grid.frame() == shape_b.grid.frame() && same_axis(shape_a.grid.x(), shape_b.grid.x()) &&
         same_axis(shape_a.grid.y(), shape_b.grid.y());
}

using Samples = ocean::CurrentGrid::Samples;

bool same_depths(const Samples& a, const Samples& b) {
  if (!a.depths_m || !b.depths_m) return a.depths_m.has_value() == b.depths_m.has_value();
  return same_axis(*a.depths_m, *b.depths_m);
}

/// The same currents at more depths; the new ones are interpolated linearly.
Samples at_more_depths(Samples samples, const ocean::Axis& depths_m) {
  const ocean::CurrentGrid currents{std::move(samples)};
  Samples more = currents.samples();
  more.depths_m = depths_m;
  more.u.clear();
  more.v.clear();
  const std::size_t columns = more.grid.x().size();
  for (const double time_s : more.times_s.nodes()) {
    for (const double depth_m : depths_m.nodes()) {
      for (std::size_t node = 0; node < more.grid.size(); ++node) {
        const auto velocity = currents.at(more.grid.place(node % columns, node / columns), {depth_m},
                                          core::from_unix_seconds(time_s));
        more.u.push_back(velocity ? static_cast<float>(velocity->east.value) : ocean::missing_sample);
        more.v.push_back(velocity ? static_cast<float>(velocity->north.value) : ocean::missing_sample);
      }
    }
  }
  return more;
}

/// Interpolates both to all depths of either. Depths differ if a model's levels follow its surface, which
/// changes in time.
void bring_to_same_depths(Samples& a, Samples& b) {
  std::vector<double> depths_m = a.depths_m->nodes();
  depths_m.insert(depths_m.end(), b.depths_m->nodes().begin(), b.depths_m->nodes().end());
  std::ranges::sort(depths_m);
  depths_m.erase(std::unique(depths_m.begin(), depths_m.end()), depths_m.end());
  const ocean::Axis all{std::move(depths_m)};
  a = at_more_depths(std::move(a), all);
  b = at_more_depths(std::move(b), all);
}

void append(const Samples& later, Samples& joined) {
  std::vector<double> times_s = joined.times_s.nodes();
  times_s.insert(times_s.end(), later.times_s.nodes().begin(), later.times_s.nodes().end());
  joined.times_s = ocean::Axis{std::move(times_s)};
  joined.u.insert(joined.u.end(), later.u.begin(), later.u.end());
  joined.v.insert(joined.v.end(), later.v.begin(), later.v.end());
}

bool meets(const Dataset& dataset, const Period& period) {
  return dataset.time_start && dataset.time_end && *dataset.time_end >= period.from &&
         *dataset.time_start <= period.to;
}

}  // namespace

std::vector<RunSteps> newest_steps(std::span<const std::vector<double>> runs_s, double wanted_s,
                                   bool may_begin_later) {
  const std::vector<Step> steps = steps_in_force(runs_s);
  std::size_t first = 0;
  for (std::size_t end = 1; end <= steps.size(); ++end) {
    if (end < steps.size() && follows(steps[end - 1], steps[end], runs_s)) continue;
    const bool holds_wanted = steps[first].time_s <= wanted_s || may_begin_later;
    if (holds_wanted && wanted_s <= steps[end - 1].time_s)
      return runs_of(std::span{steps}.subspan(first, end - first));
    first = end;
  }
  return {};
}

std::vector<JoinedPart> join_runs(sql::Connection& db, const std::vector<Dataset>& runs, std::size_t which,
                                  const Period& within, core::UtcTime wanted, bool may_begin_later) {
  const FieldRepository fields{db};
  const auto shape = fields.shape(runs[which].id);
  if (!shape || !shape->times_s) return {};
  std::vector<std::size_t> joined;
  std::vector<std::vector<double>> times_s;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i != which && !meets(runs[i], within)) continue;
    const auto other = i == which ? shape : fields.shape(runs[i].id);
    if (!other || !other->times_s || !same_product(runs[which], *shape, runs[i], *other)) continue;
    joined.push_back(i);
    times_s.push_back(other->times_s->nodes());
  }
  std::vector<JoinedPart> parts;
  for (const RunSteps& steps : newest_steps(times_s, core::unix_seconds(wanted), may_begin_later))
    parts.push_back({runs[joined[steps.run]],
                     {core::from_unix_seconds(steps.first_s), core::from_unix_seconds(steps.last_s)}});
  return parts;
}

std::optional<ocean::CurrentGrid> load_joined(sql::Connection& db, const std::vector<JoinedPart>& parts,
                                              const geo::BoundingBox& area, core::UtcTime from,
                                              std::optional<core::Metres> deepest,
                                              const std::stop_token& stop) {
  const auto load = [&](const JoinedPart& part) {
    const Period wanted{std::clamp(from, part.used.from, part.used.to), part.used.to};
    return FieldRepository{db, stop}.load_currents(part.dataset.id, area, wanted, deepest);
  };
  if (parts.size() == 1) return load(parts.front());

  std::optional<Samples> joined;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    // If `from` lies between two parts, the earlier part is needed too: its last step is before `from`.
    const bool is_over = i + 1 < parts.size() && parts[i + 1].used.from <= from;
    if (is_over) continue;
    const auto loaded = load(parts[i]);
    if (!loaded) return std::nullopt;
    if (!joined) {
      joined = loaded->samples();
    } else if (same_depths(*joined, loaded->samples())) {
      append(loaded->samples(), *joined);
    } else {
      Samples later = loaded->samples();
      bring_to_same_depths(*joined, later);
      append(later, *joined);
    }
  }
  if (!joined) return std::nullopt;
  return ocean::CurrentGrid{std::move(*joined)};
}

}  // namespace floeplan::repository
