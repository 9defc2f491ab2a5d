#include "storage/repository/datasets/dataset_repository.hpp"

#include <algorithm>
#include <limits>

#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

constexpr const char* select_dataset =
    "SELECT row, id, kind, name, west_deg, south_deg, east_deg, north_deg, time_start_s, time_end_s, "
    "rows_accepted, "
    "rows_refused, file_name, file_size_bytes, sha256, ingested_s, tool_version, run_s, outdated FROM "
    "dataset "
    "WHERE arriving_s IS NULL ";

void insert_texts(sql::Connection& db, std::int64_t row, const std::string& role,
                  const std::vector<std::string>& texts) {
  sql::Statement insert{
      db, "INSERT INTO dataset_text (dataset_row, role, position, text) VALUES (?1, ?2, ?3, ?4)"};
  for (std::size_t i = 0; i < texts.size(); ++i) {
    insert.bind_all(row, role, static_cast<std::int64_t>(i), texts[i]);
    insert.run();
  }
}

std::vector<std::string> read_texts(sql::Connection& db, std::int64_t row, const std::string& role) {
  sql::Statement query{
      db, "SELECT text FROM dataset_text WHERE dataset_row = ?1 AND role = ?2 ORDER BY position"};
  query.bind_all(row, role);
  std::vector<std::string> texts;
  while (query.step()) texts.push_back(query.text(0));
  return texts;
}

Dataset read_dataset(sql::Connection& db, const sql::Row& row) {
  return {.id = {row.text(1)},
          .kind = parse_kind(row.text(2)).value(),
          .name = row.text(3),
          .variables = read_texts(db, row.integer(0), "variable"),
          .bounds = {row.real(4), row.real(5), row.real(6), row.real(7)},
          .time_start = row.optional_time(8),
          .time_end = row.optional_time(9),
          .run = row.optional_time(17),
          .rows_accepted = row.integer(10),
          .rows_refused = row.integer(11),
          .warnings = read_texts(db, row.integer(0), "warning"),
          .provenance = {.file_name = row.text(12),
                         .file_size_bytes = row.integer(13),
                         .sha256 = row.text(14),
                         .ingested = row.time(15),
                         .tool_version = row.text(16)},
          .outdated = row.integer(18) != 0};
}

}  // namespace

void DatasetRepository::insert(const Dataset& dataset) {
  sql::Transaction transaction{db_};
  sql::Statement insert{
      db_,
      "INSERT INTO dataset (id, kind, name, west_deg, south_deg, east_deg, north_deg, time_start_s, "
      "time_end_s, "
      "rows_accepted, rows_refused, file_name, file_size_bytes, sha256, ingested_s, tool_version, run_s, "
      "outdated) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, ?17, ?18)"};
  const geo::BoundingBox& bounds = dataset.bounds;
  const Provenance& provenance = dataset.provenance;
  insert.bind_all(dataset.id.value, kind_name(dataset.kind), dataset.name, bounds.west_deg, bounds.south_deg,
                  bounds.east_deg, bounds.north_deg, dataset.time_start, dataset.time_end,
                  dataset.rows_accepted, dataset.rows_refused, provenance.file_name,
                  provenance.file_size_bytes, provenance.sha256, provenance.ingested, provenance.tool_version,
                  dataset.run, static_cast<std::int64_t>(dataset.outdated));
  insert.run();
  const std::int64_t row = dataset_row(db_, dataset.id);
  insert_texts(db_, row, "variable", dataset.variables);
  insert_texts(db_, row, "warning", dataset.warnings);
  transaction.commit();
}

void DatasetRepository::update(const Dataset& dataset) {
  sql::Statement update{
      db_,
      "UPDATE dataset SET west_deg = ?2, south_deg = ?3, east_deg = ?4, north_deg = ?5, time_start_s = ?6, "
      "time_end_s = ?7, rows_accepted = ?8, rows_refused = ?9, file_size_bytes = ?10, sha256 = ?11, "
      "ingested_s = "
      "?12 WHERE id = ?1"};
  const geo::BoundingBox& bounds = dataset.bounds;
  update.bind_all(dataset.id.value, bounds.west_deg, bounds.south_deg, bounds.east_deg, bounds.north_deg,
                  dataset.time_start, dataset.time_end, dataset.rows_accepted, dataset.rows_refused,
                  dataset.provenance.file_size_bytes, dataset.provenance.sha256, dataset.provenance.ingested);
  update.run();
}

std::optional<Dataset> DatasetRepository::find(const DatasetId& id) const {
  sql::Statement query{db_, std::string{select_dataset} + "AND id = ?1"};
  query.bind(1, id.value);
  if (!query.step()) return std::nullopt;
  return read_dataset(db_, query);
}

std::vector<Dataset> DatasetRepository::list() const {
  sql::Statement query{db_, std::string{select_dataset} + "ORDER BY ingested_s DESC, id"};
  std::vector<Dataset> datasets;
  while (query.step()) datasets.push_back(read_dataset(db_, query));
  return datasets;
}

PartialList<Dataset> DatasetRepository::list_past_damage() const {
  const auto of_row = [&](std::int64_t row) {
    sql::Statement query{db_, std::string{select_dataset} + "AND row = ?1"};
    query.bind(1, row);
    return query.step() ? std::optional{read_dataset(db_, query)} : std::nullopt;
  };
  auto datasets = repository::list_past_damage(
      db_, dataset_table, {.limit = std::numeric_limits<int>::max()}, [&] { return list(); }, of_row);
  std::ranges::sort(datasets.whole, [](const Dataset& a, const Dataset& b) {
    const core::UtcTime one = a.provenance.ingested;
    const core::UtcTime other = b.provenance.ingested;
    return one != other ? one > other : a.id < b.id;
  });
  return datasets;
}

std::vector<geo::BoundingBox> DatasetRepository::areas(DatasetKind kind) const {
  sql::Statement query{
      db_,
      "SELECT west_deg, south_deg, east_deg, north_deg FROM dataset WHERE arriving_s IS NULL AND kind = ?1"};
  query.bind(1, kind_name(kind));
  std::vector<geo::BoundingBox> areas;
  while (query.step()) areas.push_back({query.real(0), query.real(1), query.real(2), query.real(3)});
  return areas;
}

std::string DatasetRepository::contents() const {
  sql::Statement query{db_, "SELECT id, sha256 FROM dataset ORDER BY id"};
  std::string text;
  while (query.step()) text += query.text(0) + ' ' + query.text(1) + '\n';
  return text;
}

bool DatasetRepository::remove(const DatasetId& id) {
  sql::Statement remove{db_, "DELETE FROM dataset WHERE id = ?1"};
  remove.bind(1, id.value);
  return remove.run() > 0;
}

}  // namespace floeplan::repository
