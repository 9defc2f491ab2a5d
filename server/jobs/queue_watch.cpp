#include "server/jobs/queue_watch.hpp"

#include <chrono>
#include <utility>

#include "api/log/log.hpp"
#include "server/jobs/pause.hpp"
#include "storage/repository/work/job_announcements.hpp"
#include "storage/sql/driver/failure.hpp"
#include "storage/sql/shared/use_of_store.hpp"

namespace floeplan::jobs {
namespace {

/// Longest time from a requested stop until the thread notices it.
constexpr std::chrono::milliseconds at_most{250};

void watch(sql::Connection& db, JobBoard& board, const std::stop_token& stop) {
  bool reached = true;
  while (!stop.stop_requested()) {
    try {
      const repository::ChangedJobs changed = repository::wait_for_changed_jobs(db, at_most);
      if (changed.missed) board.take_note_of_all();
      for (const auto& job : changed.jobs) board.take_note(job.id, job.status);
      if (!reached) log::info({"queue heard again"});
      reached = true;
    } catch (const sql::Failure& failure) {
      if (reached) log::warn({"queue not heard: ", failure.what()});
      reached = false;
      pause(std::chrono::seconds{1}, stop);
    }
  }
}

}  // namespace

QueueWatch::QueueWatch(sql::Connection db, JobBoard& board) {
  sql::use_store(db);
  repository::listen_to_jobs(db);
  thread_ = std::jthread{[own = std::move(db), &board](const std::stop_token& stop) mutable { watch(own, board, stop); }};
}

}  // namespace floeplan::jobs
