#include "storage/sql/copies/rows_digest.hpp"

#include <xxhash.h>

#include <memory>
#include <new>
#include <span>
#include <string>

namespace floeplan::sql {
namespace {

struct FreeState {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

void add_bytes(XXH3_state_t* state, char kind, const void* bytes, std::size_t count) {
  const auto length = static_cast<std::uint64_t>(count);
  XXH3_128bits_update(state, &kind, 1);
  XXH3_128bits_update(state, &length, sizeof length);
  XXH3_128bits_update(state, bytes, count);
}

void add_value(XXH3_state_t* state, const Row& row, int column, ColumnType type) {
  if (row.is_null(column)) return add_bytes(state, 'n', "", 0);
  switch (type) {
    case ColumnType::integer: {
      const std::int64_t value = row.integer(column);
      return add_bytes(state, 'i', &value, sizeof value);
    }
    case ColumnType::real: {
      const double value = row.real(column);
      return add_bytes(state, 'r', &value, sizeof value);
    }
    case ColumnType::text: {
      const std::string value = row.text(column);
      return add_bytes(state, 't', value.data(), value.size());
    }
    case ColumnType::blob: {
      const std::span<const std::byte> value = row.blob(column);
      return add_bytes(state, 'b', value.data(), value.size());
    }
  }
}

}  // namespace

void RowsDigest::add(const Row& row, const std::vector<Column>& columns) {
  const std::unique_ptr<XXH3_state_t, FreeState> state{XXH3_createState()};
  if (!state) throw std::bad_alloc{};
  XXH3_128bits_reset(state.get());
  for (std::size_t i = 0; i < columns.size(); ++i)
    add_value(state.get(), row, static_cast<int>(i), columns[i].type);
  const XXH128_hash_t digest = XXH3_128bits_digest(state.get());
  ++count_;
  low_ += digest.low64;
  high_ += digest.high64;
}

}  // namespace floeplan::sql
