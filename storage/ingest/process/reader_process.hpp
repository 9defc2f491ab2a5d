#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace floeplan::ingest {

/// A child process that is told what to do by its arguments and tells what it does by lines on its standard output.
/// It inherits no open file and nothing of the environment. Its end is certain: it is killed with this object, and kills
/// itself when its parent is killed.
/// Threads  one thread at a time; the thread that started it outlives it
class ReaderProcess {
 public:
  /// `home`   the folder that takes the place of the user's home and of the system's for temporary files
  /// Errors   std::system_error when the program cannot be started
  ReaderProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                const std::filesystem::path& home);
  ReaderProcess(const ReaderProcess&) = delete;
  ReaderProcess& operator=(const ReaderProcess&) = delete;
  ~ReaderProcess();

  enum class Reading { line, ended, stopped, too_late };
  /// The next line, without its end, in `line()`; or why there is none: the output has ended, `stop` was requested, the
  /// deadline is over.
  [[nodiscard]] Reading read_line(const std::stop_token& stop,
                                  std::chrono::steady_clock::time_point deadline);
  [[nodiscard]] const std::string& line() const { return line_; }
  /// Bytes that follow a line, in `line()`; `line` when all are there.
  [[nodiscard]] Reading read_bytes(std::size_t count, const std::stop_token& stop,
                                   std::chrono::steady_clock::time_point deadline);

  /// Kills what still runs and returns how it ended, as waitpid gives it.
  /// Errors   std::logic_error when its end was told before
  int kill();
  /// Waits for the end of a process whose output has ended; returns as kill().
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
