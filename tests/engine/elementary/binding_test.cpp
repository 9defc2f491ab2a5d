#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <map>
#include <sstream>
#include <string>

#include "tests/support/places.hpp"

namespace floeplan::elementary::binding_test {
namespace {

/// The names that interposition.cpp defines.
constexpr std::array names{"sin",  "cos",  "sincos", "tan",   "asin",  "acos", "atan",  "atan2",
                           "exp",  "exp2", "expm1",  "pow",   "log",   "log2", "log10", "log1p",
                           "sinh", "cosh", "tanh",   "asinh", "acosh", "atanh"};

/// The output of the program digests, by the name of the function.
std::map<std::string, std::string> digests(const std::string& environment) {
  const std::string command = environment + " '" + support::program_folder() + "/elementary_digests'";
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t read = fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), read);
  if (pclose(pipe) != 0) return {};
  std::map<std::string, std::string> result;
  std::istringstream words{text};
  for (std::string name, digest; words >> name >> digest;) result[name] = digest;
  return result;
}

std::map<std::string, std::string> without_libm(std::map<std::string, std::string> all) {
  std::erase_if(all, [](const auto& entry) { return entry.first.starts_with("libm:"); });
  return all;
}

TEST(Binding, GivesTheProgramsFunctionsToTheWholeProcess) {
  Dl_info program{};
  ASSERT_NE(dladdr(reinterpret_cast<const void*>(&digests), &program), 0);
  for (const char* const name : names) {
    void* const function = dlsym(RTLD_DEFAULT, name);  // as a shared library finds it
    Dl_info found{};
    ASSERT_NE(function, nullptr) << name;
    ASSERT_NE(dladdr(function, &found), 0) << name;
    EXPECT_EQ(found.dli_fbase, program.dli_fbase) << name << " of " << found.dli_fname;
  }
}

TEST(Values, AreTheSameWithoutFusedMultiplyAdd) {
  const auto plainly = digests("env -u GLIBC_TUNABLES");
  const auto without = digests("GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4");

  EXPECT_GE(without_libm(plainly).size(), 28);
  EXPECT_EQ(without_libm(plainly), without_libm(without));

  // Otherwise the tunable has no effect, and the test would show nothing.
  if (__builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2")) {
    EXPECT_NE(plainly.at("libm:sin"), without.at("libm:sin"));
  }
}

}  // namespace
}  // namespace floeplan::elementary::binding_test
