#include "tests/storage/ingest/hostile/gallery.hpp"

#include <algorithm>
#include <fstream>
#include <utility>

#include "tests/storage/ingest/hostile/makers.hpp"

namespace floeplan::ingest {

std::vector<HostileFile> hostile_files(const HostileAims& aims, std::mt19937_64& rng) {
  std::vector<HostileFile> gallery;
  add_hostile_texts(gallery, aims, rng);
  add_hostile_markup(gallery, aims, rng);
  add_hostile_octets(gallery, aims, rng);
  add_hostile_hdf5(gallery, aims, rng);
  add_hostile_databases(gallery, aims, rng);
  add_hostile_archives(gallery, aims, rng);
  return gallery;
}

HostileFile hostile_text(std::string_view format, std::string_view wants, const std::string& name,
                         std::string content) {
  return {std::string{format}, std::string{wants},
          [name, content = std::move(content)](const std::filesystem::path& folder) {
            std::ofstream{folder / name, std::ios::binary} << content;
            return std::vector{folder / name};
          }};
}

std::vector<std::string> places_to_open(const HostileAims& aims) {
  const std::string url = "http://127.0.0.1:" + std::to_string(aims.port) + "/data";
  return {aims.secret.string(),
          (aims.store / "floeplan.sqlite").string(),
          "/etc/passwd",
          "/proc/self/environ",
          url,
          "/vsicurl/" + url,
          "/vsicurl_streaming/" + url,
          "/vsizip//vsicurl/" + url,
          "/vsisubfile/0_100," + aims.secret.string(),
          "file://" + aims.secret.string()};
}

std::string big_endian(std::uint64_t value, int octets) {
  std::string text;
  for (int i = octets - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xFFU);
  return text;
}

std::string little_endian(std::uint64_t value, int octets) {
  std::string text = big_endian(value, octets);
  std::ranges::reverse(text);
  return text;
}

std::string json_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return result;
}

std::string repeated(std::string_view text, std::int64_t times) {
  std::string result;
  result.reserve(text.size() * static_cast<std::size_t>(times));
  for (std::int64_t i = 0; i < times; ++i) result += text;
  return result;
}

}  // namespace floeplan::ingest
