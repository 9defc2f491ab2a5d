#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/support/places.hpp"

/// Files of the source tree that are generated from a table in the program, and the tests that keep them up
/// to date.
namespace floeplan::support {

/// The environment variable that makes the tests write outdated files.
inline constexpr const char* let_write = "FLOEPLAN_WRITE_CONTRACT";

/// The text of a file, by its path in the source tree; empty if there is none.
inline std::string text_of_tree(const std::string& file) {
  std::ifstream stream{source_folder() + "/" + file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// The first line that differs in the file.
inline std::string first_difference(const std::string& file, const std::string& made) {
  std::istringstream lines_of_file{file};
  std::istringstream lines_made{made};
  std::string there;
  std::string wanted;
  for (int line = 1;; ++line) {
    const bool has_line = static_cast<bool>(std::getline(lines_of_file, there));
    const bool is_line_made = static_cast<bool>(std::getline(lines_made, wanted));
    if (!(has_line && is_line_made) || there != wanted)
      return "line " + std::to_string(line) + " is\n" + there + "\nand is to be\n" + wanted + "\n";
  }
}

/// Expects that the file has the content generated from the table; with FLOEPLAN_WRITE_CONTRACT writes it
/// instead.
/// `test`  the executable of this test
inline void expect_written_out(const std::string& file, const std::string& made, const std::string& test) {
  if (std::getenv(let_write) != nullptr)
    std::ofstream{source_folder() + "/" + file, std::ios::binary} << made;
  const std::string there = text_of_tree(file);
  EXPECT_TRUE(there == made) << file << " is out of date: " << first_difference(there, made) << "Run "
                             << let_write << "=1 build/release/" << test << " and commit what it writes.";
}

/// The same for a part of a Markdown page between two comments: one that begins with `name`, and "end of
/// `name`".
/// Errors   throws std::runtime_error if the page does not have them
inline void expect_written_part(const std::string& file, const std::string& name, const std::string& made,
                                const std::string& test) {
  const std::string page = text_of_tree(file);
  const auto comment = page.find("<!-- " + name + ":");
  const auto begin = page.find('\n', comment);
  const auto end = page.find("<!-- end of " + name + " -->");
  if (comment == std::string::npos || end == std::string::npos || end < begin)
    throw std::runtime_error{file + " has no part for " + name};
  expect_written_out(file, page.substr(0, begin + 1) + "\n" + made + "\n" + page.substr(end), test);
}

}  // namespace floeplan::support
