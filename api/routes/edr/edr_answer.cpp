#include "api/routes/edr/edr_answer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "api/routes/request/reply.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/geo/united_boxes.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/datasets/dataset_choice.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr double most_values = 4e6;  // limit of an answer: about 30 MB of JSON

/// Joins parts with the same places and depths to one coverage with all their steps in order of time.
codec::CoverageGrid joined_steps(const std::vector<codec::CoverageGrid>& parts) {
  struct Step {
    core::UtcTime time;
    const codec::CoverageGrid* part;
    std::size_t index;
  };
  std::vector<Step> steps;
  for (const auto& part : parts)
    for (std::size_t i = 0; i < part.t.size(); ++i) steps.push_back({part.t[i], &part, i});
  std::ranges::stable_sort(steps, {}, &Step::time);
  codec::CoverageGrid all = parts.front();
  const std::size_t slab = all.values.front().size() / all.t.size();
  all.t.clear();
  for (auto& values : all.values) values.clear();
  for (const Step& step : steps) {
    all.t.push_back(step.time);
    for (std::size_t k = 0; k < all.values.size(); ++k) {
      const auto from = step.part->values[k].begin() + static_cast<std::ptrdiff_t>(step.index * slab);
      all.values[k].insert(all.values[k].end(), from, from + static_cast<std::ptrdiff_t>(slab));
    }
  }
  return all;
}

/// Steps of a run in the period that no earlier run in the list covers.
std::vector<core::UtcTime> new_steps(const EdrShape& run, const TimeSpan& span,
                                     const std::vector<std::pair<core::UtcTime, core::UtcTime>>& spoken_of) {
  std::vector<core::UtcTime> steps = times_of(run, span);
  std::erase_if(steps, [&](core::UtcTime step) {
    return std::ranges::any_of(
        spoken_of, [&](const auto& period) { return period.first <= step && step <= period.second; });
  });
  return steps;
}

/// Adds steps of other runs in the requested period. Runs are joined as in plans: at each time the newest run
/// that covers it.
codec::CoverageGrid with_other_runs(const EdrAttempt& answer, sql::Connection& db,
                                    const EdrCollection& collection, const Wanted& wanted,
                                    const geo::BoundingBox& box, const EdrShape& first,
                                    const std::vector<repository::Dataset>& datasets) {
  constexpr std::size_t most_runs = 100;  // chosen: a season of daily runs is read in about a second
  std::vector parts{*answer.coverage};
  const bool is_period = (wanted.span.from || wanted.span.to) && wanted.span.from != wanted.span.to;
  if (!is_period || first.times.empty()) return parts.front();
  const double values_a_step = layers_of(parts.front()) / static_cast<double>(parts.front().t.size()) *
                               static_cast<double>(answer.is_inside.size());
  auto steps = static_cast<double>(parts.front().t.size());
  codec::CoverageSource source = parts.front().source;
  std::vector spoken_of{std::pair{first.times.front(), first.times.back()}};
  for (const auto& dataset : datasets) {
    const auto run = dataset.id == first.dataset.id ? std::nullopt : edr_shape(db, dataset);
    if (!run || run->times.empty() || !are_of_one_model(first, *run)) continue;
    codec::CoverageGrid part = *answer.coverage;
    part.values.assign(part.values.size(), {});
    part.t = new_steps(*run, wanted.span, spoken_of);
    if (part.t.empty()) continue;
    steps += static_cast<double>(part.t.size());
    if (values_a_step * steps > most_values || parts.size() > most_runs) {
      source.sampling += source.sampling.empty() ? "" : "; ";
      source.sampling += "steps of further runs are left out: ask for less time";
      break;
    }
    const auto field = load_edr_field(db, *run, box, part.t.front(), part.t.back(), part.z_m);
    if (!field) continue;
    fill(part, *field, collection, wanted, answer.is_inside);
    if (!has_value(part)) continue;
    spoken_of.emplace_back(run->times.front(), run->times.back());
    source.further_ids.push_back(dataset.id.value);
    parts.push_back(std::move(part));
  }
  codec::CoverageGrid all = joined_steps(parts);
  all.source = std::move(source);
  return all;
}

}  // namespace

bool has_value(const codec::CoverageGrid& coverage) {
  return std::ranges::any_of(coverage.values, [](const auto& values) {
    return std::ranges::any_of(values, [](const auto& value) { return value.has_value(); });
  });
}

std::string number_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.7g", value);
  return text.data();
}

Response coverage_reply(const Request& request, const json& coverage) {
  const bool older = request.header("accept").find("application/prs.coverage+json") != std::string::npos;
  return json_reply(coverage, 200, older ? "application/prs.coverage+json" : "application/vnd.cov+json");
}

Response no_data(const Request& request, const std::string& why) {
  return why.empty() ? problem_reply<"no-data-here">(request)
                     : problem_reply<"no-data-because">(request, why);
}

std::optional<Response> refuse_if_too_large(const Request& request, double values) {
  if (values <= most_values) return std::nullopt;
  return problem_reply<"too-many-values">(request, std::llround(values), std::llround(most_values));
}

double layers_of(const codec::CoverageGrid& coverage) {
  return static_cast<double>(std::max<std::size_t>(coverage.t.size(), 1) *
                             std::max<std::size_t>(coverage.z_m.size(), 1) * coverage.parameters.size());
}

tl::expected<codec::CoverageGrid, std::string> planned_coverage(const EdrCollection& collection,
                                                                const EdrShape& shape,
                                                                const EdrRequest& query, const Wanted& wanted,
                                                                std::optional<double> z_m) {
  codec::CoverageGrid coverage;
  coverage.source = {.dataset_id = shape.dataset.id.value, .dataset_name = shape.dataset.name};
  for (const std::size_t i : wanted.parameters) coverage.parameters.push_back(collection.parameters[i]);
  coverage.values.resize(wanted.parameters.size());
  const std::string title = repository::title(shape.dataset);
  coverage.t = times_of(shape, wanted.span);
  if (coverage.t.empty() && !shape.times.empty()) {
    return tl::unexpected(title + " has no step in the period asked for, though its steps reach from " +
                          core::iso8601(shape.times.front()) + " to " + core::iso8601(shape.times.back()) +
                          "; ask for an instant, and the steps around it are interpolated.");
  }
  if (shape.depths_m.empty()) {
    if (!collection.has_depths || !query.wants_levels_below()) return coverage;
    return tl::unexpected(title + " states no depth of its currents; ask without depths, or for one.");
  }
  coverage.z_m = z_m ? std::vector{*z_m} : query.depths(shape);
  if (coverage.z_m.empty()) {
    return tl::unexpected(
        title + " has no level between the depths asked for, though its levels reach from " +
        number_text(shape.depths_m.front()) + " m to " + number_text(shape.depths_m.back()) +
        " m; ask for one depth, and the levels around it are interpolated.");
  }
  return coverage;
}

void fill(codec::CoverageGrid& coverage, const EdrField& field, const EdrCollection& collection,
          const Wanted& wanted, const std::vector<bool>& is_inside) {
  const std::vector<core::UtcTime> times = coverage.t.empty() ? std::vector{core::UtcTime{}} : coverage.t;
  const std::vector<double> depths = coverage.z_m.empty() ? std::vector{0.0} : coverage.z_m;
  std::vector<std::optional<double>> sample(collection.parameters.size());
  for (const auto time : times) {
    for (const double depth : depths) {
      std::size_t index = 0;
      for (const double lat : coverage.y_deg) {
        for (const double lon : coverage.x_deg) {
          std::ranges::fill(sample, std::nullopt);
          if (is_inside[index++])
            field.sample({geo::wrap_longitude(lon), lat}, core::Metres{depth}, time, sample);
          for (std::size_t i = 0; i < wanted.parameters.size(); ++i)
            coverage.values[i].push_back(sample[wanted.parameters[i]]);
        }
      }
    }
  }
}

bool AskedGrids::take(const ocean::HorizontalGrid& grid) {
  constexpr std::ptrdiff_t most_of_one_grid = 3;
  const auto before = std::ranges::count_if(asked_, [&](const ocean::HorizontalGrid& other) {
    return other.frame() == grid.frame() && other.x().nodes() == grid.x().nodes() &&
           other.y().nodes() == grid.y().nodes();
  });
  if (before >= most_of_one_grid) return false;
  asked_.push_back(grid);
  return true;
}

tl::expected<codec::CoverageGrid, Response> first_with_values(
    sql::Connection& db, const Request& request, const EdrCollection& collection, const Wanted& wanted,
    const geo::BoundingBox& box,
    const std::function<tl::expected<EdrAttempt, Response>(const EdrShape&)>& ask) {
  auto datasets = edr_datasets(db, collection, box, wanted.span);
  // Datasets that cover a larger share come first: a fine chart or model of a harbour must not answer for a
  // whole bay.
  constexpr double share_step = 1e-3;  // chosen: larger than the rounding of coordinates in files
  std::ranges::stable_sort(datasets, std::ranges::greater{}, [&](const auto& dataset) {
    return std::round(geo::share_held(dataset.bounds, box) / share_step);
  });
  AskedGrids asked;
  std::optional<codec::CoverageGrid> without_values;
  std::string why;
  for (const auto& dataset : datasets) {
    const auto shape = edr_shape(db, dataset);
    if (!shape || !asked.take(shape->grid)) continue;
    auto attempt = ask(*shape);
    if (!attempt) return tl::unexpected(std::move(attempt.error()));
    if (attempt->coverage && has_value(*attempt->coverage))
      return with_other_runs(*attempt, db, collection, wanted, box, *shape, datasets);
    if (attempt->coverage && attempt->is_conclusive && !without_values)
      without_values = std::move(attempt->coverage);
    if (why.empty()) why = attempt->why;
  }
  if (without_values) return std::move(*without_values);
  return tl::unexpected(no_data(request, why));
}

}  // namespace floeplan::routes
