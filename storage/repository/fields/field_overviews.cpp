#include "storage/repository/fields/field_overviews.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/repository/fields/field_chunks.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/fields/grid_window.hpp"
#include "storage/repository/fields/point_reader.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

constexpr std::size_t stride = 4;

/// A field or one of its overviews.
struct Level {
  std::string variable;
  ocean::HorizontalGrid grid;
};

std::string name_of_level(const std::string& variable, std::size_t number) {
  std::size_t nodes_apart = 1;
  for (std::size_t i = 0; i < number; ++i) nodes_apart *= stride;
  return number == 0 ? variable : variable + "/" + std::to_string(nodes_apart);
}

/// Indices of the nodes of an axis that an overview keeps, always including the last, so that it covers the
/// same range.
std::vector<std::size_t> kept_of(std::size_t count) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < count; i += stride) kept.push_back(i);
  if (kept.back() != count - 1) kept.push_back(count - 1);
  return kept;
}

ocean::Axis thinned(const ocean::Axis& axis) {
  std::vector<double> nodes;
  for (const std::size_t i : kept_of(axis.size())) nodes.push_back(axis[i]);
  return ocean::Axis{std::move(nodes)};
}

/// The field itself, then all its overviews, whether stored or not.
std::vector<Level> levels_of(const std::string& variable, const ocean::HorizontalGrid& field) {
  std::vector<Level> levels{{variable, field}};
  while (levels.back().grid.size() > FieldOverviews::plenty) {
    const ocean::HorizontalGrid& finer = levels.back().grid;
    levels.push_back(
        {name_of_level(variable, levels.size()), {finer.frame(), thinned(finer.x()), thinned(finer.y())}});
  }
  return levels;
}

ChunkLayout layout_of(std::int64_t dataset_row, const ocean::HorizontalGrid& grid) {
  return {dataset_row, grid.x().size(), grid.y().size(), FieldRepository::rows_together};
}

bool is_stored(sql::Connection& db, std::int64_t dataset_row, const std::string& variable) {
  sql::Statement query{db, "SELECT 1 FROM field_chunk WHERE dataset_row = ?1 AND variable = ?2 LIMIT 1"};
  query.bind_all(dataset_row, variable);
  return query.step();
}

AxisWindow rows_of(const ocean::Axis& y, std::size_t first, std::size_t last) {
  const auto begin = y.nodes().begin();
  return {{{first, last - first + 1}},
          ocean::Axis{
              {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last) + 1}}};
}

void thin(sql::Connection& db, std::int64_t dataset_row, const Level& finer, const Level& coarser) {
  ChunkReader reader{db, layout_of(dataset_row, finer.grid)};
  ChunkWriter writer{db, layout_of(dataset_row, coarser.grid)};
  const auto columns = kept_of(finer.grid.x().size());
  const auto rows = kept_of(finer.grid.y().size());
  const AxisWindow all_columns = whole(finer.grid.x());
  std::vector<float> read;
  std::vector<float> kept;
  for (std::size_t first = 0; first < rows.size(); first += FieldRepository::rows_together) {
    const std::size_t end = std::min(first + FieldRepository::rows_together, rows.size());
    const GridWindow window{all_columns, rows_of(finer.grid.y(), rows[first], rows[end - 1])};
    read.resize(finer.grid.x().size() * (rows[end - 1] - rows[first] + 1));
    reader.read({finer.variable, 0, 0}, window, read);
    kept.clear();
    for (std::size_t row = first; row < end; ++row) {
      const std::size_t begin = (rows[row] - rows[first]) * finer.grid.x().size();
      for (const std::size_t column : columns) kept.push_back(read[begin + column]);
    }
    writer.write({coarser.variable, 0, 0}, first, kept);
  }
}

}  // namespace

void FieldOverviews::make(const DatasetId& id, const std::string& variable) {
  const auto shape = FieldRepository{db_}.shape(id);
  if (!shape) return;
  const std::int64_t row = dataset_row(db_, id);
  const std::vector<Level> levels = levels_of(variable, shape->grid);
  sql::Transaction transaction{db_};
  for (std::size_t i = 1; i < levels.size(); ++i) thin(db_, row, levels[i - 1], levels[i]);
  transaction.commit();
}

std::optional<ocean::Bathymetry> FieldOverviews::bathymetry(const DatasetId& id, const geo::BoundingBox& area,
                                                            std::size_t most_nodes) const {
  const auto shape = FieldRepository{db_}.shape(id);
  if (!shape) return std::nullopt;
  const std::int64_t row = dataset_row(db_, id);
  if (find_native_layout(db_, row)) return FieldRepository{db_}.load_bathymetry(id, area);
  std::vector<Level> levels = levels_of("depth_m", shape->grid);
  // Stores of earlier versions have no overviews.
  std::erase_if(levels, [&](const Level& level) { return !is_stored(db_, row, level.variable); });
  for (const Level& level : levels) {
    const auto window = window_around(level.grid, area);
    if (!window) return std::nullopt;
    const std::size_t nodes = window->x.nodes.size() * window->y.nodes.size();
    if (nodes > most_nodes && &level != &levels.back()) continue;
    std::vector<float> depths_m(nodes);
    ChunkReader{db_, layout_of(row, level.grid)}.read({level.variable, 0, 0}, *window, depths_m);
    return ocean::Bathymetry{{level.grid.frame(), window->x.nodes, window->y.nodes}, std::move(depths_m)};
  }
  return std::nullopt;
}

}  // namespace floeplan::repository
