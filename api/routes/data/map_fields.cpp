#include <algorithm>
#include <optional>
#include <tl/expected.hpp>

#include "api/codec/exports/map_grid.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_overviews.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::routes {
namespace {

using repository::Dataset;
using repository::DatasetKind;

/// The area and the resolution that the map requests.
struct View {
  geo::BoundingBox area;
  std::size_t nx{};
  std::size_t ny{};
};

std::optional<View> read_view(ParameterReader& reader) {
  reader.require("bbox", "west,south,east,north in degrees");
  reader.require("nx", "the number of columns");
  reader.require("ny", "the number of rows");
  const auto area = reader.bbox();
  const auto nx = reader.integer("nx", 2, 1024);
  const auto ny = reader.integer("ny", 2, 1024);
  if (!area || !nx || !ny) return std::nullopt;
  return View{*area, static_cast<std::size_t>(*nx), static_cast<std::size_t>(*ny)};
}

bool suits(const Dataset& dataset, DatasetKind kind, const geo::BoundingBox& area,
           std::optional<core::UtcTime> time) {
  if (dataset.kind != kind || !geo::intersects(dataset.bounds, area)) return false;
  if (!time) return true;
  return (!dataset.time_start || *dataset.time_start <= *time) &&
         (!dataset.time_end || *time <= *dataset.time_end);
}

/// The named dataset, or the newest of the kind that covers area and time; otherwise the problem for the
/// answer.
tl::expected<Dataset, Response> choose_dataset(const Context& context, const Request& request,
                                               DatasetKind kind, const geo::BoundingBox& area,
                                               std::optional<core::UtcTime> time) {
  const repository::DatasetRepository datasets{context.db};
  const std::string what = repository::kind_name(kind);
  if (const auto id = request.parameter("dataset")) {
    const auto dataset = datasets.find({*id});
    if (!dataset) return tl::unexpected(problem_reply<"unknown-dataset">(request, *id));
    if (dataset->kind != kind) {
      return tl::unexpected(
          invalid(request, {{"?dataset", "must be of kind " + what + ", but " + *id + " is of kind " +
                                             repository::kind_name(dataset->kind)}}));
    }
    if (suits(*dataset, kind, area, time)) return *dataset;
  } else {
    auto newest_first = datasets.list();
    repository::sort_newest_run_first(newest_first);
    for (const auto& dataset : newest_first) {
      if (suits(dataset, kind, area, time)) return dataset;
    }
  }
  return tl::unexpected(time ? problem_reply<"no-data-in-area-then">(request, what)
                             : problem_reply<"no-data-in-area">(request, what));
}

codec::MapGrid empty_grid(const View& view, const Dataset& dataset) {
  codec::MapGrid grid;
  grid.nx = view.nx;
  grid.ny = view.ny;
  grid.west_deg = view.area.west_deg;
  grid.south_deg = view.area.south_deg;
  grid.dx_deg = geo::width_deg(view.area) / static_cast<double>(view.nx - 1);
  grid.dy_deg = (view.area.north_deg - view.area.south_deg) / static_cast<double>(view.ny - 1);
  grid.dataset_id = dataset.id.value;
  grid.dataset_name = dataset.name;
  return grid;
}

/// Calls `visit` for each node of the grid, in the order of its values.
template <class Visit>
void for_each_place(const codec::MapGrid& grid, const Visit& visit) {
  for (std::size_t iy = 0; iy < grid.ny; ++iy) {
    for (std::size_t ix = 0; ix < grid.nx; ++ix) {
      visit(geo::LonLat{geo::wrap_longitude(grid.west_deg + static_cast<double>(ix) * grid.dx_deg),
                        grid.south_deg + static_cast<double>(iy) * grid.dy_deg});
    }
  }
}

Response grid_reply(const codec::MapGrid& grid) {
  Response response;
  response.content_type = "application/octet-stream";
  response.headers.emplace_back("Cache-Control", "no-cache");
  response.body = codec::encode(grid);
  return response;
}

Response show_bathymetry(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  const auto view = read_view(reader);
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  const auto dataset = choose_dataset(context, request, DatasetKind::bathymetry, view->area, std::nullopt);
  if (!dataset) return dataset.error();
  using repository::FieldOverviews;
  // Up to 16 depths for each sample of the picture; more would not be visible.
  const std::size_t most_nodes = std::min(16 * view->nx * view->ny, FieldOverviews::plenty);
  const auto bathymetry = FieldOverviews{context.db}.bathymetry(dataset->id, view->area, most_nodes);
  if (!bathymetry) return problem_reply<"no-node-in-area">(request);

  codec::MapGrid grid = empty_grid(*view, *dataset);
  codec::MapGrid::Variable depth{"depth_m", 0.5, {}};
  for_each_place(grid, [&](geo::LonLat place) {
    const auto value = bathymetry->depth(place);
    depth.values.push_back(value ? std::optional{value->value} : std::nullopt);
  });
  grid.variables.push_back(std::move(depth));
  return grid_reply(grid);
}

Response show_currents(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  const auto view = read_view(reader);
  reader.require("time", "the moment to show, as 2026-11-20T06:00:00Z");
  const auto time = reader.time("time");
  const auto depth_m = reader.number("depth_m", 0.0, 12000.0);
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  const auto dataset = choose_dataset(context, request, DatasetKind::currents, view->area, time);
  if (!dataset) return dataset.error();
  const auto shape = repository::FieldRepository{context.db}.shape(dataset->id);
  const bool layered = shape && shape->depths_m;
  const core::Metres depth{depth_m.value_or(layered ? shape->depths_m->front() : 0.0)};
  const auto currents = repository::FieldRepository{context.db}.load_currents(
      dataset->id, view->area, repository::Period{*time, *time}, depth);
  if (!currents) return problem_reply<"no-node-in-area-then">(request);

  codec::MapGrid grid = empty_grid(*view, *dataset);
  grid.time = time;
  codec::MapGrid::Variable east{"u_m_s", 0.001, {}};
  codec::MapGrid::Variable north{"v_m_s", 0.001, {}};
  for_each_place(grid, [&](geo::LonLat place) {
    const auto velocity = currents->at(place, depth, *time);
    east.values.push_back(velocity ? std::optional{velocity->east.value} : std::nullopt);
    north.values.push_back(velocity ? std::optional{velocity->north.value} : std::nullopt);
  });
  grid.variables = {std::move(east), std::move(north)};
  return grid_reply(grid);
}

/// Step of the encoded thickness of level ice: fine enough for the picture, and large enough for the
/// thickness of ice shelves.
constexpr double thickness_step_m = 0.04;

Response show_sea_ice(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  const auto view = read_view(reader);
  reader.require("time", "the moment to show, as 2026-11-20T06:00:00Z");
  const auto time = reader.time("time");
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  const auto dataset = choose_dataset(context, request, DatasetKind::ice, view->area, time);
  if (!dataset) return dataset.error();
  const auto ice = repository::FieldRepository{context.db}.load_ice(dataset->id, view->area,
                                                                    repository::Period{*time, *time});
  if (!ice) return problem_reply<"no-node-in-area-then">(request);

  codec::MapGrid grid = empty_grid(*view, *dataset);
  grid.time = time;
  codec::MapGrid::Variable concentration{"concentration", 0.0001, {}};
  codec::MapGrid::Variable thickness{"thickness_m", thickness_step_m, {}};
  for_each_place(grid, [&](geo::LonLat place) {
    const auto state = ice->at(place, *time);
    concentration.values.push_back(state ? std::optional{state->concentration} : std::nullopt);
    thickness.values.push_back(state && state->thickness ? std::optional{state->thickness->value}
                                                         : std::nullopt);
  });
  grid.variables = {std::move(concentration), std::move(thickness)};
  return grid_reply(grid);
}

}  // namespace

std::vector<Route> map_field_routes() {
  return {{"GET", "/map/bathymetry", {"bbox", "nx", "ny", "dataset"}, show_bathymetry},
          {"GET", "/map/currents", {"bbox", "nx", "ny", "time", "dataset", "depth_m"}, show_currents},
          {"GET", "/map/sea-ice", {"bbox", "nx", "ny", "time", "dataset"}, show_sea_ice}};
}

}  // namespace floeplan::routes
