#include "server/manual/command_help.hpp"

#include <algorithm>

namespace floeplan::manual {
namespace {

constexpr std::string_view planning{"Plan"};
constexpr std::string_view data{"Data"};
constexpr std::string_view flying{"Fly"};
constexpr std::string_view serving{"Serve"};
constexpr std::string_view learning{"Learn"};

std::vector<CommandHelp> all_helps() {
  return {
      {"plan",
       planning,
       "--data store plan --from=-53.20,69.20 --to=-51.80,69.15 --depart 2026-11-22T06:00:00Z",
       {"--from", "--to", "--depart", "--arrive-by", "--vehicle", "--objective"}},
      {"evaluate",
       planning,
       "--data store evaluate route.geojson --depart 2026-11-22T06:00:00Z",
       {"--depart", "--from", "--route", "--vehicle", "--speed", "--margin"}},
      {"reach",
       planning,
       "--data store reach --from=-53.20,69.20 --depart 2026-11-22T06:00:00Z --hours 6,12,24",
       {"--from", "--to", "--depart", "--arrive-by", "--hours", "--vehicle"}},
      {"compare", planning, "--data store compare p1a2b3c4d5e6 p6e5d4c3b2a1"},
      {"recheck", planning, "--data store recheck p1a2b3c4d5e6"},
      {"ingest",
       data,
       "--data store ingest demo/disko-*",
       {"--name", "--kind", "--crs", "--positive", "--time", "--zone-kind"}},
      {"formats", data, "formats"},
      {"datasets", data, "--data store datasets"},
      {"datasets remove", "", "--data store datasets remove currents-1"},
      {"datasets prune", "", "--data store datasets prune --older-than P30D --dry-run"},
      {"probe", data, "--data store probe --at=-53.20,69.20 --time 2026-11-22T06:00:00Z"},
      {"demo", data, "demo demo/ --start 2026-11-22"},
      {"export",
       flying,
       "--data store export p1a2b3c4d5e6 --full --out mission/",
       {"--format", "--out", "--full", "--number", "--accept-dangers", "--force"}},
      {"check",
       flying,
       "check mission/goto_l10.ma",
       {"--depart", "--from", "--vehicle", "--currents", "--bathymetry", "--ice"}},
      {"simulate",
       flying,
       "--data store simulate p1a2b3c4d5e6 --runs 200 --current-error 0.1",
       {"--runs", "--seed", "--current-error", "--no-avoidance", "--mission", "--out"}},
      {"compare-flight", flying, "compare-flight nav.csv"},
      {"serve",
       serving,
       "--data store serve --listen 127.0.0.1:8080",
       {"--listen", "--public-url", "--tls-cert", "--tls-key", "--watch", "--behind-proxy"}},
      {"worker",
       serving,
       "--config node.toml worker --workers 2",
       {"--workers", "--lanes", "--listen"}},
      {"token", serving, "--data store token add anna --role pilot"},
      {"token add", "", "--data store token add anna --role pilot"},
      {"token list", "", "--data store token list"},
      {"token revoke", "", "--data store token revoke anna"},
      {"audit", serving, "--data store audit --limit 20"},
      {"store", serving, "store copy sqlite:store sqlite:copy"},
      {"store copy", "", "store copy sqlite:store sqlite:copy"},
      {"store prepare", "", "--config node.toml store prepare --for floeplan_node"},
      {"backup", serving, "--data store backup store.backup"},
      {"restore", serving, "--data store restore store.backup"},
      {"verify", serving, "--data store verify"},
      {"repair", serving, "--data store repair"},
      {"help", learning, "help planning"},
      {"reproduce", learning, "reproduce --figures figures/"},
      {"completion", learning, "completion bash"},
  };
}

}  // namespace

std::span<const CommandHelp> command_helps() {
  static const std::vector<CommandHelp> all = all_helps();
  return all;
}

const CommandHelp* help_of_command(std::string_view command) {
  const auto found = std::ranges::find(command_helps(), command, &CommandHelp::command);
  return found == command_helps().end() ? nullptr : &*found;
}

}  // namespace floeplan::manual
