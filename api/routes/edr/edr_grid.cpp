#include "api/routes/edr/edr_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "api/routes/edr/edr_answer.hpp"
#include "api/routes/edr/edr_places.hpp"
#include "api/routes/request/reply.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/datasets/dataset_choice.hpp"
#include "storage/sql/snapshot.hpp"

namespace floeplan::routes {
namespace {

constexpr double usual_values = 5e5;  // largest answer if the query does not state a resolution

std::string place_text(geo::LonLat place) {
  return number_text(place.lon_deg) + " " + number_text(place.lat_deg);
}

core::UtcTime first_time(const codec::CoverageGrid& coverage) {
  return coverage.t.empty() ? core::UtcTime{} : coverage.t.front();
}

core::UtcTime last_time(const codec::CoverageGrid& coverage) {
  return coverage.t.empty() ? core::UtcTime{} : coverage.t.back();
}

/// A query of a shape, to be sent to one dataset after the other.
struct AreaQuery {
  const EdrCollection& collection;
  const Context& context;
  const Request& request;
  const EdrRequest& query;
  const Wanted& wanted;
  const EdrArea& area;
  std::optional<std::size_t> columns;
  std::optional<std::size_t> rows;

  [[nodiscard]] tl::expected<EdrAttempt, Response> ask(const EdrShape& shape) const;
  [[nodiscard]] EdrAttempt ask_at_middles(const EdrShape& shape, const codec::CoverageGrid& planned) const;
};

/// Samples a dataset without nodes in the shape: at the middles of the shape's parts, until one has a value.
EdrAttempt AreaQuery::ask_at_middles(const EdrShape& shape, const codec::CoverageGrid& planned) const {
  for (const geo::LonLat middle : area.middles) {
    const auto field = load_edr_field_at(context.db, shape, middle, first_time(planned), last_time(planned),
                                         planned.z_m, context.service.current_blocks.get());
    if (!field) continue;
    const EdrPlaces place = only_place(
        middle, "interpolated at the middle of the shape: it holds no node at the resolution of the answer");
    codec::CoverageGrid coverage = planned;
    coverage.x_deg = place.x_deg;
    coverage.y_deg = place.y_deg;
    coverage.source.sampling = place.sampling;
    fill(coverage, *field, collection, wanted, place.is_inside);
    if (has_value(coverage)) return {.coverage = std::move(coverage), .is_inside = place.is_inside};
  }
  const std::string where = area.middles.empty() ? "" : ", " + place_text(area.middles.front());
  return {.why = repository::title(shape.dataset) +
                 " has no node in the shape at the resolution of the answer, and no value at its middle" +
                 where + ": that is land, a gap or beyond the data. Ask for a larger shape."};
}

tl::expected<EdrAttempt, Response> AreaQuery::ask(const EdrShape& shape) const {
  auto planned = planned_coverage(collection, shape, query, wanted);
  if (!planned) return EdrAttempt{.why = planned.error()};
  const double layers = layers_of(*planned);
  const double asked = columns && rows ? static_cast<double>(*columns * *rows) : 1.0;
  if (auto refusal = refuse_if_too_large(request, layers * asked)) return tl::unexpected(std::move(*refusal));
  const auto field =
      load_edr_field(context.db, shape, area.box, first_time(*planned), last_time(*planned), planned->z_m);
  if (!field) {
    return EdrAttempt{.why = repository::title(shape.dataset) + " does not reach into the shape."};
  }
  const double most_places = std::max(1.0, std::floor(usual_values / layers));
  auto places = places_in(area, {field->grid(), field->nodes_apart()}, {columns, rows, most_places});
  if (!places) return ask_at_middles(shape, *planned);
  if (auto refusal = refuse_if_too_large(request, layers * static_cast<double>(places->size())))
    return tl::unexpected(std::move(*refusal));
  planned->x_deg = std::move(places->x_deg);
  planned->y_deg = std::move(places->y_deg);
  planned->source.sampling = places->sampling;
  fill(*planned, *field, collection, wanted, places->is_inside);
  return EdrAttempt{.coverage = std::move(*planned),
                    .is_inside = std::move(places->is_inside),
                    .is_conclusive = places->is_every_node,
                    .why = repository::title(shape.dataset) + " has no value where it was asked (" +
                           places->sampling + "); ask for a smaller shape or a finer resolution."};
}

}  // namespace

Response grid_reply(const EdrCollection& collection, const Context& context, const Request& request,
                    EdrRequest& query, const Wanted& wanted, const EdrArea& area) {
  constexpr std::int64_t most_nodes = 2000;
  const auto columns = query.reader().integer("resolution-x", 1, most_nodes);
  const auto rows = query.reader().integer("resolution-y", 1, most_nodes);
  if (!query.violations().empty()) return invalid(request, query.violations());
  const sql::Snapshot one_moment{context.db};
  const AreaQuery question{collection,
                           context,
                           request,
                           query,
                           wanted,
                           area,
                           columns ? std::optional{static_cast<std::size_t>(*columns)} : std::nullopt,
                           rows ? std::optional{static_cast<std::size_t>(*rows)} : std::nullopt};
  const auto coverage = first_with_values(context.db, request, collection, wanted, area.box,
                                          [&](const EdrShape& shape) { return question.ask(shape); });
  return coverage ? coverage_reply(request, codec::coverage_json(*coverage)) : coverage.error();
}

}  // namespace floeplan::routes
