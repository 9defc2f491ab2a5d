#include "engine/simulation/logs/log_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "engine/messages/flight_fault_messages.hpp"

namespace floeplan::simulation {
namespace {

constexpr std::size_t most_bytes = 256UL * 1024 * 1024;
constexpr std::size_t most_faults = 10;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Format of the text of a log.
struct Layout {
  bool by_blanks{};       // fields are separated by blanks, not by commas
  int lines_of_labels{};  // lines after the names to skip; 0: a line of units is recognised by its words
};

std::vector<std::string_view> fields_of(std::string_view line, const Layout& layout) {
  std::vector<std::string_view> fields;
  if (layout.by_blanks) {
    while (!line.empty()) {
      const auto end = line.find_first_of(" \t");
      fields.push_back(line.substr(0, end));
      line = end == std::string_view::npos ? std::string_view{} : trimmed(line.substr(end));
    }
    return fields;
  }
  for (;;) {
    const auto comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

/// Whether the vendor's program dbd2asc made the text from a binary log: tags, names, units, sizes in bytes,
/// rows, all separated by blanks.
bool is_converted(std::string_view text) {
  const std::string_view first = text.substr(0, text.find('\n'));
  return first.starts_with("dbd_label:") && first.find("DBD_ASC") != std::string_view::npos;
}

/// Whether the line is a tag "key: value", which the vendor's converter writes before the names.
bool is_tag(std::string_view line) {
  const auto colon = line.find(':');
  return colon != std::string_view::npos && line.find_first_of(" \t,") > colon;
}

/// Empty if the text is not a number. The inner optional is empty for an empty field and for nan.
std::optional<std::optional<double>> number(std::string_view field) {
  if (field.empty()) return std::optional<double>{};
  double value = 0.0;
  const auto [end, fault] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (fault != std::errc{} || end != field.data() + field.size()) return std::nullopt;
  return std::isfinite(value) ? std::optional{value} : std::optional<double>{};
}

/// Whether the field is a sensor's name, such as "m_depth".
bool is_name(std::string_view field) {
  return !field.empty() && std::ranges::all_of(field, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

bool is_units(const std::vector<std::string_view>& fields) {
  return std::ranges::none_of(fields, [](std::string_view field) { return !field.empty() && number(field); });
}

}  // namespace

tl::expected<LogTable, core::Violations> LogTable::read(std::string_view text,
                                                        std::span<const std::string_view> wanted) {
  core::Violations found;
  if (text.size() > most_bytes)
    return tl::unexpected(core::Violations{messages::flight_fault<"log-too-large">("/file")});
  std::vector<std::string> names;
  std::vector<Column> columns;
  std::vector<bool> kept;
  std::vector<std::string> units;
  Layout layout;
  if (is_converted(text)) layout = {.by_blanks = true, .lines_of_labels = 2};
  int rows_seen = 0;
  std::size_t rows = 0;
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const auto end = text.find('\n');
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.empty() || line.front() == '#') continue;
    if (layout.by_blanks && names.empty() && is_tag(line)) continue;
    const auto fields = fields_of(line, layout);
    if (names.empty()) {
      if (!std::ranges::all_of(fields, is_name)) break;
      names.assign(fields.begin(), fields.end());
      columns.resize(names.size());
      for (const std::string& name : names)
        kept.push_back(wanted.empty() || std::ranges::find(wanted, name) != wanted.end());
      continue;
    }
    ++rows_seen;
    const bool are_units = rows_seen == 1 && (layout.lines_of_labels > 0 || is_units(fields));
    if (are_units) units.assign(fields.begin(), fields.end());
    if (are_units || rows_seen <= layout.lines_of_labels) continue;
    if (fields.size() > names.size()) {
      found.push_back(
          messages::flight_fault<"more-fields-than-names">("/line " + std::to_string(line_number)));
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto value = i < fields.size() ? number(fields[i]) : std::optional{std::optional<double>{}};
      if (!value) {
        found.push_back(messages::flight_fault<"log-not-a-number">(
            "/line " + std::to_string(line_number) + "/" + names[i], fields[i].substr(0, 40)));
      }
      if (kept[i]) columns[i].push_back(value.value_or(std::nullopt));
    }
    ++rows;
    if (found.size() >= most_faults) break;
  }
  if (names.empty()) found.push_back(messages::flight_fault<"log-without-names">("/file"));
  if (!found.empty()) return tl::unexpected(std::move(found));

  LogTable table;
  table.rows_ = rows;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (kept[i]) table.columns_.emplace(names[i], std::move(columns[i]));
  for (std::size_t i = 0; i < std::min(names.size(), units.size()); ++i)
    if (kept[i]) table.units_.emplace(names[i], std::move(units[i]));
  return table;
}

LogTable LogTable::of(std::map<std::string, Column> columns, std::map<std::string, std::string> units,
                      std::size_t rows) {
  LogTable table;
  table.columns_ = std::move(columns);
  table.units_ = std::move(units);
  table.rows_ = rows;
  return table;
}

std::string LogTable::unit(const std::string& name) const {
  const auto found = units_.find(name);
  return found != units_.end() ? found->second : std::string{};
}

void LogTable::change(const std::string& name, const std::function<std::optional<double>(double)>& value) {
  const auto column = columns_.find(name);
  if (column == columns_.end()) return;
  for (std::optional<double>& field : column->second)
    if (field) field = value(*field);
}

std::optional<double> LogTable::before(const std::string& name, std::size_t row) const {
  const Column& column = columns_.at(name);
  for (std::size_t i = std::min(row + 1, column.size()); i-- > 0;) {
    if (column[i]) return column[i];
  }
  return std::nullopt;
}

}  // namespace floeplan::simulation
