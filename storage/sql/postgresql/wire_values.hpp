#pragma once

#include <libpq-fe.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "storage/sql/driver/driver.hpp"

namespace floeplan::sql::postgresql {

/// The types of values that this program sends and reads, by their numbers in the server's catalogue
/// (pg_type.dat).
enum class WireType : Oid {
  unknown = 0,
  boolean = 16,
  bytes = 17,
  int8 = 20,
  int2 = 21,
  int4 = 23,
  text = 25,
  float4 = 700,
  float8 = 701,
};

/// A value of a parameter in the server's binary form: numbers with their highest byte first.
struct WireValue {
  WireType type{};  // unknown: a parameter that was never bound, which is NULL
  bool is_null{true};
  std::vector<char> bytes;
};

[[nodiscard]] WireValue wire_null(ColumnType type);
[[nodiscard]] WireValue wire_value(std::int64_t value);
[[nodiscard]] WireValue wire_value(double value);
[[nodiscard]] WireValue wire_value(const std::string& value);
[[nodiscard]] WireValue wire_value(std::span<const std::byte> value);

/// A column of a row of a result in binary form, as another type where it has another.
/// Errors   Failure for a type that none of our statements asks for
[[nodiscard]] std::int64_t integer_at(const PGresult* result, int row, int column);
[[nodiscard]] double real_at(const PGresult* result, int row, int column);
[[nodiscard]] std::string text_at(const PGresult* result, int row, int column);
[[nodiscard]] std::span<const std::byte> bytes_at(const PGresult* result, int row, int column);

}  // namespace floeplan::sql::postgresql
