#include "storage/ingest/notation/table_text.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>

#include <memory>

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {

std::string table_text(const char* text) {
  if (CPLIsUTF8(text, -1) != 0) return trimmed(text);
  const std::unique_ptr<char, decltype(&VSIFree)> recoded{CPLRecode(text, CPL_ENC_ISO8859_1, CPL_ENC_UTF8),
                                                          &VSIFree};
  return trimmed(recoded.get());
}

}  // namespace floeplan::ingest
