#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace floeplan::sandbox {

/// Where attempts are made: a folder with a store, a file to read and a folder to write to.
struct Scene {
  std::filesystem::path folder;
  std::uint16_t port{};  // of a listener on 127.0.0.1

  [[nodiscard]] std::filesystem::path store() const { return folder / "floeplan.sqlite"; }
  [[nodiscard]] std::filesystem::path given() const { return folder / "given.nc"; }
  [[nodiscard]] std::filesystem::path staging() const { return folder / "staging"; }
};

/// What a hostile file might make its reader do.
struct Attempt {
  std::string name;
  std::function<int(const Scene&)> make;  // returns 0 when it succeeded, else the number of the error
  int landlock{};                         // from which version on Landlock alone denies it; 0: never
  bool system_calls{false};               // whether the filter alone denies it
};

/// Each is denied by one layer at least.
[[nodiscard]] const std::vector<Attempt>& attempts();

/// Makes one attempt in a process of its own, after `confine`.
/// Returns  as Attempt::make; 200 + the signal that ended the process
[[nodiscard]] int outcome_of(const Attempt& attempt, const Scene& scene,
                             const std::function<void()>& confine);

}  // namespace floeplan::sandbox
