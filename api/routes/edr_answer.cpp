#include "api/routes/edr_answer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "api/routes/edr_places.hpp"
#include "api/routes/reply.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/repository/dataset_choice.hpp"
#include "storage/sqlite/snapshot.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr double most_values = 4e6;   // of an answer: about 30 MB of JSON
constexpr double usual_values = 5e5;  // that an answer has at most when nobody asks for a resolution

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

std::string place_text(geo::LonLat place) {
  return number_text(place.lon_deg) + " " + number_text(place.lat_deg);
}

core::UtcTime first_time(const codec::CoverageGrid& coverage) {
  return coverage.t.empty() ? core::UtcTime{} : coverage.t.front();
}

core::UtcTime last_time(const codec::CoverageGrid& coverage) {
  return coverage.t.empty() ? core::UtcTime{} : coverage.t.back();
}

/// A query of a shape, for one dataset after the other.
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

/// The dataset where no place of its grid lies in the shape: at the first middle of its parts with a value.
EdrAttempt AreaQuery::ask_at_middles(const EdrShape& shape, const codec::CoverageGrid& planned) const {
  for (const geo::LonLat middle : area.middles) {
    const auto field = load_edr_field_at(context.db, shape, middle, first_time(planned), last_time(planned),
                                         planned.z_m, context.service.current_blocks.get());
    if (!field) continue;
    const EdrPlaces place =
        only_place(middle, "interpolated at the middle of the shape, in which no node lies that was asked");
    codec::CoverageGrid coverage = planned;
    coverage.x_deg = place.x_deg;
    coverage.y_deg = place.y_deg;
    coverage.source.sampling = place.sampling;
    fill(coverage, *field, collection, wanted, place.is_inside);
    if (has_value(coverage)) return {.coverage = std::move(coverage), .is_conclusive = false, .why = {}};
  }
  const std::string where = area.middles.empty() ? "" : ", " + place_text(area.middles.front());
  return {.coverage = {},
          .is_conclusive = false,
          .why = "No node of " + repository::title(shape.dataset) +
                 " that was asked lies in the shape, and it has no value at the middle of it" + where +
                 ": that is land, a gap of the data or beyond them. Ask for a larger shape."};
}

tl::expected<EdrAttempt, Response> AreaQuery::ask(const EdrShape& shape) const {
  auto planned = planned_coverage(collection, shape, query, wanted);
  if (!planned) return EdrAttempt{.coverage = {}, .is_conclusive = false, .why = planned.error()};
  const double layers = layers_of(*planned);
  const double asked = columns && rows ? static_cast<double>(*columns * *rows) : 1.0;
  if (auto refusal = refuse_if_too_large(request, layers * asked)) return tl::unexpected(std::move(*refusal));
  const auto field =
      load_edr_field(context.db, shape, area.box, first_time(*planned), last_time(*planned), planned->z_m);
  if (!field) {
    return EdrAttempt{.coverage = {},
                      .is_conclusive = false,
                      .why = repository::title(shape.dataset) + " does not reach into the shape."};
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
                    .is_conclusive = places->is_every_node,
                    .why = repository::title(shape.dataset) + " has no value where it was asked (" +
                           places->sampling + "); ask for a smaller shape or a finer resolution."};
}

}  // namespace

Response coverage_reply(const Request& request, const json& coverage) {
  const bool older = request.header("accept").find("application/prs.coverage+json") != std::string::npos;
  return json_reply(coverage, 200, older ? "application/prs.coverage+json" : "application/vnd.cov+json");
}

Response no_data(const Request& request, const std::string& why) {
  return not_found(request, "no-data",
                   why.empty() ? "No data of this collection cover this place and time." : why);
}

std::optional<Response> refuse_if_too_large(const Request& request, double values) {
  if (values <= most_values) return std::nullopt;
  return problem_reply(request, {413,
                                 "too-many-values",
                                 "Too many values",
                                 "The answer would have " + std::to_string(std::llround(values)) +
                                     " values, more than " + std::to_string(std::llround(most_values)) +
                                     "; ask for less time, fewer depths or a coarser resolution.",
                                 {}});
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
  coverage.source = {
      .dataset_id = shape.dataset.id.value, .dataset_name = shape.dataset.name, .sampling = {}};
  for (const std::size_t i : wanted.parameters) coverage.parameters.push_back(collection.parameters[i]);
  coverage.values.resize(wanted.parameters.size());
  const std::string title = repository::title(shape.dataset);
  coverage.t = times_of(shape, wanted.span);
  if (coverage.t.empty() && !shape.times.empty()) {
    return tl::unexpected(title + " has no step in the period asked for, though its steps reach from " +
                          core::iso8601(shape.times.front()) + " to " + core::iso8601(shape.times.back()) +
                          "; ask for an instant, and the steps around it are interpolated.");
  }
  if (shape.depths_m.empty()) return coverage;
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
    sqlite::Connection& db, const Request& request, const std::vector<repository::Dataset>& datasets,
    const std::function<tl::expected<EdrAttempt, Response>(const EdrShape&)>& ask) {
  AskedGrids asked;
  std::optional<codec::CoverageGrid> without_values;
  std::string why;
  for (const auto& dataset : datasets) {
    const auto shape = edr_shape(db, dataset);
    if (!shape || !asked.take(shape->grid)) continue;
    auto attempt = ask(*shape);
    if (!attempt) return tl::unexpected(std::move(attempt.error()));
    if (attempt->coverage && has_value(*attempt->coverage)) return std::move(*attempt->coverage);
    if (attempt->coverage && attempt->is_conclusive && !without_values)
      without_values = std::move(attempt->coverage);
    if (why.empty()) why = attempt->why;
  }
  if (without_values) return std::move(*without_values);
  return tl::unexpected(no_data(request, why));
}

Response grid_reply(const EdrCollection& collection, const Context& context, const Request& request,
                    EdrRequest& query, const Wanted& wanted, const EdrArea& area) {
  constexpr std::int64_t most_nodes = 2000;
  const auto columns = query.reader().integer("resolution-x", 1, most_nodes);
  const auto rows = query.reader().integer("resolution-y", 1, most_nodes);
  if (!query.violations().empty()) return invalid(request, query.violations());
  const sqlite::Snapshot one_moment{context.db};
  const AreaQuery question{collection,
                           context,
                           request,
                           query,
                           wanted,
                           area,
                           columns ? std::optional{static_cast<std::size_t>(*columns)} : std::nullopt,
                           rows ? std::optional{static_cast<std::size_t>(*rows)} : std::nullopt};
  const auto coverage =
      first_with_values(context.db, request, edr_datasets(context.db, collection, area.box, wanted.span),
                        [&](const EdrShape& shape) { return question.ask(shape); });
  return coverage ? coverage_reply(request, codec::coverage_json(*coverage)) : coverage.error();
}

}  // namespace floeplan::routes
