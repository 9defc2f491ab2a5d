#include <iomanip>
#include <iostream>
#include <memory>

#include "api/codec/bytes/credential.hpp"
#include "api/routes/request/message.hpp"
#include "engine/core/utc_text.hpp"
#include "server/cli/program/command.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/access/token_repository.hpp"
#include "storage/repository/store/migrations.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;
using repository::TokenRecord;
using repository::TokenRepository;

struct TokenFlags {
  std::string name;
  std::string role;
  bool json_out{false};
};

/// Whether a name is valid. Names appear in logs and tables, so only some characters are allowed.
bool is_name(const std::string& text) {
  constexpr std::size_t longest = 64;
  constexpr const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._@-";
  return !text.empty() && text.size() <= longest && text.find_first_not_of(allowed) == std::string::npos &&
         text != routes::local_caller.name;
}

/// Adds a token and prints it. It cannot be shown again, because the store has only a digest of its secret.
int add_token(const TokenFlags& flags, const Program& program) {
  if (!is_name(flags.name)) {
    return complain<"wrong-token-name">(wrong_usage, flags.name);
  }
  const codec::Credential credential = codec::new_credential();
  const TokenRecord token{.name = flags.name,
                          .role = repository::role_of(flags.role).value_or(repository::Role::viewer),
                          .key = credential.key,
                          .digest = codec::digest_of(credential),
                          .created = now()};
  auto db = open_store(program);
  if (!TokenRepository{db}.add(token)) {
    return complain<"token-exists">(could_not, flags.name);
  }
  const std::string text = codec::credential_text(credential);
  if (flags.json_out) {
    std::cout << json{{"name", token.name}, {"role", flags.role}, {"token", text}}.dump(2) << '\n';
  } else {
    std::cerr << "note: " << messages::command_text<"token-shown-once">() << '\n';
    std::cout << text << '\n';
  }
  return done;
}

int list_tokens(const TokenFlags& flags, const Program& program) {
  auto db = open_existing_store(program);
  const auto tokens = TokenRepository{db}.list();
  if (flags.json_out) {
    json documents = json::array();
    for (const auto& token : tokens) {
      documents.push_back({{"name", token.name},
                           {"role", repository::role_name(token.role)},
                           {"created", core::iso8601(token.created)}});
    }
    std::cout << json{{"tokens", documents}}.dump(2) << '\n';
    return done;
  }
  for (const auto& token : tokens) {
    std::cout << std::left << std::setw(24) << token.name << ' ' << std::setw(7)
              << repository::role_name(token.role) << "  " << core::iso8601(token.created) << '\n';
  }
  if (tokens.empty() && TokenRepository{db}.ever_any()) {
    std::cout << "There is no token left, and the server lets nobody in: add one with floeplan token add.\n";
  } else if (tokens.empty()) {
    std::cout << "There are no tokens: on loopback, the server needs none.\n";
  }
  return done;
}

int revoke_token(const TokenFlags& flags, const Program& program) {
  auto db = open_existing_store(program);
  TokenRepository tokens{db};
  if (!tokens.remove(flags.name)) return complain<"no-such-token">(could_not, flags.name);
  if (!tokens.any()) std::cerr << "caution: " << messages::command_text<"last-token-revoked">() << '\n';
  return done;
}

}  // namespace

void add_token(CLI::App& app, Program& program) {
  auto flags = std::make_shared<TokenFlags>();
  auto* command = app.add_subcommand("token", "Create, list and revoke the tokens that the server takes");
  command->alias("tokens");
  command->require_subcommand(1);
  const auto with_json = [flags](CLI::App* of) {
    of->add_flag("--json", flags->json_out, "Answer with one JSON document");
  };

  auto* addition = command->add_subcommand("add", "Create a token and print it, once");
  addition->alias("create");
  addition->add_option("NAME", flags->name, "Name of the owner; the audit log shows it")->required();
  addition
      ->add_option("--role", flags->role,
                   "viewer reads; pilot also plans, ingests and removes; admin does everything")
      ->required()
      ->check(CLI::IsMember({"viewer", "pilot", "admin"}));
  with_json(addition);
  addition->callback([flags, &program] { program.exit_code = add_token(*flags, program); });

  auto* listing = command->add_subcommand("list", "Names, roles and ages");
  with_json(listing);
  listing->callback([flags, &program] { program.exit_code = list_tokens(*flags, program); });

  auto* removal = command->add_subcommand("revoke", "Revoke a token and end its logins");
  removal->alias("remove");
  removal->add_option("NAME", flags->name, "As the list shows it")->required();
  removal->callback([flags, &program] { program.exit_code = revoke_token(*flags, program); });
}

}  // namespace floeplan::cli
