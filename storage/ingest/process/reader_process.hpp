#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace floeplan::ingest {

/// A child process that gets its task by arguments and reports by lines on its standard output. It inherits
/// no open files and none of the environment. It always ends: the destructor kills it, and the system kills
/// it when the parent ends.
/// Threads  one thread at a time; the thread that started the process must live longer than this object
class ReaderProcess {
 public:
  /// `home`   the folder that takes the place of the user's home and of the system's for temporary files
  /// `home`   the folder that replaces the user's home and the system's folder for temporary files
  ReaderProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& home);
  ReaderProcess(const ReaderProcess&) = delete;
  ReaderProcess& operator=(const ReaderProcess&) = delete;
  ~ReaderProcess();

  enum class Reading { line, ended, stopped, too_late };
  /// Reads the next line into `line()`, without its line end; or returns why there is none: the output has
  /// ended, `stop` was requested, or the deadline has passed.
  [[nodiscard]] Reading read_line(const std::stop_token& stop,
                                  std::chrono::steady_clock::time_point deadline);
  [[nodiscard]] const std::string& line() const { return line_; }
  /// Reads the bytes that follow a line into `line()`; returns `line` when all have arrived.
  [[nodiscard]] Reading read_bytes(std::size_t count, const std::stop_token& stop,
                                   std::chrono::steady_clock::time_point deadline);

  /// Kills the process if it still runs, and returns its wait status, as waitpid does.
  /// Errors   std::logic_error when the status was returned before
  int kill();
  /// Waits until a process whose output has ended exits; returns its wait status.
  int wait();

 private:
  int collect();
  Reading read_more(const std::stop_token& stop, std::chrono::steady_clock::time_point deadline);

  pid_t pid_{-1};
  int output_{-1};
  std::string buffer_;
  std::string line_;
};

}  // namespace floeplan::ingest
