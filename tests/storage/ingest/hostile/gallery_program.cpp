#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/storage/ingest/hostile/gallery.hpp"

/// Writes the gallery for tests of the whole program: `hostile_gallery FOLDER SECRET STORE PORT SEED`. Each file lies in a
/// folder of its own; FOLDER/gallery.json lists them.
int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  if (argc != 6) {
    std::cerr << "usage: hostile_gallery FOLDER SECRET STORE PORT SEED\n";
    return 2;
  }
  const fs::path folder{argv[1]};
  const floeplan::ingest::HostileAims aims{
      .secret = argv[2], .store = argv[3], .port = static_cast<std::uint16_t>(std::stoi(argv[4]))};
  std::mt19937_64 rng{std::stoull(argv[5])};
  auto list = nlohmann::json::array();
  for (const auto& hostile : floeplan::ingest::hostile_files(aims, rng)) {
    const fs::path place = folder / std::to_string(list.size());
    fs::create_directories(place);
    auto files = nlohmann::json::array();
    for (const fs::path& file : hostile.write(place)) files.push_back(file.string());
    nlohmann::json entry{{"format", hostile.format}, {"wants", hostile.wants}, {"files", std::move(files)}};
    if (hostile.crs) entry["crs"] = *hostile.crs;
    list.push_back(std::move(entry));
  }
  std::ofstream{folder / "gallery.json"} << list.dump(1);
  return 0;
}
