#pragma once

#include <string>
#include <vector>

#include "api/fields/process_fields.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::cli {

/// A flag of a command and the part of its inputs that it sets.
struct InputFlag {
  std::string pointer;  // into the inputs, "/current_error/rms_m_s"
  std::string flag;     // "--current-error"; of an argument its name, "PLAN"
};

/// The flags that the fields of a process have.
[[nodiscard]] std::vector<InputFlag> flags_of(fields::Process process);

/// What is wrong, as somebody reads it who wrote flags and no JSON: "--from is required: the start, as LON,LAT".
/// Pointers, names of members in quotes and arrays become flags and their texts. What was given stays as it was written.
[[nodiscard]] std::string in_words_of_flags(const core::Violation& violation,
                                            const std::vector<InputFlag>& flags);

/// Names every violation on stderr, and for scripts, with pointers, on stdout too. Returns the exit code.
int print_violations(const core::Violations& violations, bool json_out,
                     const std::vector<InputFlag>& flags = {});

}  // namespace floeplan::cli
