#pragma once

#include <string>
#include <vector>

#include "api/fields/process_fields.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::cli {

/// A flag of a command, with the member of the inputs that it sets.
struct InputFlag {
  std::string pointer;  // JSON pointer in the inputs: "/current_error/rms_m_s"
  std::string flag;     // "--current-error"; for an argument its name, "PLAN"
};

/// The flags for the fields of a process.
[[nodiscard]] std::vector<InputFlag> flags_of(fields::Process process);

/// A violation in the terms of the command line: "--from is required: the start, as LON,LAT". JSON pointers, quoted
/// names of members and arrays are replaced by flags and their notation. The text that the user gave is not changed.
[[nodiscard]] std::string in_words_of_flags(const core::Violation& violation,
                                            const std::vector<InputFlag>& flags);

/// Prints all violations on stderr and, for scripts, with JSON pointers on stdout. Returns the exit code.
int print_violations(const core::Violations& violations, bool json_out,
                     const std::vector<InputFlag>& flags = {});

}  // namespace floeplan::cli
