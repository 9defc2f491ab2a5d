#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "tests/storage/ingest/hostile/gallery.hpp"

namespace floeplan::ingest {

/// Adds the files of some formats to the gallery.
void add_hostile_texts(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng);
void add_hostile_markup(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng);
void add_hostile_octets(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng);
void add_hostile_hdf5(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng);
void add_hostile_databases(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng);
void add_hostile_archives(std::vector<HostileFile>& gallery, const HostileAims& aims, std::mt19937_64& rng);

/// One file of this content.
[[nodiscard]] HostileFile hostile_text(std::string_view format, std::string_view wants,
                                       const std::string& name, std::string content);

/// Paths and addresses that a library might open: the secret, the store, the system's files, the listener.
[[nodiscard]] std::vector<std::string> places_to_open(const HostileAims& aims);

template <class T>
[[nodiscard]] const T& picked(std::mt19937_64& rng, const std::vector<T>& from) {
  return from[std::uniform_int_distribution<std::size_t>{0, from.size() - 1}(rng)];
}

[[nodiscard]] inline std::int64_t number_in(std::mt19937_64& rng, std::int64_t least, std::int64_t most) {
  return std::uniform_int_distribution<std::int64_t>{least, most}(rng);
}

/// The number in `octets` octets: the most significant first in `big_endian`, last in `little_endian`.
[[nodiscard]] std::string big_endian(std::uint64_t value, int octets);
[[nodiscard]] std::string little_endian(std::uint64_t value, int octets);

/// A text as it stands in JSON, without its quotes.
[[nodiscard]] std::string json_escaped(const std::string& text);

/// "a" repeated.
[[nodiscard]] std::string repeated(std::string_view text, std::int64_t times);

}  // namespace floeplan::ingest
