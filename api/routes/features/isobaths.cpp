#include <array>
#include <charconv>

#include "api/codec/features/line_geometry.hpp"
#include "api/problems/problem_catalogue.hpp"
#include "api/routes/features/feature_collection.hpp"
#include "api/routes/features/hand_made.hpp"
#include "engine/ocean/bed/isobath.hpp"
#include "storage/repository/fields/joined_bathymetry.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

// Default depths of isobaths. Chosen: close together where shallow-water gliders fly, every 1000 m in the
// deep sea.
constexpr std::array<int, 21> usual_depths_m{5,   10,   20,   30,   50,   75,   100,  150,  200,  300,  400,
                                             500, 1000, 2000, 3000, 4000, 5000, 6000, 7000, 8000, 10000};
constexpr int deepest_m = 12'000;

/// Largest number of nodes of an isobath map. Chosen: about 500 by 500 are enough for a map of the area; a
/// smaller area gets a finer one.
constexpr std::size_t most_nodes = 250'000;

json geometry_of(const std::vector<ocean::Isobath>& lines) {
  json coordinates = json::array();
  for (const ocean::Isobath& line : lines) {
    json part = codec::line_geometry(line);
    if (part.at("type") == "LineString") {
      coordinates.push_back(std::move(part.at("coordinates")));
    } else {
      for (json& piece : part.at("coordinates")) coordinates.push_back(std::move(piece));
    }
  }
  return {{"type", "MultiLineString"}, {"coordinates", std::move(coordinates)}};
}

std::optional<json> isobath_feature(const repository::JoinedBathymetry& joined, int depth_m) {
  const auto lines = ocean::isobaths(joined.depths, core::Metres{static_cast<double>(depth_m)});
  if (lines.empty()) return std::nullopt;
  json datasets = json::array();
  for (const auto& id : joined.datasets) datasets.push_back(id.value);
  return json{{"type", "Feature"},
              {"id", depth_m},
              {"geometry", geometry_of(lines)},
              {"properties",
               {{"depth_m", depth_m},
                {"spacing_m", joined.depths.grid().spacing().value},
                {"dataset_ids", std::move(datasets)}}}};
}

std::optional<int> whole_depth(const std::string& text) {
  int depth_m = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), depth_m);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && depth_m > 0 && depth_m <= deepest_m ? std::optional{depth_m} : std::nullopt;
}

FeatureExtent isobath_extent(sql::Connection& db) {
  return extent_of_kind(db, repository::DatasetKind::bathymetry);
}

tl::expected<FeaturePage, problems::Problem> list_isobaths(const Context& context,
                                                           const FeatureQuery& query) {
  std::vector<int> depths_m{usual_depths_m.begin(), usual_depths_m.end()};
  if (const auto wanted = query.filters.find("depth_m"); wanted != query.filters.end()) {
    const auto depth_m = whole_depth(wanted->second);
    if (!depth_m) {
      return tl::unexpected(problems::problem<"invalid-request">().with(
          {{"?depth_m", "must be a whole number of metres from 1 to " + std::to_string(deepest_m)}}));
    }
    depths_m = {*depth_m};
  }
  FeaturePage page;
  page.matched = 0;
  const auto joined = repository::joined_bathymetry(
      context.db, query.area.value_or(isobath_extent(context.db).area), most_nodes);
  if (!joined) return page;
  for (const int depth_m : depths_m) {
    auto feature = isobath_feature(*joined, depth_m);
    if (!feature) continue;
    ++*page.matched;
    if (depth_m <= query.after) continue;
    if (page.features.size() < static_cast<std::size_t>(query.limit)) {
      page.features.push_back(std::move(*feature));
    } else if (!page.next) {
      page.next = page.features.back().at("id").get<int>();
    }
  }
  return page;
}

std::optional<json> find_isobath(const Context& context, const std::string& id) {
  const auto depth_m = whole_depth(id);
  const auto joined =
      depth_m ? repository::joined_bathymetry(context.db, isobath_extent(context.db).area, most_nodes)
              : std::nullopt;
  return joined ? isobath_feature(*joined, *depth_m) : std::nullopt;
}

}  // namespace

FeatureCollection isobath_collection() {
  return {.id = "isobaths",
          .title = "Lines of equal depth",
          .description =
              "Where the sea is as deep as on charts, or as deep as asked for, from all depths stored; "
              "the smaller the area asked for, the finer. For orientation: plans look at the depths "
              "themselves.",
          .schema = "Isobath",
          .item_name = "depth_m",
          .filters = {"depth_m"},
          .extent = isobath_extent,
          .list = list_isobaths,
          .find = find_isobath};
}

}  // namespace floeplan::routes
