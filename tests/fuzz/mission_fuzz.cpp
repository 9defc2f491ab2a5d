#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "engine/mission/document/document_text.hpp"
#include "engine/mission/reading/read_document.hpp"

namespace {

using namespace floeplan::mission;

/// A file that is not rejected can be written; the written file is not rejected, and writing it again gives
/// the same text.
void check(const char* name, std::string_view bytes) {
  const Document read = read_document(name, bytes);
  if (read.verdict() == Verdict::reject) return;
  const std::string written = write_document(read);
  if (written.size() > 60'000) return;  // inserted blanks may exceed the reader's limit
  const Document again = read_document(name, written);
  if (again.verdict() == Verdict::reject || write_document(again) != written ||
      again.waypoints.size() != read.waypoints.size()) {
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes{reinterpret_cast<const char*>(data), size};
  for (const char* name : {"goto_l10.ma", "stock.mi", "targets", "science", "cmdfile", "upload"})
    check(name, bytes);
  return 0;
}
