#include "storage/ingest/notation/delimited_text.hpp"

#include <algorithm>
#include <utility>

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

char separator_of(std::string_view header) {
  for (const char separator : {'\t', ';', ','})
    if (header.find(separator) != std::string_view::npos) return separator;
  return ' ';
}

std::string plain_name(std::string_view column) {
  std::string name;
  for (const char c : lower(column)) {
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  if (name.ends_with('_')) name.pop_back();
  return name;
}

}  // namespace

DelimitedText::DelimitedText(std::string_view header) : separator_{separator_of(header)} {
  if (header.starts_with("\xEF\xBB\xBF")) header.remove_prefix(3);
  for (std::string& name : fields(header)) {
    std::string plain = plain_name(name);
    if (separator_ == ' ' && plain.empty()) continue;  // a comment mark on its own
    columns_.push_back(std::move(plain));
    headers_.push_back(std::move(name));
  }
}

std::optional<std::size_t> DelimitedText::column(const std::vector<std::string_view>& names) const {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (std::ranges::find(names, columns_[i]) == names.end()) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

std::vector<std::string> DelimitedText::fields(std::string_view line) const {
  std::vector<std::string> fields;
  if (trimmed(line).empty()) return fields;
  fields.emplace_back();
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == separator_ && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  for (std::string& field : fields) field = trimmed(field);
  if (separator_ == ' ') std::erase(fields, "");
  return fields;
}

std::optional<double> DelimitedText::number(std::string_view field) const {
  std::string text{field};
  if (separator_ != ',') std::ranges::replace(text, ',', '.');
  return parse_number(text);
}

bool names_water_properties(std::string_view header) {
  const DelimitedText table{header};
  return std::ranges::any_of(table.columns(), [](const std::string& name) {
    return name == "temp" || name == "cond" || name == "psal" ||
           contains_any(name,
                        {"temperature", "salinity", "conductivity", "chlorophyll", "oxygen", "sci_water"});
  });
}

std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

bool is_number_table(std::string_view head) {
  int lines = 0;
  while (lines < 5 && head.find('\n') != std::string_view::npos) {
    std::string line{head.substr(0, head.find('\n'))};
    head.remove_prefix(line.size() + 1);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == ',' || c == ';' || c == '\t' || c == '\r'; }, ' ');
    int numbers = 0;
    std::string_view rest = line;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      if (end > 0 && !parse_number(rest.substr(0, end))) return false;
      numbers += end > 0 ? 1 : 0;
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (numbers < 3) return false;
    ++lines;
  }
  return lines > 0;
}

}  // namespace floeplan::ingest
