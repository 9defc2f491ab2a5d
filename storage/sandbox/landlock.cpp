#include "storage/sandbox/landlock.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include "storage/sandbox/landlock_abi.hpp"

namespace floeplan::sandbox {
namespace {

namespace abi = landlock_abi;

constexpr std::uint64_t rights_of_a_file =
    abi::execute | abi::write_file | abi::read_file | abi::truncate | abi::device_control;

/// The actions that are forbidden unless a rule allows them: all that this version knows.
abi::Ruleset ruleset_of(int version) {
  abi::Ruleset rules{.files = 2 * abi::make_symbolic_link - 1};
  if (version >= 2) rules.files |= abi::refer;
  if (version >= 3) rules.files |= abi::truncate;
  if (version >= 4) rules.network = abi::bind_tcp | abi::connect_tcp;
  if (version >= 5) rules.files |= abi::device_control;
  if (version >= 6) rules.scoped = abi::abstract_sockets | abi::signals;
  return rules;
}

std::size_t size_of_ruleset(int version) {
  constexpr std::size_t member = sizeof(std::uint64_t);
  return version >= 6 ? 3 * member : version >= 4 ? 2 * member : member;
}

/// A file descriptor, closed with this object.
class Descriptor {
 public:
  explicit Descriptor(long number) : number_{static_cast<int>(number)} {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  [[nodiscard]] int get() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }

 private:
  int number_;
};

[[noreturn]] void refuse(const char* what) { throw std::system_error{errno, std::generic_category(), what}; }

void allow_path(const Descriptor& rules, const std::filesystem::path& path, std::uint64_t rights) {
  const Descriptor place{open(path.c_str(), O_PATH | O_CLOEXEC)};
  struct stat found{};
  if (!place || fstat(place.get(), &found) != 0) return;
  if (!S_ISDIR(found.st_mode)) rights &= rights_of_a_file;
  const abi::PathBeneath rule{.allowed = rights, .parent = place.get()};
  if (syscall(abi::add_rule, rules.get(), abi::path_beneath, &rule, 0) != 0)
    refuse("Landlock does not take a rule");
}

}  // namespace

int landlock_version() {
  const long version = syscall(abi::create_ruleset, nullptr, 0, abi::ask_version);
  return static_cast<int>(std::max(version, 0L));
}

int restrict_files(const FileNeeds& needs) {
  const int version = landlock_version();
  if (version == 0) return 0;
  const abi::Ruleset forbidden = ruleset_of(version);
  const Descriptor rules{syscall(abi::create_ruleset, &forbidden, size_of_ruleset(version), 0)};
  if (!rules) refuse("Landlock does not take its rules");
  for (const auto& path : needs.read) allow_path(rules, path, abi::read_file | abi::read_folder);
  constexpr std::uint64_t in_the_folder = abi::read_file | abi::read_folder | abi::write_file |
                                          abi::make_file | abi::make_folder | abi::remove_file |
                                          abi::remove_folder | abi::truncate;
  if (!needs.write.empty()) allow_path(rules, needs.write, in_the_folder & forbidden.files);
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || syscall(abi::restrict_self, rules.get(), 0) != 0)
    refuse("Landlock cannot be put in force");
  return version;
}

}  // namespace floeplan::sandbox
