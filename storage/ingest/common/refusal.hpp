#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace floeplan::ingest {

/// A value, or why the file is refused: one sentence for a pilot in the form "what; why; what to do", or several of
/// them, one a line.
template <class T>
using Checked = tl::expected<T, std::string>;

[[nodiscard]] inline tl::unexpected<std::string> refuse(std::string sentence) {
  return tl::unexpected<std::string>(std::move(sentence));
}

}  // namespace floeplan::ingest
