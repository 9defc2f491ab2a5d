#include "server/cli/output/whole_file.hpp"

#include <fstream>
#include <stdexcept>

namespace floeplan::cli {

void write_whole(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path part = file.string() + ".part";
  {
    std::ofstream stream{part, std::ios::binary | std::ios::trunc};
    stream << text;
    stream.flush();
    if (!stream)
      throw std::runtime_error{file.string() + " cannot be written; check the folder and the free space"};
  }
  std::filesystem::rename(part, file);
}

}  // namespace floeplan::cli
