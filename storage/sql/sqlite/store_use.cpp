#include "storage/sql/sqlite/store_use.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/driver/failure.hpp"

namespace floeplan::sql::sqlite {
namespace {

constexpr std::chrono::seconds patience{10};  // as long as a connection waits for another one's transaction
constexpr std::chrono::milliseconds between_looks{20};

std::string reason() { return std::generic_category().message(errno); }

}  // namespace

StoreUse::StoreUse(const std::filesystem::path& store, int kind_of_lock)
    : descriptor_{open((store / "floeplan.use").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)} {
  if (descriptor_ < 0)
    throw Failure{messages::store_text<"store-folder-read-only">(store.string(), reason()),
                  Trouble::not_writable};
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (flock(descriptor_, kind_of_lock | LOCK_NB) != 0) {
    const bool is_held = errno == EWOULDBLOCK || errno == EINTR;
    if (is_held && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(between_looks);
      continue;
    }
    const std::string why = reason();
    close(std::exchange(descriptor_, -1));
    if (!is_held)
      throw Failure{messages::store_text<"folder-without-locks">(store.string(), why), Trouble::not_writable};
    throw Failure{kind_of_lock == LOCK_EX ? messages::store_text<"store-in-use">(store.string())
                                          : messages::store_text<"store-being-replaced">(store.string()),
                  Trouble::held_by_another};
  }
}

StoreUse StoreUse::shared(const std::filesystem::path& store) { return {store, LOCK_SH}; }
StoreUse StoreUse::alone(const std::filesystem::path& store) { return {store, LOCK_EX}; }

StoreUse::StoreUse(StoreUse&& other) noexcept : descriptor_{std::exchange(other.descriptor_, -1)} {}

StoreUse& StoreUse::operator=(StoreUse&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

StoreUse::~StoreUse() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace floeplan::sql::sqlite
