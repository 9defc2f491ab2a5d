#include "storage/ingest/process/guarded_ingest.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>

#include "engine/messages/ingest_file_messages.hpp"
#include "storage/ingest/files/archive.hpp"
#include "storage/ingest/ingest_file.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/process/reader_main.hpp"
#include "storage/ingest/process/reader_work.hpp"
#include "storage/ingest/process/staging_folder.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/datasets/dataset_rows.hpp"
#include "storage/repository/datasets/dataset_transfer.hpp"
#include "storage/repository/store/migrations.hpp"

namespace floeplan::ingest {
namespace {

/// Whether every file is in a group and is the first of at most one. The answer of the process is checked,
/// because a file may have broken it. Several groups may need the same further file.
bool groups_all(const Grouped& grouped, std::size_t count) {
  std::set<std::size_t> seen;
  std::set<std::size_t> heads;
  for (const auto& group : grouped.groups) {
    if (group.empty() || !heads.insert(group.front()).second) return false;
    const std::set<std::size_t> members{group.begin(), group.end()};
    if (members.size() != group.size() || *members.rbegin() >= count) return false;
    seen.insert(members.begin(), members.end());
  }
  return seen.size() == count;
}

/// Lets a confined process group the files. A file that breaks the process is not given to it again: it makes
/// a group of its own, and is refused when it is read.
std::vector<FileGroup> guarded_groups(const Guard& guard, FileGroup files, const std::stop_token& stop) {
  std::vector<FileGroup> groups;
  while (files.size() > 1 && !stop.stop_requested()) {
    const StagingFolder staging{guard.staging};
    const Told told = run_reader(guard, staging.path(), files,
                                 {.task = ReaderRequest::Task::group, .options = {}, .now = {}, .limits = {}},
                                 stop, {}, {});
    if (!told.breakdown && told.grouped && groups_all(*told.grouped, files.size())) {
      for (const auto& numbers : told.grouped->groups) {
        FileGroup& group = groups.emplace_back();
        for (const std::size_t number : numbers) group.push_back(files[number]);
      }
      return groups;
    }
    const auto culprit =
        files.begin() + static_cast<std::ptrdiff_t>(std::min(told.looks_at, files.size() - 1));
    groups.push_back({*culprit});
    files.erase(culprit);
  }
  for (const auto& file : files) groups.push_back({file});
  return groups;
}

/// Creates a store for the reader of one group of files. It lists the datasets that are stored already, so
/// that no file is read twice. Afterwards only the reader opens it.
void prepare_scratch_store(sql::Connection& db, const std::filesystem::path& folder) {
  auto scratch = repository::open_scratch_store(folder);
  repository::DatasetRepository listed{scratch};
  for (const auto& dataset : repository::DatasetRepository{db}.list()) listed.insert(dataset);
}

/// Receives the rows that a reader sends, in a store of this process's own, until they are complete.
class Delivery {
 public:
  explicit Delivery(const std::filesystem::path& parent) : parent_{parent} {}

  void take(std::string_view parcel) {
    if (!receiver_) {
      db_.emplace(repository::open_scratch_store(folder_.emplace(parent_).path()));
      receiver_.emplace(*db_);
    }
    receiver_->take(parcel);
  }

  /// Takes the received datasets over into `db`, if they are those that were reported.
  /// Errors   repository::BrokenParcel when they are not
  std::vector<repository::DatasetId> take_over(sql::Connection& db,
                                               const std::vector<IngestReport>& reports) {
    std::vector<std::string> reported;
    for (const IngestReport& report : reports)
      if (report.status == IngestStatus::stored) reported.push_back(report.dataset->id.value);
    std::vector<std::string> came;
    if (receiver_)
      for (const repository::DatasetId& id : receiver_->finish()) came.push_back(id.value);
    std::ranges::sort(reported);
    std::ranges::sort(came);
    if (came != reported) throw repository::BrokenParcel{"other datasets than were reported"};
    if (came.empty()) return {};
    receiver_.reset();
    db_.reset();
    return repository::take_over_datasets(db, folder_->path());
  }

 private:
  const std::filesystem::path& parent_;
  std::optional<StagingFolder> folder_;
  std::optional<sql::Connection> db_;
  std::optional<repository::DatasetReceiver> receiver_;
};

/// The report for files on which the reader broke down. Requires `told.breakdown`.
IngestReport refused_by_breakdown(const FileGroup& files, const IngestOptions& options, const Told& told) {
  IngestReport report = refused(files, options, {*told.breakdown});
  report.technical_cause = told.technical_cause;
  return report;
}

/// Whether a report is consistent; a broken reader may send anything.
bool is_possible(const IngestReport& report) {
  return (report.status == IngestStatus::refused) == !report.dataset &&
         report.errors.empty() != !report.dataset;
}

/// Completes a reader's report with the dataset as it is stored now. Meanwhile another process may have
/// stored the same file or removed it.
IngestReport completed(sql::Connection& db, IngestReport report,
                       const std::vector<repository::DatasetId>& taken_over) {
  if (!report.dataset) return report;
  const repository::DatasetId id = report.dataset->id;
  report.dataset = repository::DatasetRepository{db}.find(id);
  if (report.status == IngestStatus::stored && std::ranges::find(taken_over, id) == taken_over.end()) {
    report.status = IngestStatus::unchanged;
    report.warnings.clear();
  }
  if (!report.dataset) {
    report.status = IngestStatus::refused;
    report.errors = {messages::ingest_file_message<"removed-while-read">()};
  }
  return report;
}

std::optional<std::vector<IngestReport>> ingest_one_group(sql::Connection& db, const Guard& guard,
                                                          const FileGroup& files,
                                                          const IngestOptions& options, core::UtcTime now,
                                                          const std::stop_token& stop,
                                                          const core::ProgressCallback& progress) {
  const StagingFolder staging{guard.staging};
  prepare_scratch_store(db, staging.path());
  Delivery delivery{guard.staging};
  Told told = run_reader(guard, staging.path(), files,
                         {.task = ReaderRequest::Task::ingest, .options = options, .now = now, .limits = {}},
                         stop, progress, [&](std::string_view parcel) { delivery.take(parcel); });
  if (told.stopped) return std::nullopt;
  if (!told.breakdown && (told.reports.empty() || !std::ranges::all_of(told.reports, is_possible)))
    told.breakdown = unexplained_end();
  if (told.breakdown) return std::vector{refused_by_breakdown(files, options, told)};
  std::vector<repository::DatasetId> taken_over;
  try {
    taken_over = delivery.take_over(db, told.reports);
  } catch (const repository::BrokenParcel&) {
    return std::vector{refused(files, options, {unexplained_end()})};
  }
  std::vector<IngestReport> reports;
  reports.reserve(told.reports.size());
  for (IngestReport& report : told.reports) reports.push_back(completed(db, std::move(report), taken_over));
  return reports;
}

/// The files to read: archives are unpacked, and their files are read like any other file.
class Arrivals {
 public:
  Arrivals(const Guard& guard, const IngestOptions& options) : guard_{guard}, options_{options} {}

  /// Adds a file, or the files of an archive.
  /// Returns  why the file is refused; empty: its content is among files()
  std::optional<IngestReport> add(const std::filesystem::path& file, const std::stop_token& stop) {
    if (!is_archive(file)) {
      files_.push_back(file);
      return std::nullopt;
    }
    const std::filesystem::path& staging = folders_.emplace_back(guard_.staging).path();
    Told told = run_reader(guard_, staging, {file},
                           {.task = ReaderRequest::Task::unpack, .options = {}, .now = {}, .limits = {}},
                           stop, {}, {});
    if (told.stopped) return std::nullopt;
    if (!told.breakdown && told.reports.size() == 1) return std::move(told.reports.front());
    if (told.breakdown) return refused_by_breakdown({file}, {}, told);
    const auto& unpacked = told.unpacked;
    if (!unpacked || !are_inside(unpacked->data)) return refused({file}, {}, {unexplained_end()});
    for (const std::string& name : unpacked->data) {
      files_.push_back(staging / unpacked_folder / name);
      archive_of_[files_.back()] = file;
    }
    left_out_[file] = unpacked->left_out;
    return std::nullopt;
  }

  [[nodiscard]] const FileGroup& files() const { return files_; }

  /// The files given by the user: these files, or the archives that they come from.
  [[nodiscard]] FileGroup given(const FileGroup& files) const {
    FileGroup given;
    for (const auto& file : files) {
      const auto archive = archive_of_.find(file);
      const auto& source = archive == archive_of_.end() ? file : archive->second;
      if (std::ranges::find(given, source) == given.end()) given.push_back(source);
    }
    return given;
  }

  /// The only dataset of an archive gets the archive's name, because a name such as "doc.kml" says nothing.
  [[nodiscard]] IngestOptions options_for(const FileGroup& files,
                                          const std::vector<FileGroup>& groups) const {
    IngestOptions options = options_;
    const auto archive = archive_of_.find(files.front());
    if (archive == archive_of_.end()) return options;
    options.archive = archive->second.filename().string();
    const FileGroup source = given(files);
    const auto alone =
        std::ranges::count_if(groups, [&](const FileGroup& other) { return given(other) == source; });
    const bool says_its_name = files.front().filename() == archive->second.stem();
    if (alone == 1 && !options.name && !says_its_name) options.name = archive->second.stem().string();
    return options;
  }

  /// Adds a warning with the names of other files in the archive, in the first report about it only.
  void tell_left_out(const FileGroup& files, IngestReport& report) {
    const auto archive = archive_of_.find(files.front());
    if (archive == archive_of_.end()) return;
    auto& names = left_out_[archive->second];
    if (!names.empty())
      report.warnings.push_back(messages::ingest_file_message<"left-out-of-archive">(enumeration(names)));
    names.clear();
  }

 private:
  static bool are_inside(const std::vector<std::string>& names) {
    return std::ranges::all_of(names, [](const std::filesystem::path& name) {
      return name.is_relative() && std::ranges::find(name, "..") == name.end();
    });
  }

  const Guard& guard_;
  const IngestOptions& options_;
  std::deque<StagingFolder> folders_;
  FileGroup files_;
  std::map<std::filesystem::path, std::filesystem::path> archive_of_;
  std::map<std::filesystem::path, std::vector<std::string>> left_out_;
};

}  // namespace

std::optional<sandbox::Layers> layers_in_force(const Guard& guard) {
  const StagingFolder staging{guard.staging};
  return run_reader(guard, staging.path(), {},
                    {.task = ReaderRequest::Task::probe, .options = {}, .now = {}, .limits = {}}, {}, {}, {})
      .layers;
}

std::vector<IngestReport> guarded_ingest(sql::Connection& db, const Guard& guard,
                                         const std::vector<std::filesystem::path>& files,
                                         const IngestOptions& options, core::UtcTime now,
                                         const std::stop_token& stop, const core::ProgressCallback& progress,
                                         const std::function<void(const IngestReport&)>& reported) {
  std::vector<IngestReport> reports;
  const auto tell = [&](IngestReport report, FileGroup given) {
    report.files = std::move(given);
    if (reported) reported(report);
    reports.push_back(std::move(report));
  };
  Arrivals arrivals{guard, options};
  for (const auto& file : files) {
    if (stop.stop_requested()) return reports;
    if (auto refusal = arrivals.add(file, stop)) tell(std::move(*refusal), {file});
  }
  const std::vector<FileGroup> groups = guarded_groups(guard, arrivals.files(), stop);
  for (std::size_t i = 0; i < groups.size() && !stop.stop_requested(); ++i) {
    const auto of_all = [&](std::string_view stage, double share) {
      if (progress) progress(stage, (static_cast<double>(i) + share) / static_cast<double>(groups.size()));
    };
    auto of_group =
        ingest_one_group(db, guard, groups[i], arrivals.options_for(groups[i], groups), now, stop, of_all);
    if (!of_group) break;
    for (IngestReport& report : *of_group) {
      arrivals.tell_left_out(groups[i], report);
      tell(std::move(report), arrivals.given(groups[i]));
    }
  }
  return reports;
}

}  // namespace floeplan::ingest
