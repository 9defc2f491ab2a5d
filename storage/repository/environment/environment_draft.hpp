#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/messages/fault.hpp"
#include "engine/ocean/environment.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/environment/environment_query.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/fields/forecast_runs.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The environment while it is being assembled.
struct EnvironmentDraft {
  sql::Connection& db;  // borrowed
  const EnvironmentQuery& query;
  const Reading& reading;
  std::vector<Dataset> stored;  // newest first
  ocean::Environment environment;
  core::Violations violations;

  void tell(messages::Message message) { environment.messages.push_back(std::move(message)); }
  template <messages::Code code, class... Given>
  void refuse(DatasetKind kind, const Given&... values) {
    violations.push_back(messages::fault<code>("/" + kind_name(kind), values...));
  }
  /// Adds messages, datasets and violations of another part of the same environment.
  void append_report(const EnvironmentDraft& part) {
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(environment.messages, part.environment.messages);
    append(environment.datasets, part.environment.datasets);
    append(violations, part.violations);
  }
  void cite(const Dataset& dataset) {
    environment.datasets.push_back(
        {dataset.id.value, kind_name(dataset.kind), dataset.name, dataset.provenance.sha256, dataset.run});
  }
  /// Cites one of several datasets that were joined in time, with the period for which it was used.
  void cite(const Dataset& dataset, const Period& used) {
    cite(dataset);
    environment.datasets.back().from = used.from;
    environment.datasets.back().until = used.to;
  }
};

/// The period that a dataset states; empty if it states none.
[[nodiscard]] std::optional<Period> period_of(const Dataset& dataset);
[[nodiscard]] std::string period_text(const Period& period);
/// "Disko (currents-1) covers ... to ...".
[[nodiscard]] std::string coverage_text(const Dataset& dataset, const Period& period);
[[nodiscard]] bool covers(const Period& period, core::UtcTime time);
/// Whether data of this period can be used for a departure of the query.
[[nodiscard]] bool covers_begin(const Period& period, const EnvironmentQuery& query);
/// The part of currents that is read.
struct CurrentsBox {
  geo::BoundingBox area;
  std::optional<core::Metres> deepest;  // deepest level needed; empty: all levels
};

/// The time from which the forecast of iceberg drift needs currents and wind.
[[nodiscard]] core::UtcTime drift_start(const EnvironmentDraft& draft);
/// The model runs of the product that `found[which]` belongs to, joined around the departure. If it was
/// named, only itself.
[[nodiscard]] std::vector<JoinedPart> joined_parts(const EnvironmentDraft& draft,
                                                   const std::vector<Dataset>& found, std::size_t which,
                                                   bool named);
/// The period of the joined parts; the dataset's own period if nothing was joined.
[[nodiscard]] std::optional<Period> joined_period(const Dataset& dataset,
                                                  const std::vector<JoinedPart>& parts);
/// Does what load_joined does, using the reading's cache if there is one; null: no data.
[[nodiscard]] std::shared_ptr<const ocean::CurrentGrid> read_joined(const EnvironmentDraft& draft,
                                                                    const std::vector<JoinedPart>& parts,
                                                                    const CurrentsBox& box,
                                                                    core::UtcTime from);
/// The time steps of one dataset; null: no data. No period: all steps.
[[nodiscard]] std::shared_ptr<const ocean::CurrentGrid> read_currents(const EnvironmentDraft& draft,
                                                                      const Dataset& dataset,
                                                                      const CurrentsBox& box,
                                                                      const std::optional<Period>& period);
/// Lists every part among the environment's datasets, and, if there are several, the period in which each was
/// used.
void cite_joined(EnvironmentDraft& draft, const std::vector<JoinedPart>& parts);
/// Adds the message that a kind of data is missing: `left_out` if the user chose none, otherwise `missing`.
void tell_of_gap(EnvironmentDraft& draft, const DatasetChoice& choice, messages::Message left_out,
                 messages::Message missing);

/// Whether `holds(place)` is true at all nodes of a lattice that divides the area into `pieces` along each
/// side, edges included.
template <class Holds>
[[nodiscard]] bool holds_all_over(const geo::BoundingBox& area, int pieces, const Holds& holds) {
  const double width_deg = geo::width_deg(area);
  for (int row = 0; row <= pieces; ++row) {
    for (int column = 0; column <= pieces; ++column) {
      const double lat_deg = area.south_deg + (area.north_deg - area.south_deg) * row / pieces;
      const double lon_deg = geo::wrap_longitude(area.west_deg + width_deg * column / pieces);
      if (!holds(geo::LonLat{lon_deg, lat_deg})) return false;
    }
  }
  return true;
}

}  // namespace floeplan::repository
