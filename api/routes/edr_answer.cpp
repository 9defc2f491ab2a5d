#include "api/routes/edr_answer.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "api/routes/reply.hpp"
#include "storage/sqlite/snapshot.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr double most_values = 4e6;   // of an answer: about 30 MB of JSON
constexpr double usual_values = 5e5;  // that an answer has at most when nobody asks for a resolution
constexpr double metres_per_degree = 111'195.0;  // of latitude, mean of the WGS84 sphere of equal volume

/// Evenly spaced, both ends included.
std::vector<double> spread(double from, double to, std::size_t count) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.5;
    nodes.push_back(from + share * (to - from));
  }
  return nodes;
}

/// How many nodes a side has: as many as were asked for, else as many as the data have, or fewer where the answer
/// would become long.
std::size_t nodes_of_side(std::optional<double> asked, double length_m, core::Metres spacing,
                          double most_usual) {
  if (asked) return static_cast<std::size_t>(*asked);
  return static_cast<std::size_t>(std::clamp(std::floor(length_m / spacing.value) + 1.0, 2.0, most_usual));
}

}  // namespace

Response coverage_reply(const Request& request, const json& coverage) {
  const bool older = request.header("accept").find("application/prs.coverage+json") != std::string::npos;
  return json_reply(coverage, 200, older ? "application/prs.coverage+json" : "application/vnd.cov+json");
}

Response no_data(const Request& request) {
  return not_found(request, "no-data", "No data of this collection cover this place and time.");
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

codec::CoverageGrid empty_coverage(const EdrCollection& collection, const Wanted& wanted) {
  codec::CoverageGrid coverage;
  for (const std::size_t i : wanted.parameters) coverage.parameters.push_back(collection.parameters[i]);
  coverage.values.resize(wanted.parameters.size());
  return coverage;
}

void fill(codec::CoverageGrid& coverage, const EdrField* field, const EdrCollection& collection,
          const Wanted& wanted, const std::function<bool(geo::LonLat)>& is_inside) {
  const std::vector<core::UtcTime> times = coverage.t.empty() ? std::vector{core::UtcTime{}} : coverage.t;
  const std::vector<double> depths = coverage.z_m.empty() ? std::vector{0.0} : coverage.z_m;
  std::vector<std::optional<double>> sample(collection.parameters.size());
  for (const auto time : times) {
    for (const double depth : depths) {
      for (const double lat : coverage.y_deg) {
        for (const double lon : coverage.x_deg) {
          std::ranges::fill(sample, std::nullopt);
          const geo::LonLat place{geo::wrap_longitude(lon), lat};
          if (field != nullptr && is_inside(place)) field->sample(place, core::Metres{depth}, time, sample);
          for (std::size_t i = 0; i < wanted.parameters.size(); ++i)
            coverage.values[i].push_back(sample[wanted.parameters[i]]);
        }
      }
    }
  }
}

Response grid_reply(const EdrCollection& collection, const Context& context, const Request& request,
                    EdrRequest& query, const Wanted& wanted, const geo::BoundingBox& box,
                    const std::function<bool(geo::LonLat)>& is_inside) {
  constexpr double most_nodes = 2000.0;
  const auto columns = query.reader().number("resolution-x", 1.0, most_nodes);
  const auto rows = query.reader().number("resolution-y", 1.0, most_nodes);
  if (!query.violations().empty()) return invalid(request, query.violations());
  const sqlite::Snapshot one_moment{context.db};
  const auto shape = find_edr_data(context.db, collection, box, wanted.span);
  if (!shape) return no_data(request);

  codec::CoverageGrid coverage = empty_coverage(collection, wanted);
  coverage.t = times_of(*shape, wanted.span);
  coverage.z_m = query.depths(*shape);
  if (coverage.t.empty() != shape->times.empty()) return no_data(request);
  const double layers = layers_of(coverage);
  const double usual = std::max(2.0, std::floor(std::sqrt(usual_values / layers)));
  const double middle = (box.south_deg + box.north_deg) / 2.0 * std::numbers::pi / 180.0;
  const double width_m = geo::width_deg(box) * metres_per_degree * std::cos(middle);
  const double height_m = (box.north_deg - box.south_deg) * metres_per_degree;
  const auto nx = nodes_of_side(columns, width_m, shape->spacing, usual);
  const auto ny = nodes_of_side(rows, height_m, shape->spacing, usual);
  if (auto refusal = refuse_if_too_large(request, layers * static_cast<double>(nx * ny)))
    return std::move(*refusal);

  coverage.x_deg = spread(box.west_deg, box.west_deg + geo::width_deg(box), nx);
  coverage.y_deg = spread(box.south_deg, box.north_deg, ny);
  const auto from = coverage.t.empty() ? core::UtcTime{} : coverage.t.front();
  const auto to = coverage.t.empty() ? core::UtcTime{} : coverage.t.back();
  const auto field = load_edr_field(context.db, *shape, box, from, to, coverage.z_m);
  fill(coverage, field.get(), collection, wanted, is_inside);
  return coverage_reply(request, codec::coverage_json(coverage));
}

}  // namespace floeplan::routes
