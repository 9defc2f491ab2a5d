#pragma once

#include <string>
#include <vector>

namespace floeplan::ingest {

/// The faults of a file one below the other, as a refusal tells them; of a great many the first, and how many more.
[[nodiscard]] std::string report_of(std::vector<std::string> faults);

}  // namespace floeplan::ingest
