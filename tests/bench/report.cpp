#include "tests/bench/report.hpp"

#include <ctime>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace floeplan::bench {

std::optional<double> standing(const Row& row) {
  switch (row.gauge) {
    case Gauge::nothing: return std::nullopt;
    case Gauge::comparator: return row.ratio;
    case Gauge::time: return row.calibration_s / row.ours;
    case Gauge::rate: return row.calibration_s * row.ours;
  }
  throw std::logic_error{"Gauge without a standing"};
}

Row gauged_by(Gauge gauge, Row row) {
  row.gauge = gauge;
  return row;
}

Row more_is_better(std::string what, std::string unit, double ours, std::string comparator, double value) {
  return {std::move(what), std::move(unit), ours, std::move(comparator), value, ours / value};
}

Row less_is_better(std::string what, std::string unit, double ours, std::string comparator, double value) {
  return {std::move(what), std::move(unit), ours, std::move(comparator), value, value / ours};
}

std::string table_text(const std::vector<Row>& rows) {
  std::ostringstream out;
  out << std::left << std::setw(66) << "what" << std::right << std::setw(12) << "ours" << std::setw(12)
      << "comparator" << std::setw(9) << "ratio"
      << "  compared with; target\n";
  out << std::fixed;
  for (const Row& row : rows) {
    const auto digits = [](double value) { return value < 10.0 ? 3 : value < 1000.0 ? 1 : 0; };
    out << std::left << std::setw(66) << row.what + ", " + row.unit << std::right << std::setw(12)
        << std::setprecision(digits(row.ours)) << row.ours;
    if (row.comparator.empty()) {
      out << std::setw(12) << '-' << std::setw(9) << '-';
    } else {
      out << std::setw(12) << std::setprecision(digits(row.comparator_value)) << row.comparator_value
          << std::setw(9) << std::setprecision(2) << row.ratio;
    }
    out << "  " << row.comparator;
    if (row.meets_target) {
      out << (row.comparator.empty() ? "" : "; ") << row.target << (*row.meets_target ? ": met" : ": MISSED");
    }
    out << '\n';
  }
  return out.str();
}

std::string json_text(const std::vector<Row>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    nlohmann::ordered_json entry{
        {"group", row.group}, {"what", row.what}, {"unit", row.unit}, {"ours", row.ours}};
    if (!row.comparator.empty()) {
      entry["comparator"] = row.comparator;
      entry["comparator_value"] = row.comparator_value;
      entry["ratio"] = row.ratio;
    }
    if (row.meets_target) {
      entry["target"] = row.target;
      entry["meets_target"] = *row.meets_target;
    }
    if (const auto free_of_the_machine = standing(row)) entry["standing"] = *free_of_the_machine;
    list.push_back(std::move(entry));
  }
  return list.dump(2) + "\n";
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace floeplan::bench
