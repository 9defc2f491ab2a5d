#include <gmock/gmock.h>
#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <sstream>
#include <system_error>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"

namespace floeplan::cli::operations_test {
namespace {

namespace fs = std::filesystem;
using support::Answer;
using support::Program;
using support::ServedProgram;
using testing::HasSubstr;
using testing::Not;

void write(const fs::path& file, const std::string& text) { std::ofstream{file} << text; }

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream{file}.rdbuf();
  return text.str();
}

/// Whether the text appears in the file within ten seconds. The file exists already.
bool comes_to_hold(const fs::path& file, const std::string& text) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds{10};
  const int changes = inotify_init1(IN_CLOEXEC);
  if (changes < 0 || inotify_add_watch(changes, file.c_str(), IN_MODIFY) < 0)
    throw std::system_error{errno, std::generic_category(), "inotify"};
  bool holds = text_of(file).find(text) != std::string::npos;
  for (pollfd changed{changes, POLLIN, 0}; !holds;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0 || poll(&changed, 1, static_cast<int>(left.count())) <= 0) break;
    std::array<char, 4096> events{};
    (void)!read(changes, events.data(), events.size());
    holds = text_of(file).find(text) != std::string::npos;
  }
  close(changes);
  return holds;
}

TEST(Reload, TakesNewLimitsAndLogLevelAndKeepsTheOldOnesWhenTheFileIsBroken) {
  const Program program;
  const fs::path config = program.folder() / "floeplan.toml";
  const fs::path log = program.folder() / "log";
  write(config, "[serve]\nmax-upload-mb = 1\n");
  const ServedProgram served{program.store(), {}, {"--config", config.string()}, log};
  const std::string large(1'500'000, 'x');
  EXPECT_EQ(served.upload(large, "?name=a.nc").status, 413);

  write(config, "log-level = \"warning\"\n[serve]\nmax-upload-mb = 2\n");
  served.hang_up();
  ASSERT_TRUE(comes_to_hold(log, "reload=done")) << text_of(log);
  EXPECT_EQ(served.upload(large, "?name=a.nc").status, 201);
  EXPECT_EQ(served.get("/quiet").status, 404);

  write(config, "[serve]\nmax-upload-mb = many\n");
  served.hang_up();
  ASSERT_TRUE(comes_to_hold(log, "reload=refused")) << text_of(log);
  EXPECT_EQ(served.upload(large, "?name=a.nc").status, 201) << "what was good stays in force";
  EXPECT_THAT(text_of(log), Not(HasSubstr("/quiet"))) << "of the level info";
}

TEST(Reload, TakesNewQuotas) {
  const Program program;
  const fs::path config = program.folder() / "floeplan.toml";
  const fs::path log = program.folder() / "log";
  write(config, "[serve]\nmax-uploads = 1\n");
  const ServedProgram served{program.store(), {}, {"--config", config.string()}, log};
  EXPECT_EQ(served.upload("a", "?name=a.nc").status, 201);
  EXPECT_EQ(served.upload("b", "?name=b.nc").status, 403);

  write(config, "[serve]\nmax-uploads = 2\n");
  served.hang_up();
  ASSERT_TRUE(comes_to_hold(log, "reload=done")) << text_of(log);

  EXPECT_EQ(served.upload("b", "?name=b.nc").status, 201);
}

TEST(Serve, SaysNoSecretInAnyLogOrAnswer) {
  const Program program;
  const std::string secret(64, 'e');
  const std::string token = "floeplan_0123456789abcdef_" + secret;
  ASSERT_EQ(program.run({"token", "add", "ship", "--role", "admin"}).exit_code, 0);
  const std::string own = program.run({"token", "add", "me", "--role", "admin", "--json"}).json().at("token");
  const std::string me = "Authorization: Bearer " + own + "\r\n";
  const fs::path log = program.folder() / "log";
  std::string answers;
  {
    const ServedProgram served{program.store(), {}, {"--log-level", "debug"}, log};
    const auto ask = [&](const std::string& method, const std::string& target, const std::string& headers,
                         const std::string& body = "") {
      const Answer answer = served.ask(method, target, headers, body);
      answers += answer.head + answer.body;
      EXPECT_GE(answer.status, 400) << method << ' ' << target.substr(0, 80);
    };
    for (const std::string& who : {std::string{}, me}) {
      ask("GET", "/nowhere?token=" + token, who);
      ask("GET", "/nowhere?password=" + secret, who);
      ask("GET", "/datasets?" + token + "=1", who + "X-Token: " + token + "\r\n");
      ask("GET", "/datasets/" + token, who);
      ask("GET", "/collections/plans/items/floeplan%5F0123456789abcdef%5F" + secret, who);
      ask("DELETE", "/jobs/" + token, who);
      ask("PUT", "/vehicles/" + token, who + "If-Match: \"" + token + "\"\r\n", "{}");
      ask("POST", "/processes/" + token + "/execution", who + "Idempotency-Key: " + token + "\r\n", "{}");
      ask("POST", "/processes/echo/execution", who + "Prefer: " + token + "\r\n", "{\"" + token + "\": 1}");
      ask("GET", "/%zz" + token, who);
    }
    ask("GET", "/datasets", "Authorization: Bearer " + token + "\r\n");
    ask("GET", "/datasets", "Authorization: Basic " + token + "\r\n");
    ask("GET", "/datasets", "Cookie: floeplan_session=" + token + "\r\n");
    ask("POST", "/session", "", "{\"token\": \"" + token + "\"}");
    answers += served.ask("GET", "/metrics", me).body + served.ask("GET", "/audit?limit=1000", me).body;
  }
  ASSERT_TRUE(comes_to_hold(log, "status=404"));
  for (const std::string& said : {text_of(log), answers}) {
    EXPECT_THAT(said, Not(HasSubstr(secret)));
    EXPECT_THAT(said, Not(HasSubstr("eeeeeeeeeeee"))) << "not even a part of it";
    EXPECT_THAT(said, Not(HasSubstr(own.substr(own.size() - 12))));
  }
}

TEST(Serve, RepeatsNoMoreOfAnIdThanSomebodyReads) {
  const Program program;
  const ServedProgram served{program.store()};
  const std::string id(900'000, 'x');
  const Answer answer = served.ask("POST", "/processes/plan-route/execution", "", "{\"" + id + "\": 1}");
  EXPECT_EQ(answer.status, 400);
  EXPECT_LT(answer.body.size(), 2000U);
  const Answer missing = served.get("/collections/plans/items/" + std::string(10'000, 'y'));
  EXPECT_EQ(missing.status, 404);
  EXPECT_LT(missing.body.size(), 1000U);
  EXPECT_THAT(missing.body, HasSubstr(" characters)"));
}

TEST(Serve, WritesOneLineForEachEventWhateverTheAddressSays) {
  const Program program;
  const fs::path log = program.folder() / "log";
  const ServedProgram served{program.store(), {}, {}, log};
  EXPECT_EQ(served.get("/a%0Alevel=error%20forged").status, 404);
  ASSERT_TRUE(comes_to_hold(log, "status=404"));
  EXPECT_THAT(text_of(log), Not(HasSubstr("\nlevel=error")));
}

}  // namespace
}  // namespace floeplan::cli::operations_test
