#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "tests/server/cli/program.hpp"
#include "tests/server/cli/served_program.hpp"
#include "tests/support/places.hpp"

namespace floeplan::cli::doors_test {
namespace {

namespace fs = std::filesystem;
using support::Outcome;
using support::Program;
using support::ServedProgram;
using testing::HasSubstr;

std::string token_of(const Program& program, const std::string& name, const std::string& role) {
  const Outcome added = program.run({"token", "add", name, "--role", role, "--json"});
  EXPECT_EQ(added.exit_code, 0) << added.err;
  return added.json().at("token");
}

std::string bearer(const std::string& token) { return "Authorization: Bearer " + token + "\r\n"; }

TEST(TokenCommand, AddsListsAndRevokes) {
  const Program program;
  const std::string token = token_of(program, "ship", "pilot");
  EXPECT_TRUE(token.starts_with("floeplan_"));
  EXPECT_EQ(program.run({"token", "add", "ship", "--role", "admin"}).exit_code, 1);
  EXPECT_EQ(program.run({"token", "add", "no/name", "--role", "admin"}).exit_code, 2);
  EXPECT_EQ(program.run({"token", "add", "root", "--role", "root"}).exit_code, 2);

  const Outcome listed = program.run({"tokens", "list", "--json"});
  EXPECT_EQ(listed.json().at("tokens").at(0).at("role"), "pilot");
  EXPECT_EQ(listed.out.find(token.substr(26)), std::string::npos) << "the secret is not kept";
  EXPECT_EQ(program.run({"token", "revoke", "ship"}).exit_code, 0);
  EXPECT_EQ(program.run({"token", "revoke", "ship"}).exit_code, 1);
}

TEST(Serve, StaysOffOtherAddressesWithoutTokensOrTls) {
  const Program program;
  const Outcome open = program.run({"serve", "--listen", "0.0.0.0:0"});
  EXPECT_EQ(open.exit_code, 2);
  EXPECT_THAT(open.err, HasSubstr("floeplan token add"));
  EXPECT_EQ(program.run({"serve", "--listen", "127.0.0.1:0", "--behind-proxy"}).exit_code, 2);

  token_of(program, "ship", "admin");
  const Outcome clear = program.run({"serve", "--listen", "0.0.0.0:0"});
  EXPECT_EQ(clear.exit_code, 2);
  EXPECT_THAT(clear.err, HasSubstr("--tls-cert"));
  EXPECT_EQ(program.run({"serve", "--tls-cert", "a.pem"}).exit_code, 2);
  EXPECT_EQ(program.run({"serve", "--tls-cert", "a.pem", "--tls-key", "b.pem"}).exit_code, 1);
  EXPECT_EQ(program.run({"serve", "--allow-origin", "https://map.example/x"}).exit_code, 2);
}

TEST(Serve, LetsInByToken) {
  const Program program;
  const std::string viewer = token_of(program, "watch", "viewer");
  const std::string admin = token_of(program, "office", "admin");
  const ServedProgram served{program.folder() / "store"};
  EXPECT_EQ(served.get("/datasets").status, 401);
  EXPECT_EQ(served.get("/datasets").json().at("type"), "/problems/unauthorized");
  EXPECT_EQ(served.ask("GET", "/datasets", bearer(viewer)).status, 200);
  EXPECT_EQ(served.ask("GET", "/audit", bearer(viewer)).status, 403);
  EXPECT_EQ(served.ask("POST", "/uploads?name=a.nc", bearer(viewer), "abc").status, 403);
  EXPECT_EQ(served.ask("POST", "/uploads?name=a.nc", bearer(admin), "abc").status, 201);

  EXPECT_EQ(program.run({"token", "revoke", "watch"}).exit_code, 0);
  EXPECT_EQ(served.ask("GET", "/datasets", bearer(viewer)).status, 401) << "at once, without a restart";
  const Outcome audit = program.run({"audit", "--json"});
  EXPECT_EQ(audit.json().at("entries").at(0).at("action"), "log-in-refused");
  EXPECT_EQ(audit.json().at("entries").at(1).at("caller"), "office");
  EXPECT_EQ(audit.json().at("entries").at(1).at("action"), "upload");
  EXPECT_THAT(served.ask("GET", "/metrics", bearer(admin)).body,
              HasSubstr(R"(floeplan_http_requests_total{method="POST",route="/uploads",status="201"} 1)"));
}

TEST(Serve, NeverRunsOpenAgainOnceItHadAToken) {
  const Program program;
  {
    const ServedProgram served{program.store()};
    EXPECT_EQ(served.get("/datasets").status, 200) << "open while there has been no token";
    const std::string token = token_of(program, "ship", "admin");
    EXPECT_EQ(served.get("/datasets").status, 401);
    EXPECT_EQ(program.run({"token", "revoke", "ship"}).exit_code, 0);
    EXPECT_EQ(served.get("/datasets").status, 401) << "while it runs";
    EXPECT_EQ(served.ask("GET", "/datasets", bearer(token)).status, 401);
  }
  const ServedProgram restarted{program.store()};
  const auto refused = restarted.get("/datasets");
  EXPECT_EQ(refused.status, 401);
  EXPECT_THAT(refused.body, HasSubstr("floeplan token add"));
  EXPECT_THAT(program.run({"token", "list"}).out, HasSubstr("floeplan token add"));
  EXPECT_EQ(restarted.ask("GET", "/datasets", bearer(token_of(program, "ship", "viewer"))).status, 200);
}

TEST(Serve, HasAStoreForItselfAlone) {
  const Program program;
  const ServedProgram served{program.folder() / "store"};
  const Outcome second = program.run({"serve", "--listen", "127.0.0.1:0"});
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(second.err, HasSubstr("is in use by process"));
}

TEST(Serve, RefusesADamagedStore) {
  const Program program;
  ASSERT_EQ(program.run({"token", "add", "ship", "--role", "admin"}).exit_code, 0);
  const fs::path file = program.folder() / "store" / "floeplan.sqlite";
  const auto size = fs::file_size(file);
  std::fstream damaged{file, std::ios::in | std::ios::out | std::ios::binary};
  for (auto at = static_cast<std::streamoff>(4096 * 3); at < static_cast<std::streamoff>(size); at += 4096) {
    damaged.seekp(at);
    damaged << std::string(200, '\x7f');
  }
  damaged.close();
  EXPECT_EQ(program.run({"serve", "--listen", "127.0.0.1:0"}).exit_code, 1);
}

/// With the scripts that operators use.
TEST(BackupScripts, BringBackWhatWasThereWhenTheCopyWasMade) {
  const Program program;
  const fs::path store = program.folder() / "store";
  const fs::path backups = program.folder() / "backups";
  const fs::path other = program.folder() / "other";
  const auto script = [](const std::string& name, const fs::path& first, const fs::path& second) {
    const std::string command = "FLOEPLAN=" + support::program_folder() + "/floeplan " +
                                support::source_folder() + "/deploy/" + name + " " + first.string() + " " +
                                second.string() + " > /dev/null 2>&1";
    return std::system(command.c_str());
  };
  const std::string token = token_of(program, "ship", "admin");
  {
    const ServedProgram served{store};
    EXPECT_EQ(script("backup.sh", store, backups), 0);
    EXPECT_NE(script("restore.sh", backups, store), 0) << "not below a server that runs";
    EXPECT_EQ(program.run({"token", "revoke", "ship"}).exit_code, 0);
  }
  EXPECT_EQ(script("restore.sh", backups, store), 0);
  EXPECT_EQ(script("restore.sh", backups, other), 0);
  for (const fs::path& restored : {store, other}) {
    const ServedProgram served{restored};
    EXPECT_EQ(served.ask("GET", "/audit", bearer(token)).status, 200) << restored;
  }
  EXPECT_NE(script("restore.sh", program.folder(), other), 0) << "no backup lies there";
}

}  // namespace
}  // namespace floeplan::cli::doors_test
