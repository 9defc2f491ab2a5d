#include "storage/repository/datasets/dataset_rows.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/sql/driver/failure.hpp"
#include "storage/sql/references.hpp"

namespace floeplan::repository {
namespace {

constexpr std::size_t parcel_bytes = std::size_t{1} << 20;
// row numbers up to this can be added to others without overflow
constexpr std::int64_t highest_row_number = std::int64_t{1} << 53;

template <class T>
void append(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

void append_bytes(std::string& out, std::string_view bytes) {
  append(out, static_cast<std::uint32_t>(bytes.size()));
  out.append(bytes);
}

void append_value(std::string& out, const sql::Row& row, int column, sql::ColumnType type) {
  const bool is_there = !row.is_null(column);
  append(out, static_cast<char>(is_there));
  if (!is_there) return;
  switch (type) {
    case sql::ColumnType::integer: return append(out, row.integer(column));
    case sql::ColumnType::real: return append(out, row.real(column));
    case sql::ColumnType::text: return append_bytes(out, row.text(column));
    case sql::ColumnType::blob: {
      const std::span<const std::byte> blob = row.blob(column);
      return append_bytes(out, {reinterpret_cast<const char*>(blob.data()), blob.size()});
    }
  }
}

std::string names_of(const std::vector<sql::Column>& columns) {
  std::string names;
  for (const sql::Column& column : columns) names += (names.empty() ? "" : ", ") + column.name;
  return names;
}

/// Sends the rows selected by `condition`, whose parameter is a text.
void send_rows(sql::Connection& db, const std::string& table, const std::string& condition,
               const std::string& parameter, const std::function<void(std::string_view)>& send) {
  const std::vector<sql::Column> columns = sql::columns_of(db, table);
  sql::Statement rows{db, "SELECT " + names_of(columns) + " FROM " + table + " WHERE " + condition};
  rows.bind(1, parameter);
  const std::string head = static_cast<char>(table.size()) + table;
  std::string parcel = head;
  while (rows.step()) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      append_value(parcel, rows, static_cast<int>(i), columns[i].type);
    if (parcel.size() < parcel_bytes) continue;
    send(parcel);
    parcel = head;
  }
  if (parcel.size() > head.size()) send(parcel);
}

std::string_view cut(std::string_view& values, std::size_t count) {
  if (values.size() < count) throw BrokenParcel{"a parcel of rows was cut short"};
  const std::string_view first = values.substr(0, count);
  values.remove_prefix(count);
  return first;
}

template <class T>
T number(std::string_view& values) {
  T value{};
  std::memcpy(&value, cut(values, sizeof(T)).data(), sizeof(T));
  return value;
}

std::int64_t checked_integer(const std::string& column, std::int64_t value) {
  const bool counts_rows = column == "row" || column == "dataset_row";
  if (counts_rows && (value < 1 || value > highest_row_number))
    throw BrokenParcel{"a row with an impossible number"};
  return value;
}

void bind_value(sql::Statement& insert, int parameter, const sql::Column& column, std::string_view& values) {
  const char is_there = number<char>(values);
  if (is_there == 0) return insert.bind_null(parameter, column.type);
  if (is_there != 1) throw BrokenParcel{"a value that is neither there nor absent"};
  switch (column.type) {
    case sql::ColumnType::integer:
      return insert.bind(parameter, checked_integer(column.name, number<std::int64_t>(values)));
    case sql::ColumnType::real: {
      const auto value = number<double>(values);
      if (std::isnan(value)) throw BrokenParcel{"a number that is none"};
      return insert.bind(parameter, value);
    }
    case sql::ColumnType::text: {
      const auto length = number<std::uint32_t>(values);
      return insert.bind(parameter, std::string{cut(values, length)});
    }
    case sql::ColumnType::blob: {
      const auto length = number<std::uint32_t>(values);
      const std::string_view blob = cut(values, length);
      return insert.bind(parameter, std::as_bytes(std::span{blob.data(), blob.size()}));
    }
  }
}

/// The datasets received; throws if one is invalid.
std::vector<Dataset> checked_datasets(sql::Connection& db) {
  std::vector<Dataset> datasets;
  try {
    datasets = DatasetRepository{db}.list();
  } catch (const sql::Failure&) {
    throw;
  } catch (const std::exception& fault) {
    throw BrokenParcel{fault.what()};
  }
  for (const Dataset& dataset : datasets)
    for (const double degrees : {dataset.bounds.west_deg, dataset.bounds.south_deg, dataset.bounds.east_deg,
                                 dataset.bounds.north_deg})
      if (std::abs(degrees) > 360.0) throw BrokenParcel{"a dataset that lies nowhere on the Earth"};
  return datasets;
}

/// Runs `work`. A row that violates the schema is a fault of the sender; every other failure is the
/// machine's.
template <class Work>
void blaming_the_sender(const Work& work) {
  try {
    work();
  } catch (const sql::Failure& failure) {
    if (failure.trouble() != sql::Trouble::other) throw;
    throw BrokenParcel{failure.what()};
  }
}

}  // namespace

void send_datasets(sql::Connection& db, const std::vector<DatasetId>& ids,
                   const std::function<void(std::string_view)>& send) {
  const std::vector<std::string> tables = tables_of_data(db);
  for (const DatasetId& id : ids) {
    send_rows(db, "dataset", "id = ?1", id.value, send);
    for (const std::string& table : tables) {
      // The unary plus prevents use of an index, so that rows without numbers keep their order.
      const std::string chosen = "+dataset_row = (SELECT row FROM dataset WHERE id = ?1)";
      send_rows(db, table, chosen, id.value, send);
      if (const std::string boxes = boxes_of(table); sql::has_table(db, boxes))
        send_rows(db, boxes, "row IN (SELECT row FROM " + table + " WHERE " + chosen + ")", id.value, send);
    }
  }
}

DatasetReceiver::DatasetReceiver(sql::Connection& db) : db_{db}, transaction_{db} {
  sql::defer_references(db_);
  open_table("dataset");
  for (const std::string& table : tables_of_data(db_)) {
    open_table(table);
    if (sql::has_table(db_, boxes_of(table))) open_table(boxes_of(table));
  }
}

void DatasetReceiver::open_table(const std::string& name) {
  std::vector<sql::Column> columns = sql::columns_of(db_, name);
  std::string values;
  for (std::size_t i = 0; i < columns.size(); ++i) values += (i == 0 ? "?" : ", ?") + std::to_string(i + 1);
  // A trigger may already have inserted the same box.
  const bool may_be_there = name.ends_with(boxes_of(""));
  auto insert = std::make_unique<sql::Statement>(
      db_, std::string{may_be_there ? "INSERT OR REPLACE" : "INSERT"} + " INTO " + name + " (" +
               names_of(columns) + ") VALUES (" + values + ")");
  tables_.emplace(name, Table{std::move(columns), std::move(insert)});
}

void DatasetReceiver::insert_row(Table& table, std::string_view& values) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    bind_value(*table.insert, static_cast<int>(i) + 1, table.columns[i], values);
  table.insert->run();
}

void DatasetReceiver::take(std::string_view parcel) {
  const auto length = static_cast<unsigned char>(number<char>(parcel));
  const auto table = tables_.find(cut(parcel, length));
  if (table == tables_.end()) throw BrokenParcel{"rows of a table that holds no data"};
  blaming_the_sender([&] {
    while (!parcel.empty()) insert_row(table->second, parcel);
  });
}

std::vector<DatasetId> DatasetReceiver::finish() {
  tables_.clear();
  blaming_the_sender([&] { transaction_.commit(); });
  std::vector<DatasetId> ids;
  for (const Dataset& dataset : checked_datasets(db_)) ids.push_back(dataset.id);
  return ids;
}

}  // namespace floeplan::repository
