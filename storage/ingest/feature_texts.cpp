#include "storage/ingest/feature_texts.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <ogr_feature.h>

#include <memory>

#include "engine/core/letter_case.hpp"
#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

std::string as_utf8(const char* text) {
  if (CPLIsUTF8(text, -1) != 0) return trimmed(text);
  const std::unique_ptr<char, decltype(&VSIFree)> recoded{CPLRecode(text, CPL_ENC_ISO8859_1, CPL_ENC_UTF8),
                                                          &VSIFree};
  return trimmed(recoded.get());
}

}  // namespace

std::optional<std::string> text_of_feature(const OGRFeature& feature,
                                           std::span<const std::string_view> names) {
  for (const std::string_view name : names) {
    for (int i = 0; i < feature.GetFieldCount(); ++i) {
      if (core::plain_word(feature.GetFieldDefnRef(i)->GetNameRef()) != name ||
          feature.IsFieldSetAndNotNull(i) == 0)
        continue;
      if (std::string text = as_utf8(feature.GetFieldAsString(i)); !text.empty()) return text;
    }
  }
  return std::nullopt;
}

}  // namespace floeplan::ingest
