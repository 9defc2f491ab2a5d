#include "storage/sql/postgresql/wire_values.hpp"

#include <bit>
#include <cmath>
#include <concepts>

#include "storage/sql/driver/failure.hpp"

namespace floeplan::sql::postgresql {
namespace {

template <std::unsigned_integral Bits>
std::vector<char> highest_first(Bits bits) {
  std::vector<char> bytes(sizeof bits);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<char>(static_cast<unsigned char>(bits >> (8 * (bytes.size() - 1 - i))));
  return bytes;
}

template <std::unsigned_integral Bits>
Bits from_highest_first(const PGresult* result, int row, int column) {
  const std::span<const std::byte> bytes = bytes_at(result, row, column);
  if (bytes.size() != sizeof(Bits))
    throw Failure{"the server sent a number of another length than its type has"};
  std::uint64_t bits = 0;
  for (const std::byte byte : bytes) bits = (bits << 8U) | static_cast<std::uint64_t>(byte);
  return static_cast<Bits>(bits);
}

WireType type_at(const PGresult* result, int column) { return WireType{PQftype(result, column)}; }

}  // namespace

WireValue wire_null(ColumnType type) {
  switch (type) {
    case ColumnType::integer: return {WireType::int8, true, {}};
    case ColumnType::real: return {WireType::float8, true, {}};
    case ColumnType::text: return {WireType::text, true, {}};
    case ColumnType::blob: return {WireType::bytes, true, {}};
  }
  return {};
}

WireValue wire_value(std::int64_t value) {
  return {WireType::int8, false, highest_first(std::bit_cast<std::uint64_t>(value))};
}

WireValue wire_value(double value) {
  return {WireType::float8, false, highest_first(std::bit_cast<std::uint64_t>(value))};
}

WireValue wire_value(const std::string& value) {
  return {WireType::text, false, {value.begin(), value.end()}};
}

WireValue wire_value(std::span<const std::byte> value) {
  const auto* const bytes = reinterpret_cast<const char*>(value.data());
  return {WireType::bytes, false, {bytes, bytes + value.size()}};
}

std::int64_t integer_at(const PGresult* result, int row, int column) {
  if (PQgetisnull(result, row, column) != 0) return 0;
  switch (type_at(result, column)) {
    case WireType::boolean: return from_highest_first<std::uint8_t>(result, row, column);
    case WireType::int2:
      return std::bit_cast<std::int16_t>(from_highest_first<std::uint16_t>(result, row, column));
    case WireType::int4:
      return std::bit_cast<std::int32_t>(from_highest_first<std::uint32_t>(result, row, column));
    case WireType::int8:
      return std::bit_cast<std::int64_t>(from_highest_first<std::uint64_t>(result, row, column));
    case WireType::float4:
    case WireType::float8: return static_cast<std::int64_t>(real_at(result, row, column));
    case WireType::unknown:
    case WireType::bytes:
    case WireType::text: break;
  }
  throw Failure{"a statement reads a number from a column that holds none"};
}

double real_at(const PGresult* result, int row, int column) {
  if (PQgetisnull(result, row, column) != 0) return 0.0;
  switch (type_at(result, column)) {
    case WireType::float4:
      return std::bit_cast<float>(from_highest_first<std::uint32_t>(result, row, column));
    case WireType::float8:
      return std::bit_cast<double>(from_highest_first<std::uint64_t>(result, row, column));
    default: return static_cast<double>(integer_at(result, row, column));
  }
}

std::string text_at(const PGresult* result, int row, int column) {
  return {PQgetvalue(result, row, column), static_cast<std::size_t>(PQgetlength(result, row, column))};
}

std::span<const std::byte> bytes_at(const PGresult* result, int row, int column) {
  return std::as_bytes(
      std::span{PQgetvalue(result, row, column), static_cast<std::size_t>(PQgetlength(result, row, column))});
}

}  // namespace floeplan::sql::postgresql
