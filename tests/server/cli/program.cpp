#include "tests/server/cli/program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "tests/support/empty_store.hpp"
#include "tests/support/places.hpp"

namespace floeplan::support {
namespace {

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

Outcome Program::run(const std::vector<std::string>& arguments) const {
  std::vector<std::string> words = store_words(store());
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_alone(std::move(words));
}

Outcome Program::run_alone(std::vector<std::string> words) const {
  const std::filesystem::path out = folder() / "stdout";
  const std::filesystem::path err = folder() / "stderr";
  words.emplace(words.begin(), "floeplan");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const std::string program = program_folder() + "/floeplan";
  const pid_t child = fork();
  if (child == 0) {
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(err)};
}

std::filesystem::path shared_sample(const std::string& name) {
  return std::filesystem::path{support::source_folder()} / "../shared/data/env" / name;
}

}  // namespace floeplan::support
