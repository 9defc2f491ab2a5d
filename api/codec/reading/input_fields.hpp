#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "api/codec/reading/input_reader.hpp"
#include "api/fields/table.hpp"

/// JSON by the table of request fields.
namespace floeplan::codec {

/// The member that the field names; empty where it is absent or wrong, and what is wrong is noted.
/// Precondition  the field is a number, a boolean, a word, a text, a time, or names datasets
[[nodiscard]] std::optional<fields::Value> read_value(InputReader& reader, const fields::Field& field);

/// Adds the member that `read_value` reads; null for none.
void write_value(const fields::Field& field, const std::optional<fields::Value>& value,
                 nlohmann::json& inputs);

/// Reads every row of a table into the member that it stands for, which stays as it is where the request says nothing.
template <class Values>
void read_fields(InputReader& reader, const fields::Table<Values>& table, Values& values) {
  for (const fields::Bound<Values>& row : table) {
    if (const auto value = read_value(reader, row.field)) row.set(values, *value);
  }
}

/// Adds the members that `read_fields` reads, every default written out.
template <class Values>
void write_fields(const fields::Table<Values>& table, const Values& values, nlohmann::json& inputs) {
  for (const fields::Bound<Values>& row : table) write_value(row.field, row.get(values), inputs);
}

}  // namespace floeplan::codec
