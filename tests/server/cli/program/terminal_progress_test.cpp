#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <array>
#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "server/cli/program/command.hpp"

namespace floeplan::cli::terminal_progress_test {
namespace {

/// Redirects this process's standard error to a new terminal or a pipe, until it is destroyed.
class OtherStderr {
 public:
  enum class To { terminal, pipe };

  explicit OtherStderr(To to) : before_{dup(STDERR_FILENO)} {
    std::array<int, 2> ends{};
    const int made =
        to == To::terminal ? openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) : pipe(ends.data());
    if (made != 0) throw std::runtime_error{"no terminal and no pipe"};
    reader_ = ends[0];
    dup2(ends[1], STDERR_FILENO);
    close(ends[1]);
  }
  ~OtherStderr() {
    dup2(before_, STDERR_FILENO);
    close(before_);
    close(reader_);
  }
  OtherStderr(const OtherStderr&) = delete;
  OtherStderr& operator=(const OtherStderr&) = delete;

  /// The whole output; call it once.
  std::string written() const {
    constexpr std::string_view end{"END"};
    if (write(STDERR_FILENO, end.data(), end.size()) != static_cast<ssize_t>(end.size()))
      throw std::runtime_error{"nothing can be written"};
    std::string text;
    std::array<char, 256> some{};
    while (!text.ends_with(end)) {
      const ssize_t count = read(reader_, some.data(), some.size());
      if (count <= 0) break;
      text.append(some.data(), static_cast<std::size_t>(count));
    }
    return text.substr(0, text.size() - end.size());
  }

 private:
  int before_;
  int reader_{-1};
};

/// The output of two plans, each from the start to the end, with one second between updates.
std::string written_by_two_plans(OtherStderr::To to) {
  const OtherStderr errors{to};
  {
    core::Seconds time{0.0};
    const core::ProgressCallback progress = terminal_progress([&] { return time; });
    for (int plan = 0; plan < 2; ++plan) {
      for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        progress("search", share);
        time += core::Seconds{1.0};
      }
    }
  }
  return errors.written();
}

TEST(TerminalProgress, IsOneLineWhosePercentNeverFallsAndThatIsWipedAtTheEnd) {
  const std::string text = written_by_two_plans(OtherStderr::To::terminal);

  const std::regex line{"\r\x1b\\[Ksearch (\\d+) %"};
  std::vector<int> percents;
  for (std::sregex_iterator at{text.begin(), text.end(), line}; at != std::sregex_iterator{}; ++at)
    percents.push_back(std::stoi((*at)[1]));
  EXPECT_EQ(percents, (std::vector<int>{10, 50, 90, 99})) << text;
  EXPECT_TRUE(text.ends_with("99 %\r\x1b[K")) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(TerminalProgress, IsNotThereWhereNobodyLooks) {
  EXPECT_EQ(written_by_two_plans(OtherStderr::To::pipe), "");
}

TEST(TerminalProgress, OfShortWorkSaysNothing) {
  const OtherStderr errors{OtherStderr::To::terminal};
  terminal_progress([] { return core::Seconds{0.0}; })("search", 0.5);

  EXPECT_EQ(errors.written(), "");
}

}  // namespace
}  // namespace floeplan::cli::terminal_progress_test
