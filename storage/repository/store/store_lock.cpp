#include "storage/repository/store/store_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "engine/messages/store_messages.hpp"

namespace floeplan::repository {
namespace {

std::string holder_of(const std::filesystem::path& file) {
  std::string process;
  std::ifstream{file} >> process;
  return process.empty() ? "another process" : "process " + process;
}

}  // namespace

StoreLock::StoreLock(const std::filesystem::path& store) {
  std::filesystem::create_directories(store);
  const auto file = store / "serve.lock";
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor_ < 0)
    throw std::system_error{errno, std::generic_category(), file.string() + " cannot be opened"};
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    close(descriptor_);
    throw std::runtime_error{messages::store_text<"store-served">(store.string(), holder_of(file))};
  }
  // The process id is for people only; the lock does not depend on it.
  std::ofstream{file, std::ios::trunc} << getpid() << '\n';
}

StoreLock::~StoreLock() { close(descriptor_); }

}  // namespace floeplan::repository
