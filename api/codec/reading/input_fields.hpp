#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "api/codec/reading/input_reader.hpp"
#include "api/fields/table.hpp"

/// Reads and writes JSON according to the table of request fields.
namespace floeplan::codec {

/// The value of the field's member; empty if it is absent or wrong, and a wrong one is a violation.
/// Precondition  the field is a number, a boolean, a word, a text, a time, or names datasets
[[nodiscard]] std::optional<fields::Value> read_value(InputReader& reader, const fields::Field& field);

/// Adds the member that `read_value` reads; null if there is no value.
void write_value(const fields::Field& field, const std::optional<fields::Value>& value,
                 nlohmann::json& inputs);

/// Reads all rows of a table into their members; a member that the request does not have keeps its value.
template <class Values>
void read_fields(InputReader& reader, const fields::Table<Values>& table, Values& values) {
  for (const fields::Bound<Values>& row : table) {
    if (const auto value = read_value(reader, row.field)) row.set(values, *value);
  }
}

/// Adds the members that `read_fields` reads, with all defaults filled in.
template <class Values>
void write_fields(const fields::Table<Values>& table, const Values& values, nlohmann::json& inputs) {
  for (const fields::Bound<Values>& row : table) write_value(row.field, row.get(values), inputs);
}

}  // namespace floeplan::codec
