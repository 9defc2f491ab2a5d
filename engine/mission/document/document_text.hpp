#pragma once

#include <string>
#include <vector>

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// Writes the document as a file, with its comments and with unknown arguments: ASCII, LF, one blank between
/// words. Reading that text and writing it again gives the same bytes.
/// Edges    characters of comments outside ASCII become '?'
/// Errors   std::invalid_argument for a rejected document
[[nodiscard]] std::string write_document(const Document& document);

/// Names of the argument files that a mission needs, one for each behavior that names one.
[[nodiscard]] std::vector<std::string> files_referenced(const Document& document);

}  // namespace floeplan::mission
