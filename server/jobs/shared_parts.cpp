#include "server/jobs/shared_parts.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "api/codec/bytes/sha256.hpp"
#include "api/log/log.hpp"
#include "engine/core/version.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"

namespace floeplan::jobs {
namespace {

using repository::JobParts;

/// A waiting leader looks into the store this often if nobody wakes it.
constexpr std::chrono::seconds look{1};

std::string basis_of(sql::Connection& db) {
  return codec::sha256(std::string{core::program_version()} + '\n' +
                       repository::DatasetRepository{db}.contents());
}

/// A name that no earlier holder of this node had, so that nobody renews what an earlier one has left.
std::string new_name(const std::string& worker) {
  static std::atomic<std::uint64_t> names{0};
  return worker + ":" + std::to_string(++names);
}

/// Lets one thread wait until it is woken.
class Bell {
 public:
  void ring() {
    {
      const std::lock_guard lock{mutex_};
      has_rung_ = true;
    }
    rung_.notify_one();
  }
  /// Returns after a ring since the last call, after `at_most`, or on `stop`.
  void wait(std::chrono::milliseconds at_most, const std::stop_token& stop) {
    std::unique_lock lock{mutex_};
    rung_.wait_for(lock, stop, at_most, [&] { return has_rung_; });
    has_rung_ = false;
  }

 private:
  std::mutex mutex_;
  std::condition_variable_any rung_;
  bool has_rung_{false};
};

}  // namespace

void PartHolders::add(const std::string& name, Holder holder) {
  const std::lock_guard lock{mutex_};
  holders_.emplace(name, std::move(holder));
}

void PartHolders::remove(const std::string& name) {
  const std::lock_guard lock{mutex_};
  holders_.erase(name);
}

void PartHolders::renew(sql::Connection& db, core::UtcTime now, core::Seconds lease) {
  std::map<std::string, Holder> holders;
  {
    const std::lock_guard lock{mutex_};
    holders = holders_;
  }
  for (auto& [name, holder] : holders)
    if (!JobParts{db}.renew(holder.job, name, now, lease)) holder.stop.request_stop();
}

/// One stage of the job's work, as this node does it.
class SharedParts::Stage {
 public:
  Stage(const SharedParts& shared, const Parts& parts)
      : shared_{shared},
        parts_{parts},
        stage_{shared.settings_.job, shared.stages_, shared.basis_},
        stop_{shared.settings_.stop.get_token()},
        is_taken_(parts.count, false) {}

  void offer() { JobParts{shared_.db_}.offer(stage_, parts_.count); }

  /// Does free parts on all threads until none is left. `take_meanwhile`: whether the results of finished parts
  /// are passed on between them.
  void do_free_parts(bool take_meanwhile) {
    shared_.threads_.run(shared_.settings_.threads, [&](std::size_t, bool is_caller) {
      while (const auto part = next()) {
        const auto result = parts_.work(*part, is_caller);
        if (!result) return;
        finish(*part, *result);
        if (is_caller && take_meanwhile) take_finished();
      }
    });
  }

  /// Passes on the results of finished parts, each once. Returns  whether all parts are
  bool take_finished() {
    const std::lock_guard lock{mutex_};
    const JobParts kept{shared_.db_};
    for (const std::size_t part : kept.finished(stage_)) {
      if (part >= parts_.count || is_taken_[part]) continue;
      const auto result = kept.result(stage_, part);
      if (!result) continue;
      parts_.take(part, *result);
      is_taken_[part] = true;
      ++taken_;
    }
    return taken_ == parts_.count;
  }

  [[nodiscard]] bool is_stopped() const { return stop_.stop_requested(); }
  [[nodiscard]] std::size_t done_here() const { return done_; }

 private:
  std::optional<std::size_t> next() {
    if (is_stopped()) return std::nullopt;
    const std::lock_guard lock{mutex_};
    return JobParts{shared_.db_}.take(stage_, shared_.holder_, sql::time_of(shared_.db_),
                                      shared_.settings_.lease);
  }

  void finish(std::size_t part, const std::string& result) {
    const std::lock_guard lock{mutex_};
    if (JobParts{shared_.db_}.finish(stage_, part, shared_.holder_, result)) ++done_;
  }

  const SharedParts& shared_;
  const Parts& parts_;
  repository::JobStage stage_;
  std::stop_token stop_;
  std::mutex mutex_;  // of the connection, which the threads share, and of all below
  std::vector<bool> is_taken_;
  std::size_t taken_{0};
  std::size_t done_{0};
};

SharedParts::SharedParts(sql::Connection& db, JobBoard& board, PartHolders& holders, Settings settings)
    : db_{db},
      board_{board},
      holders_{holders},
      settings_{std::move(settings)},
      threads_{settings_.threads},
      holder_{new_name(settings_.worker)},
      basis_{basis_of(db)} {
  holders_.add(holder_, {settings_.job, settings_.stop});
}

SharedParts::~SharedParts() {
  holders_.remove(holder_);
  try {
    JobParts{db_}.give_back(settings_.job, holder_);
  } catch (const std::exception& error) {
    log::warn({"job=", settings_.job.value,
               " parts could not be given back; they are free when their lease ends: ", error.what()});
  }
}

void SharedParts::run_parts(const Parts& parts) const {
  ++stages_;
  if (parts.count < 2) return Executor::run_parts(parts);
  const bool leads = settings_.role == Role::leads;
  if (basis_of(db_) != basis_) {
    if (leads) return Executor::run_parts(parts);
    settings_.stop.request_stop();
    return;
  }
  Stage stage{*this, parts};
  if (!leads) {
    stage.do_free_parts(false);
    done_here_ += stage.done_here();
    // A stage that was finished before this node came is passed; after any other, whoever leads goes on.
    if (stage.done_here() > 0 || !stage.take_finished()) settings_.stop.request_stop();
    return;
  }
  const auto bell = std::make_shared<Bell>();
  const auto subscription = board_.subscribe(settings_.job, [bell] { bell->ring(); });
  stage.offer();
  while (true) {
    stage.do_free_parts(true);
    if (stage.take_finished() || stage.is_stopped()) return;
    bell->wait(look, settings_.stop.get_token());
  }
}

}  // namespace floeplan::jobs
