#include <gdal_priv.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/formats/zarr/zarr3_description.hpp"
#include "storage/ingest/notation/stated_depth.hpp"
#include "storage/ingest/notation/stated_period.hpp"
#include "storage/ingest/readers/bathymetry/depth_table.hpp"
#include "storage/ingest/readers/icebergs/iceberg_readers.hpp"
#include "storage/ingest/readers/tides/tide_readers.hpp"
#include "storage/ingest/readers/tracks/track_readers.hpp"

namespace {

namespace fs = std::filesystem;
using namespace floeplan::ingest;

void expect(bool held) {
  if (!held) std::abort();
}

/// A file that was read has rows; a refused file has a reason.
void check(const Checked<PreparedDataset>& read) {
  if (read)
    expect(read->rows_accepted > 0);
  else
    expect(!read.error().empty());
}

/// In memory, because a file system would take most of the time; a separate file for each fuzzing process.
fs::path place_of_file() { return "/dev/shm/floeplan-file-fuzz-" + std::to_string(getpid()); }

void write(const fs::path& file, std::string_view bytes) {
  std::ofstream out{file, std::ios::binary};
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void read_as(std::size_t reader, const fs::path& file) {
  switch (reader) {
    case 0: check(read_ice_patrol_csv(file)); break;
    case 1: check(read_own_iceberg_table(file)); break;
    case 2: check(read_iceberg_table(file)); break;
    case 3: check(read_iceberg_list_json(file)); break;
    case 4: check(read_tide_json(file, {})); break;
    case 5: check(read_tide_table(file, {})); break;
    case 6: check(read_otps_extract(file)); break;
    case 7: check(read_slocum_tracks({file}, {})); break;
    default: {
      const auto table = open_depth_table(file);
      expect(table ? *table != nullptr : !table.error().empty());
    }
  }
}

void check_texts(std::string_view text) {
  static_cast<void>(stated_interval(text));
  static_cast<void>(mentions_date(text));
  static_cast<void>(stated_depths(text, "m"));
  static_cast<void>(zarr3_array(text));
  static_cast<void>(zarr3_attributes(text));
}

}  // namespace

/// Prepares the libraries like the process that reads files.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  register_drivers();
  return 0;
}

/// The first byte chooses the reader, as a letter from 'a'; the others are the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t readers = 9;
  if (size == 0) return 0;
  const std::string_view bytes{reinterpret_cast<const char*>(data) + 1, size - 1};
  const fs::path file = place_of_file();
  write(file, bytes);
  read_as((data[0] - std::size_t{'a'}) % readers, file);
  fs::remove(file);
  check_texts(bytes);
  return 0;
}
