#include <cstddef>
#include <cstdint>
#include <string_view>

#include "storage/repository/datasets/dataset_rows.hpp"
#include "storage/repository/store/migrations.hpp"

/// Rows from a process that a hostile file has taken over: they are accepted or refused, without other
/// effects.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace repository = floeplan::repository;
  static auto db = repository::open_store_in_memory();
  repository::DatasetReceiver receiver{db};  // what it accepted is lost with it
  try {
    receiver.take({reinterpret_cast<const char*>(data), size});
  } catch (const repository::BrokenParcel&) {
  }
  return 0;
}
