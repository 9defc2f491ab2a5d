#include "server/cli/output/file_set.hpp"

#include <fstream>
#include <stdexcept>

#include "engine/messages/command_messages.hpp"

namespace floeplan::cli {
namespace {

namespace fs = std::filesystem;

fs::path part_of(const fs::path& file) { return file.string() + ".part"; }

void write_part(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream stream{part_of(file), std::ios::binary | std::ios::trunc};
  stream << bytes;
  stream.flush();
  if (!stream) throw std::runtime_error{messages::command_text<"file-not-written">(file.string())};
}

}  // namespace

std::optional<fs::path> first_existing(const fs::path& folder, const std::vector<OutputFile>& files) {
  for (const OutputFile& file : files) {
    if (fs::exists(folder / file.name)) return folder / file.name;
  }
  return std::nullopt;
}

std::vector<fs::path> write_set(const fs::path& folder, const std::vector<OutputFile>& files) {
  std::vector<fs::path> written;
  try {
    for (const OutputFile& file : files) {
      written.push_back(folder / file.name);
      write_part(written.back(), file.bytes);
    }
  } catch (...) {
    std::error_code ignored;
    for (const fs::path& file : written) fs::remove(part_of(file), ignored);
    throw;
  }
  for (const fs::path& file : written) fs::rename(part_of(file), file);
  return written;
}

}  // namespace floeplan::cli
