#include "storage/ingest/iso8211_records.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>

namespace floeplan::ingest {

Checked<std::size_t> iso8211_records(const std::filesystem::path& file) {
  constexpr std::uint64_t leader_octets = 24;
  std::ifstream in{file, std::ios::binary};
  const std::uint64_t size = std::filesystem::file_size(file);
  std::size_t records = 0;
  for (std::uint64_t at = 0; at < size; ++records) {
    std::array<char, 5> digits{};
    in.seekg(static_cast<std::streamoff>(at));
    in.read(digits.data(), digits.size());
    const bool number = in && std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
    const std::uint64_t length = number ? std::stoull(std::string{digits.data(), digits.size()}) : 0;
    if (length < leader_octets || length > size - at)
      return refuse("record " + std::to_string(records + 1) + " of \"" + file.filename().string() +
                    "\" is damaged or was cut short; copy or download it again");
    at += length;
  }
  return records;
}

}  // namespace floeplan::ingest
