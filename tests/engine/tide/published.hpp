#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::tide::test {

/// A file of the published samples; empty when the samples are not on this machine.
std::optional<std::filesystem::path> published(const std::string& name);

/// The fields of each line, cut at any of the separators; empty fields are dropped.
std::vector<std::vector<std::string>> rows_of(const std::filesystem::path& file,
                                              const std::string& separators);

core::UtcTime utc(int year, unsigned month, unsigned day, int hour = 0, int minute = 0, int second = 0);

/// Square root of the mean of the squares.
double rms(const std::vector<double>& residuals);
double largest(const std::vector<double>& residuals);

}  // namespace floeplan::tide::test
