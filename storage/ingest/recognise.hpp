#pragma once

#include <filesystem>

#include "storage/ingest/data_format.hpp"

namespace floeplan::ingest {

/// Finds out by content which kinds of data a file holds; its name plays no part.
/// Errors   what format_of refuses; a file that holds nothing this program reads, or not the kind that was
///          asked for
[[nodiscard]] Checked<RecognisedFile> recognise(const std::filesystem::path& file,
                                                const Expectation& expected);

}  // namespace floeplan::ingest
