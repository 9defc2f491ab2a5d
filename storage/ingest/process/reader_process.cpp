#include "storage/ingest/process/reader_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/eventfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace floeplan::ingest {
namespace {

constexpr std::size_t longest_line = 4'000'000;  // bytes; a report with thousands of refused rows

std::system_error failure(int number, const char* what) { return {number, std::generic_category(), what}; }

/// The environment of the process. Nothing is inherited, so no variable makes a library load a plugin, use
/// the network or find other data than the system's. Only the options of sanitizers are kept.
std::vector<std::string> environment(const std::string& home) {
  std::vector<std::string> variables{"LC_ALL=C.UTF-8",
                                     "TZ=UTC0",
                                     "HOME=" + home,
                                     "TMPDIR=" + home,
                                     "PROJ_NETWORK=OFF",
                                     "PROJ_USER_WRITABLE_DIRECTORY=" + home,
                                     "GDAL_DRIVER_PATH=disable",
                                     "HDF5_PLUGIN_PRELOAD=::"};  // "::": no plugins (HDF5's H5PLpublic.h)
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  for (const char* name : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS"})
    if (const char* value = std::getenv(name)) variables.push_back(std::string{name} + "=" + value);
  // the leak checker traces its own process, which a confined reader may not do
  variables.emplace_back("LSAN_OPTIONS=detect_leaks=0");
#endif
  return variables;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  result.reserve(words.size() + 1);
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

/// Open files of a new process: standard input is empty, standard output is `output`, nothing else is open.
class FileActions {
 public:
  explicit FileActions(int output) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
  }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }

  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// A file descriptor that becomes readable when a stop is requested.
class StopSignal {
 public:
  explicit StopSignal(const std::stop_token& stop)
      : descriptor_{eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)}, callback_{stop, Raise{descriptor_}} {}
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  ~StopSignal() { close(descriptor_); }

  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  struct Raise {
    int descriptor;
    void operator()() const { static_cast<void>(eventfd_write(descriptor, 1)); }
  };

  int descriptor_;
  std::stop_callback<Raise> callback_;
};

int milliseconds_until(std::chrono::steady_clock::time_point deadline) {
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
  return static_cast<int>(std::clamp<std::chrono::milliseconds::rep>(left.count() + 1, 0, 60'000));
}

}  // namespace

ReaderProcess::ReaderProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                             const std::filesystem::path& home) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw failure(errno, "no pipe to a process that reads files");
  std::vector<std::string> words{"floeplan"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  fcntl(ends[1], F_SETPIPE_SZ, 1 << 20);  // the pipe holds a whole parcel of rows; a smaller pipe is slower
  std::vector<std::string> variables = environment(home.string());
  const FileActions actions{ends[1]};
  const int error = posix_spawn(&pid_, program.c_str(), actions.get(), nullptr, pointers(words).data(),
                                pointers(variables).data());
  close(ends[1]);
  output_ = ends[0];
  if (error == 0) return;
  close(output_);
  throw failure(error, "the process that reads files cannot be started");
}

ReaderProcess::~ReaderProcess() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    collect();
  }
  close(output_);
}

ReaderProcess::Reading ReaderProcess::read_line(const std::stop_token& stop,
                                                std::chrono::steady_clock::time_point deadline) {
  while (true) {
    if (stop.stop_requested()) return Reading::stopped;
    if (const auto end = buffer_.find('\n'); end != std::string::npos) {
      line_ = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return Reading::line;
    }
    if (buffer_.size() > longest_line) return Reading::ended;
    if (const Reading more = read_more(stop, deadline); more != Reading::line) return more;
  }
}

ReaderProcess::Reading ReaderProcess::read_bytes(std::size_t count, const std::stop_token& stop,
                                                 std::chrono::steady_clock::time_point deadline) {
  while (buffer_.size() < count)
    if (const Reading more = read_more(stop, deadline); more != Reading::line) return more;
  line_ = buffer_.substr(0, count);
  buffer_.erase(0, count);
  return Reading::line;
}

/// Waits for more output of the process.
ReaderProcess::Reading ReaderProcess::read_more(const std::stop_token& stop,
                                                std::chrono::steady_clock::time_point deadline) {
  const StopSignal stop_signal{stop};
  while (true) {
    if (stop.stop_requested()) return Reading::stopped;
    if (std::chrono::steady_clock::now() >= deadline) return Reading::too_late;
    std::array<pollfd, 2> waited{{{output_, POLLIN, 0}, {stop_signal.descriptor(), POLLIN, 0}}};
    if (poll(waited.data(), waited.size(), milliseconds_until(deadline)) <= 0 || waited[0].revents == 0)
      continue;
    std::array<char, 65536> bytes{};
    const ssize_t count = read(output_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return Reading::ended;
    buffer_.append(bytes.data(), static_cast<std::size_t>(count));
    return Reading::line;
  }
}

int ReaderProcess::kill() {
  // For kill(), the process id -1 means every process of the user.
  if (pid_ <= 0) throw std::logic_error{"ReaderProcess: its process has ended before"};
  ::kill(pid_, SIGKILL);
  return collect();
}

int ReaderProcess::wait() { return collect(); }

int ReaderProcess::collect() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return status;
}

}  // namespace floeplan::ingest
