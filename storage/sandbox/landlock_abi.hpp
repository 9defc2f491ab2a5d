#pragma once

#include <sys/types.h>

#include <cstdint>

/// The kernel's interface of Landlock. Debian 12's headers (Linux 6.1) know only version 2, and the C library
/// has no calls.
/// Source   include/uapi/linux/landlock.h of Linux 6.12; the numbers are equal on all architectures
namespace floeplan::sandbox::landlock_abi {

inline constexpr long create_ruleset = 444;
inline constexpr long add_rule = 445;
inline constexpr long restrict_self = 446;

inline constexpr std::uint32_t ask_version = 1U << 0;  // LANDLOCK_CREATE_RULESET_VERSION
inline constexpr int path_beneath = 1;                 // LANDLOCK_RULE_PATH_BENEATH

/// Older kernels read only the first members; the size passed with it tells how many.
struct Ruleset {
  std::uint64_t files{};
  std::uint64_t network{};  // from version 4
  std::uint64_t scoped{};   // from version 6
};

struct PathBeneath {
  std::uint64_t allowed{};
  std::int32_t parent{};
} __attribute__((packed));

enum Files : std::uint64_t {
  execute = 1ULL << 0,
  write_file = 1ULL << 1,
  read_file = 1ULL << 2,
  read_folder = 1ULL << 3,
  remove_folder = 1ULL << 4,
  remove_file = 1ULL << 5,
  make_character_device = 1ULL << 6,
  make_folder = 1ULL << 7,
  make_file = 1ULL << 8,
  make_socket = 1ULL << 9,
  make_fifo = 1ULL << 10,
  make_block_device = 1ULL << 11,
  make_symbolic_link = 1ULL << 12,
  refer = 1ULL << 13,          // link or rename from one folder to another; from version 2
  truncate = 1ULL << 14,       // from version 3
  device_control = 1ULL << 15  // ioctl on devices; from version 5
};

enum Network : std::uint64_t { bind_tcp = 1ULL << 0, connect_tcp = 1ULL << 1 };  // from version 4

enum Scoped : std::uint64_t { abstract_sockets = 1ULL << 0, signals = 1ULL << 1 };  // from version 6

}  // namespace floeplan::sandbox::landlock_abi
