#pragma once

#include <string>
#include <vector>

#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// The document as a file again, with its comments and with arguments that nobody here knows: ASCII, LF, one
/// blank between words. Reading that text and writing it again gives the same bytes.
/// Edges    characters of comments beyond ASCII become '?'
/// Errors   std::invalid_argument for a rejected document
[[nodiscard]] std::string write_document(const Document& document);

/// Names of the argument files that a mission asks for, one for each behavior that names one.
[[nodiscard]] std::vector<std::string> files_referenced(const Document& document);

}  // namespace floeplan::mission
