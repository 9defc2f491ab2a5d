#include "server/http/body_sink.hpp"

#include <fcntl.h>
#include <stdlib.h>  // NOLINT: mkostemp is POSIX, not in <cstdlib>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace floeplan::http {

BodySink::BodySink(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::string name = (folder / "body-XXXXXX").string();
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0)
    throw std::system_error{errno, std::generic_category(), "a body cannot be written to " + folder.string()};
  path_ = name;
}

BodySink::~BodySink() {
  close(descriptor_);
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void BodySink::add(std::string_view bytes) {
  digest_.add(bytes);
  while (!bytes.empty()) {
    const ssize_t count = write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw std::system_error{errno, std::generic_category(), "a body cannot be written"};
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

routes::BodyFile BodySink::finish() { return {path_, digest_.text()}; }

}  // namespace floeplan::http
