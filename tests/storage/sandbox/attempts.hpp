#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace floeplan::sandbox {

/// The surroundings of an attempt: a folder with a store, a file to read and a folder to write to.
struct Scene {
  std::filesystem::path folder;
  std::uint16_t port{};  // of a listener on 127.0.0.1

  [[nodiscard]] std::filesystem::path store() const { return folder / "floeplan.sqlite"; }
  [[nodiscard]] std::filesystem::path given() const { return folder / "given.nc"; }
  [[nodiscard]] std::filesystem::path staging() const { return folder / "staging"; }
};

/// An action that a hostile file might make its reader do.
struct Attempt {
  std::string name;
  std::function<int(const Scene&)> make;  // returns 0 when it succeeded, else the number of the error
  int landlock{};                         // first version of Landlock that denies it alone; 0: none does
  bool system_calls{false};               // whether the filter of system calls alone denies it
};

/// All attempts. At least one layer denies each of them.
[[nodiscard]] const std::vector<Attempt>& attempts();

/// Makes one attempt in a process of its own, after `confine`.
/// Returns  as Attempt::make; 200 + the signal that ended the process
[[nodiscard]] int outcome_of(const Attempt& attempt, const Scene& scene,
                             const std::function<void()>& confine);

}  // namespace floeplan::sandbox
