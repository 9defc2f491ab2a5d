#include "storage/repository/fields/tide_repository.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "engine/messages/store_messages.hpp"
#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

using ocean::TideQuantity;

constexpr std::array quantities{std::pair{TideQuantity::elevation, "elevation"},
                                std::pair{TideQuantity::east, "east"},
                                std::pair{TideQuantity::north, "north"}};

std::string quantity_name(TideQuantity quantity) {
  for (const auto& [candidate, name] : quantities)
    if (candidate == quantity) return name;
  throw std::logic_error{"TideQuantity without a name"};
}

std::optional<TideQuantity> parse_quantity(const std::string& text) {
  for (const auto& [quantity, name] : quantities)
    if (text == name) return quantity;
  return std::nullopt;
}

/// Names of the stored variables: "M2 east cosine" has the real part, "M2 east sine" the imaginary part.
std::string variable_of(tide::Constituent constituent, TideQuantity quantity, bool imaginary) {
  return tide::constituent_name(constituent) + " " + quantity_name(quantity) +
         (imaginary ? " sine" : " cosine");
}

ocean::TideGrid::Field joined(std::span<const float> real, std::span<const float> imaginary) {
  ocean::TideGrid::Field field;
  field.reserve(real.size());
  for (std::size_t i = 0; i < real.size(); ++i) field.emplace_back(real[i], imaginary[i]);
  return field;
}

tide::Constituent constituent_of(const std::string& name) {
  const auto constituent = tide::find_constituent(name);
  if (!constituent)
    throw std::runtime_error{messages::store_text<"stored-word-unknown">("a tide's constituent", name)};
  return *constituent;
}

}  // namespace

void TideRepository::create(const DatasetId& id, const ocean::HorizontalGrid& grid) {
  FieldRepository{db_}.create(id, {grid, std::nullopt, std::nullopt});
}

void TideRepository::write(const DatasetId& id, tide::Constituent constituent, TideQuantity quantity,
                           std::span<const std::complex<float>> field) {
  std::vector<float> real;
  std::vector<float> imaginary;
  for (const std::complex<float>& value : field) {
    real.push_back(value.real());
    imaginary.push_back(value.imag());
  }
  FieldRepository fields{db_};
  fields.write_slice(id, variable_of(constituent, quantity, false), 0, 0, real);
  fields.write_slice(id, variable_of(constituent, quantity, true), 0, 0, imaginary);
}

std::optional<ocean::TideGrid> TideRepository::load(const DatasetId& id, const geo::BoundingBox& area) const {
  const FieldRepository fields{db_};
  const std::vector<std::string> stored = fields.variables(id);
  const auto has = [&](const std::string& variable) { return std::ranges::binary_search(stored, variable); };
  std::vector<std::string> wanted;
  std::vector<std::pair<tide::Constituent, TideQuantity>> meaning;
  for (const tide::Constituent constituent : tide::all_constituents()) {
    for (const auto& [quantity, name] : quantities) {
      if (!has(variable_of(constituent, quantity, false))) continue;
      wanted.push_back(variable_of(constituent, quantity, false));
      wanted.push_back(variable_of(constituent, quantity, true));
      meaning.emplace_back(constituent, quantity);
    }
  }
  const auto planes = fields.load_planes(id, area, wanted);
  if (!planes) return std::nullopt;

  ocean::TideGrid::Samples samples{planes->grid, {}};
  for (std::size_t i = 0; i < meaning.size(); ++i) {
    const auto& [constituent, quantity] = meaning[i];
    if (samples.lines.empty() || samples.lines.back().constituent != constituent)
      samples.lines.push_back({constituent, {}, {}, {}});
    ocean::TideGrid::Line& line = samples.lines.back();
    auto& field = quantity == TideQuantity::elevation ? line.elevation
                  : quantity == TideQuantity::east    ? line.east
                                                      : line.north;
    field = joined(planes->values[2 * i], planes->values[2 * i + 1]);
  }
  return ocean::TideGrid{std::move(samples)};
}

void TideRepository::insert(const DatasetId& id, const std::vector<TideStation>& stations) {
  sql::Transaction transaction{db_};
  const std::int64_t dataset = dataset_row(db_, id);
  sql::Statement insert_station{
      db_,
      "INSERT INTO tide_station (dataset_row, position, name, lon_deg, lat_deg, quantity) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6)"};
  sql::Statement insert_constant{
      db_,
      "INSERT INTO tide_constant (dataset_row, position, constituent, cosine, sine) "
      "VALUES (?1, ?2, ?3, ?4, ?5)"};
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const TideStation& station = stations[i];
    const auto position = static_cast<std::int64_t>(i);
    insert_station.bind_all(dataset, position, station.name, station.place.lon_deg, station.place.lat_deg,
                            quantity_name(station.quantity));
    insert_station.run();
    for (const tide::HarmonicConstant& constant : station.constants) {
      insert_constant.bind_all(dataset, position, tide::constituent_name(constant.constituent),
                               constant.value.real(), constant.value.imag());
      insert_constant.run();
    }
  }
  transaction.commit();
}

std::vector<TideStation> TideRepository::stations(const DatasetId& id) const {
  sql::Statement query{
      db_,
      "SELECT position, name, lon_deg, lat_deg, quantity FROM tide_station WHERE dataset_row = "
      "(SELECT row FROM dataset WHERE id = ?1) ORDER BY position"};
  query.bind(1, id.value);
  std::vector<TideStation> result;
  while (query.step()) {
    const auto quantity = parse_quantity(query.text(4));
    if (!quantity)
      throw std::runtime_error{
          messages::store_text<"stored-word-unknown">("a tide's quantity", query.text(4))};
    result.push_back({query.text(1), {query.real(2), query.real(3)}, *quantity, {}});
  }
  sql::Statement constants{
      db_,
      "SELECT position, constituent, cosine, sine FROM tide_constant WHERE dataset_row = "
      "(SELECT row FROM dataset WHERE id = ?1) ORDER BY position, row"};
  constants.bind(1, id.value);
  while (constants.step())
    result.at(static_cast<std::size_t>(constants.integer(0)))
        .constants.push_back({constituent_of(constants.text(1)), {constants.real(2), constants.real(3)}});
  return result;
}

}  // namespace floeplan::repository
