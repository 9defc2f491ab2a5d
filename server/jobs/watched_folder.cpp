#include "server/jobs/watched_folder.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <map>

#include "api/log/log.hpp"
#include "server/jobs/pause.hpp"
#include "storage/ingest/files/sidecar.hpp"
#include "storage/json/json.hpp"

namespace floeplan::jobs {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds interval{500};
constexpr int looks_without_change = 4;  // two seconds; copying programs write more often
constexpr int looks_of_patience = 600;   // five minutes; then a file is taken although others still change
constexpr std::chrono::seconds after_failure{30};

/// The properties of a file that change while it is being written.
struct Appearance {
  std::uintmax_t bytes{};
  fs::file_time_type changed{};

  friend bool operator==(const Appearance&, const Appearance&) = default;
};

struct Seen {
  Appearance appearance;
  int looks{};  // number of checks without a change
};

Appearance appearance_of(const fs::path& path) {
  std::error_code error;
  Appearance appearance{0, fs::last_write_time(path, error)};
  if (!fs::is_directory(path, error)) {
    appearance.bytes = fs::file_size(path, error);
    return appearance;
  }
  for (fs::recursive_directory_iterator entry{path, error}, end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    appearance.changed = std::max(appearance.changed, entry->last_write_time(ignored));
    if (entry->is_regular_file(ignored)) appearance.bytes += entry->file_size(ignored);
  }
  return appearance;
}

bool is_unfinished(const std::string& name) {
  constexpr std::array endings{"~", ".part", ".partial", ".tmp", ".crdownload", ".filepart", ".download"};
  return name.starts_with('.') ||
         std::ranges::any_of(endings, [&](const char* ending) { return name.ends_with(ending); });
}

/// The sidecars of a file: "bed.prj" and "bed.asc.aux.xml" for "bed.asc".
std::vector<fs::path> sidecars_of(const fs::path& file) {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator{file.parent_path()})
    if (ingest::is_sidecar_of(entry.path(), file)) all.push_back(entry.path());
  return all;
}

/// A name that is not used in the folder, so that an earlier file of the same name is kept.
fs::path free_name(const fs::path& folder, const fs::path& name) {
  fs::path candidate = folder / name;
  for (int number = 2; fs::exists(candidate); ++number)
    candidate = folder / (name.stem().string() + "-" + std::to_string(number) + name.extension().string());
  return candidate;
}

/// Moves a file and its sidecars. The report is written first, so that every file in `done` or `refused` has
/// one.
void put_away(const fs::path& file, const fs::path& folder, const std::string& report) {
  fs::create_directories(folder);
  const fs::path target = free_name(folder, file.filename());
  std::ofstream{target.string() + ".report.json"} << report << '\n';
  const auto sidecars = sidecars_of(file);
  fs::rename(file, target);
  for (const fs::path& part : sidecars) fs::rename(part, free_name(folder, part.filename()));
}

/// Ingests complete files, and moves each with the reports of its group.
void ingest_and_put_away(sql::Connection& db, const ingest::Guard& guard, const std::vector<fs::path>& files,
                         const std::stop_token& stop) {
  std::map<ingest::FileGroup, std::vector<ingest::IngestReport>> groups;
  const core::UtcTime now = std::chrono::system_clock::now();
  for (ingest::IngestReport& report :
       ingest::guarded_ingest(db, guard, files, {}, now, stop, {}, service::log_technical_cause))
    groups[report.files].push_back(std::move(report));
  for (const auto& [group, reports] : groups) {
    const bool refused = std::ranges::any_of(
        reports, [](const auto& report) { return report.status == ingest::IngestStatus::refused; });
    log::info({"watched file=\"", reports.front().file, "\" outcome=", refused ? "refused" : "done"});
    for (const fs::path& file : group)
      if (fs::exists(file))  // the file of an archive may belong to several groups
        put_away(file, file.parent_path() / (refused ? "refused" : "done"),
                 service::report_document(reports).dump(2));
  }
}

/// Remembers the content of the folder at each check, and returns the complete files: all of them when no
/// file changes any more, because files still arriving may belong to them; but at the latest after five
/// minutes without change.
class Arrivals {
 public:
  std::vector<fs::path> look(const fs::path& folder) {
    std::map<fs::path, Seen> now;
    std::vector<fs::path> at_rest;
    std::vector<fs::path> at_rest_for_long;
    bool all_at_rest = true;
    for (const auto& entry : fs::directory_iterator{folder}) {
      const std::string name = entry.path().filename();
      if (name == "done" || name == "refused" || is_unfinished(name)) continue;
      const Appearance appearance = appearance_of(entry.path());
      const auto before = seen_.find(entry.path());
      const bool same = before != seen_.end() && before->second.appearance == appearance;
      const int looks = same ? before->second.looks + 1 : 0;
      now[entry.path()] = {appearance, looks};
      all_at_rest = all_at_rest && looks >= looks_without_change;
      if (ingest::is_sidecar(name)) continue;
      at_rest.push_back(entry.path());
      if (looks >= looks_of_patience) at_rest_for_long.push_back(entry.path());
    }
    seen_ = std::move(now);
    std::vector<fs::path> complete = all_at_rest ? at_rest : at_rest_for_long;
    std::ranges::sort(complete);
    return complete;
  }

 private:
  std::map<fs::path, Seen> seen_;
};

}  // namespace

WatchedFolder::WatchedFolder(const fs::path& folder, OpenStore open_store, ingest::Guard guard)
    : folder_{fs::absolute(folder)}, open_store_{std::move(open_store)}, guard_{std::move(guard)} {
  fs::create_directories(folder_);
  thread_ = std::jthread{[this](const std::stop_token& stop) { watch(stop); }};
}

void WatchedFolder::watch(const std::stop_token& stop) {
  Arrivals arrivals;
  while (!stop.stop_requested()) {
    try {
      const auto complete = arrivals.look(folder_);
      if (!complete.empty()) {
        auto db = open_store_();
        ingest_and_put_away(db, guard_, complete, stop);
      }
    } catch (const std::exception& error) {
      log::error({"watched folder=", folder_.native(), " failed: ", error.what()});
      pause(after_failure, stop);
    }
    pause(interval, stop);
  }
}

}  // namespace floeplan::jobs
