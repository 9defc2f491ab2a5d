#include "storage/sql/sqlite/damaged_pages.hpp"

#include <chrono>
#include <cstddef>
#include <span>
#include <thread>

#include "storage/sql/sqlite/page_checksums.hpp"

namespace floeplan::sql::sqlite {
namespace {

/// Whether a page stays unlike its checksum: who writes it at this moment has done so a little later.
bool stays_damaged(sqlite3* database, std::uint64_t offset, std::size_t page_bytes) {
  constexpr int looks = 5;
  constexpr std::chrono::milliseconds between{20};
  for (int look = 0; look < looks; ++look) {
    if (look > 0) std::this_thread::sleep_for(between);
    const auto page = bytes_in_file(database, offset, page_bytes);
    if (page.size() < page_bytes || is_whole_page(page)) return false;  // cut off meanwhile, or whole
  }
  return true;
}

}  // namespace

bool has_page_checksums(sqlite3* database) {
  return layout_of_pages(bytes_in_file(database, 0, header_bytes)).has_checksums;
}

std::vector<std::uint32_t> damaged_pages(sqlite3* database) {
  const auto header = bytes_in_file(database, 0, header_bytes);
  if (header.empty()) return {};  // a database that nothing was moved to yet
  const PageLayout layout = layout_of_pages(header);
  if (layout.page_bytes == 0 || !layout.has_checksums) return {1};
  constexpr std::size_t pages_at_once = 256;
  const std::size_t size = layout.page_bytes;
  std::vector<std::uint32_t> damaged;
  for (std::uint64_t first = 0;; first += pages_at_once) {
    const auto block = bytes_in_file(database, first * size, pages_at_once * size);
    const std::span pages{block};
    for (std::size_t i = 0; (i + 1) * size <= pages.size(); ++i)
      if (!is_whole_page(pages.subspan(i * size, size)) && stays_damaged(database, (first + i) * size, size))
        damaged.push_back(static_cast<std::uint32_t>(first + i + 1));
    if (block.size() < pages_at_once * size) return damaged;
  }
}

}  // namespace floeplan::sql::sqlite
