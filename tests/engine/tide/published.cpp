#include "tests/engine/tide/published.hpp"

#include <chrono>
#include <cmath>
#include <fstream>

#include "tests/support/places.hpp"

namespace floeplan::tide::test {

std::optional<std::filesystem::path> published(const std::string& name) {
  const auto file = std::filesystem::path{support::source_folder()} / "../shared/data/env/tides" / name;
  if (!std::filesystem::exists(file)) return std::nullopt;
  return file;
}

std::vector<std::vector<std::string>> rows_of(const std::filesystem::path& file,
                                              const std::string& separators) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream in{file};
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> fields;
    std::size_t begin = 0;
    while ((begin = line.find_first_not_of(separators + "\r", begin)) != std::string::npos) {
      const std::size_t end = line.find_first_of(separators + "\r", begin);
      fields.push_back(line.substr(begin, end - begin));
      begin = end;
    }
    rows.push_back(std::move(fields));
  }
  return rows;
}

core::UtcTime utc(int year, unsigned month, unsigned day, int hour, int minute, int second) {
  const std::chrono::sys_days date =
      std::chrono::year{year} / std::chrono::month{month} / std::chrono::day{day};
  return core::UtcTime{date} + core::Seconds{3600.0 * hour + 60.0 * minute + second};
}

double rms(const std::vector<double>& residuals) {
  double sum = 0.0;
  for (const double residual : residuals) sum += residual * residual;
  return std::sqrt(sum / static_cast<double>(residuals.size()));
}

double largest(const std::vector<double>& residuals) {
  double result = 0.0;
  for (const double residual : residuals) result = std::max(result, std::abs(residual));
  return result;
}

}  // namespace floeplan::tide::test
