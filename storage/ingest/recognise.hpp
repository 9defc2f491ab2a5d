#pragma once

#include <filesystem>

#include "storage/ingest/data_format.hpp"

namespace floeplan::ingest {

/// Finds out which kinds of data a file holds, by its content and never by its name.
/// Errors   format_of refuses the file; the file holds nothing that this program reads, or not the kind that
///          the user asked for
[[nodiscard]] Checked<RecognisedFile> recognise(const std::filesystem::path& file,
                                                const Expectation& expected);

}  // namespace floeplan::ingest
