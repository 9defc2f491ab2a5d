#include "server/manual/plain_text.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>
#include <vector>

namespace floeplan::manual {
namespace {

/// The text with the command that prints a page behind each link to it.
std::string with_topics(const std::string& line) {
  static const std::regex link{R"((\[[^\]]*\])\((?:[^)#]*/)?([A-Za-z-]+)\.md(#[^)]*)?\))"};
  std::string text;
  auto rest = line.cbegin();
  for (std::sregex_iterator found{line.begin(), line.end(), link}, end; found != end; ++found) {
    std::string topic = (*found)[2];
    std::ranges::transform(topic, topic.begin(), [](unsigned char c) { return std::tolower(c); });
    text.append(rest, (*found)[0].first).append((*found)[1]).append("() (floeplan help " + topic + ")");
    rest = (*found)[0].second;
  }
  return text.append(rest, line.cend());
}

/// The text without marks for links, emphasis and code, and without Markdown's escapes.
std::string unmarked(const std::string& line) {
  static const std::regex link{R"(\[([^\]]*)\]\([^)]*\))"};
  static const std::regex strong{R"(\*\*([^*]+)\*\*)"};
  static const std::regex emphasis{R"(\*([^*\s][^*]*)\*)"};
  static const std::regex mark{R"(`)"};
  static const std::regex escape{R"(\\([*<`\[]))"};
  std::string text = std::regex_replace(with_topics(line), link, "$1");
  text = std::regex_replace(text, strong, "$1");
  text = std::regex_replace(text, emphasis, "$1");
  text = std::regex_replace(text, mark, "");
  return std::regex_replace(text, escape, "$1");
}

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream parts{row.substr(1)};
  for (std::string cell; std::getline(parts, cell, '|');) {
    const auto from = cell.find_first_not_of(' ');
    cells.push_back(from == std::string::npos ? ""
                                              : cell.substr(from, cell.find_last_not_of(' ') - from + 1));
  }
  return cells;
}

std::string item_of(const std::string& row) {
  std::string item;
  bool is_first = true;  // whether the next cell is the first after the cell that names the row
  for (const std::string& cell : cells_of(row)) {
    if (cell.empty()) continue;
    if (item.empty()) {
      item = cell;
    } else {
      item += (is_first ? (item.ends_with('?') ? " " : ": ") : "; ") + cell;
      is_first = false;
    }
  }
  return item;
}

/// Processes a page line by line; lines of one paragraph are wrapped together.
class Writer {
 public:
  explicit Writer(std::size_t width) : width_{width} {}

  void take(const std::string& line) {
    if (line.starts_with("```")) {
      end_paragraph();
      is_code_ = !is_code_;
    } else if (is_code_) {
      text_ += "    " + line + '\n';
    } else if (line.empty()) {
      end_paragraph();
      if (!text_.ends_with("\n\n")) text_ += '\n';
    } else if (line.starts_with("<!--") || line.starts_with("![")) {
      end_paragraph();
    } else if (line.starts_with("|---")) {
      paragraph_.clear();  // drops the table's head
    } else if (line.starts_with('#')) {
      take_heading(line);
    } else if (line.starts_with('|')) {
      begin_item("  - ", item_of(line));
    } else if (line.starts_with("- ")) {
      begin_item("  - ", line.substr(2));
    } else if (line.size() > 3 && line[0] >= '0' && line[0] <= '9' && line.substr(1, 2) == ". ") {
      begin_item("  " + line.substr(0, 3), line.substr(3));
    } else {
      paragraph_ += (paragraph_.empty() ? "" : " ") + line.substr(line.find_first_not_of(' '));
    }
  }

  std::string text() {
    end_paragraph();
    while (text_.ends_with("\n\n")) text_.pop_back();
    return text_;
  }

 private:
  void take_heading(const std::string& line) {
    end_paragraph();
    const auto level = line.find(' ');
    const std::string words = unmarked(line.substr(level + 1));
    text_ += words + '\n';
    if (level < 3) text_ += std::string(words.size(), level == 1 ? '=' : '-') + '\n';
  }

  void begin_item(const std::string& mark, const std::string& words) {
    end_paragraph();
    mark_ = mark;
    paragraph_ = words;
  }

  void end_paragraph() {
    if (!paragraph_.empty())
      text_ += mark_ + wrapped(unmarked(paragraph_), width_ - mark_.size(), mark_.size()) + '\n';
    paragraph_.clear();
    mark_.clear();
  }

  std::size_t width_;
  std::string text_;
  std::string mark_;
  std::string paragraph_;
  bool is_code_{};
};

}  // namespace

std::string wrapped(std::string_view words, std::size_t width, std::size_t indent) {
  std::istringstream all{std::string{words}};
  std::string text;
  std::size_t column = 0;
  for (std::string word; all >> word;) {
    if (column > 0 && column + 1 + word.size() > width) {
      text += '\n' + std::string(indent, ' ');
      column = 0;
    } else if (column > 0) {
      text += ' ';
      ++column;
    }
    text += word;
    column += word.size();
  }
  return text;
}

std::string plain_text(std::string_view markdown, std::size_t width) {
  Writer writer{width};
  std::istringstream lines{std::string{markdown}};
  for (std::string line; std::getline(lines, line);) writer.take(line);
  return writer.text();
}

}  // namespace floeplan::manual
