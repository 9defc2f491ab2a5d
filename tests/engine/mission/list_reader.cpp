#include "tests/engine/mission/list_reader.hpp"

#include <algorithm>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace floeplan::support {
namespace {

std::vector<std::string> significant_lines(const std::string& text) {
  if (!text.ends_with('\n')) throw std::runtime_error{"no newline at the end"};
  if (std::any_of(text.begin(), text.end(),
                  [](char c) { return (c < ' ' || c > '~') && c != '\n' && c != '\t'; })) {
    throw std::runtime_error{"a character that is not ASCII text"};
  }
  std::vector<std::string> kept;
  std::istringstream lines{text};
  for (std::string line; std::getline(lines, line);) {
    if (line.size() >= 100) throw std::runtime_error{"line too long: " + line};
    line.erase(std::find(line.begin(), line.end(), '#'), line.end());
    if (line.find_first_not_of(" \t") != std::string::npos) kept.push_back(line);
  }
  return kept;
}

}  // namespace

double degrees_of_packed(const std::string& text) {
  static const std::regex shape{R"((-?)(\d{2,3})(\d{2}\.\d{4}))"};
  std::smatch parts;
  if (!std::regex_match(text, parts, shape)) throw std::runtime_error{"not a packed angle: " + text};
  const double minutes = std::stod(parts[3]);
  if (minutes >= 60.0) throw std::runtime_error{"sixty minutes or more: " + text};
  const double size_deg = std::stod(parts[2]) + minutes / 60.0;
  return parts[1].length() > 0 ? -size_deg : size_deg;
}

ReadList read_goto_list(const std::string& text) {
  static const std::regex argument{R"(\tb_arg: ([a-z_]+\([a-z]+\)) (-?\d+(\.\d+)?))"};
  static const std::regex row{R"((\S+)\t(\S+))"};
  enum class Section { behavior, before_arguments, arguments, before_waypoints, waypoints, done };

  ReadList list;
  Section section = Section::behavior;
  const auto expect = [&](const std::string& line, const char* wanted, Section next) {
    if (line != wanted) throw std::runtime_error{"expected " + std::string{wanted} + ", found " + line};
    section = next;
  };
  for (const std::string& line : significant_lines(text)) {
    std::smatch parts;
    switch (section) {
      case Section::behavior: expect(line, "behavior_name=goto_list", Section::before_arguments); break;
      case Section::before_arguments: expect(line, "<start:b_arg>", Section::arguments); break;
      case Section::arguments:
        if (!std::regex_match(line, parts, argument)) {
          expect(line, "<end:b_arg>", Section::before_waypoints);
        } else if (!list.b_args.emplace(parts[1], std::stod(parts[2])).second) {
          throw std::runtime_error{"given twice: " + line};
        }
        break;
      case Section::before_waypoints: expect(line, "<start:waypoints>", Section::waypoints); break;
      case Section::waypoints:
        if (!std::regex_match(line, parts, row)) {
          expect(line, "<end:waypoints>", Section::done);
        } else {
          list.waypoints.push_back({degrees_of_packed(parts[1]), degrees_of_packed(parts[2])});
        }
        break;
      case Section::done: throw std::runtime_error{"after the end: " + line};
    }
  }
  if (section != Section::done) throw std::runtime_error{"a section is not closed"};
  return list;
}

}  // namespace floeplan::support
