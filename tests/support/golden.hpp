#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/places.hpp"

namespace floeplan::support {

/// Expects that the file of this name in tests/golden contains this text. A failure message says where the
/// text was written and how to accept it.
inline void expect_golden(const std::string& name, const std::string& text) {
  const std::string file = source_folder() + "/tests/golden/" + name;
  std::ostringstream held;
  held << std::ifstream{file}.rdbuf();
  if (held.str() == text) return;
  const auto written = std::filesystem::temp_directory_path() / (std::to_string(::getuid()) + "." + name);
  std::ofstream{written} << text;
  FAIL() << name << " is other than what is held; read the difference, and if it is meant: cp "
         << written.string() << ' ' << file;
}

}  // namespace floeplan::support
