#include "storage/repository/work/job_announcements.hpp"

#include "storage/sql/shared/announcements.hpp"

namespace floeplan::repository {

/// The store announces by this name, see `server_scripts`.
void listen_to_jobs(sql::Connection& db) { sql::listen(db, "floeplan_job"); }

ChangedJobs wait_for_changed_jobs(sql::Connection& db, std::chrono::milliseconds at_most) {
  const sql::Announced announced = sql::announced(db, at_most);
  ChangedJobs changed{.jobs = {}, .missed = announced.missed};
  for (const std::string& text : announced.texts) {
    const auto space = text.find(' ');
    if (space != std::string::npos) changed.jobs.push_back({{text.substr(0, space)}, text.substr(space + 1)});
  }
  return changed;
}

}  // namespace floeplan::repository
