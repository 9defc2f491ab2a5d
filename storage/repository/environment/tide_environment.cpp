#include "storage/repository/environment/tide_environment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include "engine/messages/data_messages.hpp"
#include "engine/messages/fault.hpp"
#include "storage/repository/fields/tide_repository.hpp"

namespace floeplan::repository {
namespace {

std::string titles(const std::vector<Dataset>& datasets) {
  std::string text;
  for (const Dataset& dataset : datasets) text += (text.empty() ? "" : ", ") + title(dataset);
  return text;
}

/// Whether a dataset's name says that its currents contain no tide.
bool says_detided(const ocean::DatasetRef& dataset) {
  constexpr std::array words{"detide",   "de-tide",   "de_tide",  "notide",   "no-tide",   "no_tide",
                             "nontidal", "non-tidal", "subtidal", "residual", "geostroph", "without tide"};
  std::string name = dataset.name;
  std::ranges::transform(name, name.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return std::ranges::any_of(words,
                             [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

std::string in_minutes(core::Seconds time) {
  return std::to_string(std::lround(time.count() / 60.0)) + " min";
}

/// The end of the tide if it ends before the currents, or, for currents without times, before the period;
/// otherwise empty.
std::optional<core::UtcTime> early_end(const ocean::CurrentGrid& currents, const ocean::TidePeriod& period) {
  const core::UtcTime end = core::from_unix_seconds(currents.times_s().back());
  const core::UtcTime wanted = currents.samples().times_s.size() > 1
                                   ? core::from_unix_seconds(currents.samples().times_s.back())
                                   : period.to;
  if (wanted - end <= core::Seconds{currents.times_s().mean_step()}) return std::nullopt;
  return end;
}

/// Adds the messages for the pilot about currents with tides.
void report_tides(ocean::Environment& environment, const Tides& tides, TidesMode mode,
                  const ocean::TidePeriod& period) {
  const ocean::CurrentGrid& currents = *environment.currents;
  const ocean::TidalCurrents& tide = *currents.tide();
  const auto tell = [&](messages::Message message) { environment.messages.push_back(std::move(message)); };
  const std::string names = titles(tides.datasets);

  if (mode == TidesMode::only) tell(messages::data_message<"tides-alone">(names));
  if (mode == TidesMode::add) {
    for (const ocean::DatasetRef& dataset : environment.datasets) {
      if (dataset.kind != kind_name(DatasetKind::currents)) continue;
      const std::string with = dataset.name + " (" + dataset.id + ")";
      tell(says_detided(dataset) ? messages::data_message<"tides-added">(names, with)
                                 : messages::data_message<"tides-may-count-twice">(names, with));
    }
  }
  const std::size_t nodes = currents.samples().grid.size();
  if (tide.known_nodes() == 0) {
    tell(messages::data_message<"tides-unknown">(names));
  } else if (mode == TidesMode::add && tide.known_nodes() < nodes) {
    tell(messages::data_message<"tides-unknown-at-nodes">(names, nodes - tide.known_nodes(), nodes));
  }

  const core::Seconds step{currents.times_s().mean_step()};
  if (step > 1.001 * ocean::straight_step(tides.models))
    tell(messages::data_message<"tides-in-coarse-steps">(in_minutes(step)));
  if (const auto end = early_end(currents, period)) tell(messages::data_message<"tides-end-early">(*end));
}

}  // namespace

Tides load_tides(sql::Connection& db, const std::vector<Dataset>& stored, const TidesQuery& query,
                 const geo::BoundingBox& area, core::Violations& violations) {
  Tides tides;
  if (!query.wanted()) {
    if (query.mode) violations.push_back(messages::fault<"mode-without-tides">("/tides_mode"));
    return tides;
  }
  if (!query.mode) violations.push_back(messages::fault<"tides-without-mode">("/tides_mode"));
  const bool named = query.choice.how == DatasetChoice::How::named;
  for (const Dataset& dataset : candidates(stored, DatasetKind::tides, query.choice, area, violations)) {
    auto model = TideRepository{db}.load(dataset.id, area);
    if (!model || !model->has(ocean::TideQuantity::east)) {
      if (named)
        violations.push_back(messages::fault<"no-tidal-currents">("/tides", title(dataset),
                                                                  model ? "elevations" : "stations"));
      continue;
    }
    tides.models.push_back(std::move(*model));
    tides.datasets.push_back(dataset);
    if (!named) break;
  }
  if (!named && tides.models.empty()) violations.push_back(messages::fault<"no-tide-model-here">("/tides"));
  return tides;
}

Tides load_again(sql::Connection& db, const Tides& tides, const geo::BoundingBox& area) {
  Tides again;
  for (const Dataset& dataset : tides.datasets) {
    auto model = TideRepository{db}.load(dataset.id, area);
    if (!model) continue;
    again.models.push_back(std::move(*model));
    again.datasets.push_back(dataset);
  }
  return again;
}

void lay_tides(ocean::Environment& environment, const Tides& tides, TidesMode mode,
               const ocean::TidePeriod& period) {
  if (mode == TidesMode::only) {
    environment.currents =
        std::make_shared<const ocean::CurrentGrid>(ocean::tide_alone(tides.models, period));
  } else if (environment.currents) {
    const auto sum = [&](const std::shared_ptr<const ocean::CurrentGrid>& currents) {
      return std::make_shared<const ocean::CurrentGrid>(ocean::with_tide(*currents, tides.models, period));
    };
    for (auto& member : environment.members) member = sum(member);
    environment.currents =
        environment.members.empty() ? sum(environment.currents) : environment.members.front();
  }
  if (!environment.currents) return;
  environment.steady_currents = false;
  report_tides(environment, tides, mode, period);
  for (const Dataset& dataset : tides.datasets)
    environment.datasets.push_back(
        {dataset.id.value, kind_name(dataset.kind), dataset.name, dataset.provenance.sha256});
}

void lay_drift_tides(ocean::Environment& environment, const Tides& tides, TidesMode mode,
                     const ocean::TidePeriod& period) {
  if (mode == TidesMode::only) {
    environment.drift_currents =
        std::make_shared<const ocean::CurrentGrid>(ocean::tide_alone(tides.models, period));
  } else if (environment.drift_currents) {
    const auto add = [&](std::shared_ptr<const ocean::CurrentGrid>& currents) {
      currents =
          std::make_shared<const ocean::CurrentGrid>(ocean::with_tide(*currents, tides.models, period));
    };
    for (auto& member : environment.drift_members) add(member);
    if (environment.drift_members.empty()) {
      add(environment.drift_currents);
    } else {
      environment.drift_currents = environment.drift_members.front();
    }
  }
  if (!environment.drift_currents) return;
  if (const auto end = early_end(*environment.drift_currents, period))
    environment.messages.push_back(messages::data_message<"drift-tides-end-early">(*end));
}

}  // namespace floeplan::repository
