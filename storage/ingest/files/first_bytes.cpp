#include "storage/ingest/files/first_bytes.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace floeplan::ingest {

std::string first_bytes(const std::filesystem::path& file, std::uintmax_t most) {
  std::error_code unknown;  // on an error file_size returns the largest number
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  std::string bytes(static_cast<std::size_t>(std::min(size, most)), '\0');
  std::ifstream in{file, std::ios::binary};
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

}  // namespace floeplan::ingest
