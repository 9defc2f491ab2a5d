#include "storage/sql/postgresql/server_session.hpp"

#include <poll.h>

#include <array>
#include <new>
#include <utility>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/postgresql/server_failure.hpp"

namespace floeplan::sql::postgresql {
namespace {

/// More than the number of different statements that this program runs, and little memory for a server.
constexpr std::size_t most_parsed = 300;

bool has_succeeded(const Result& result) {
  const ExecStatusType status = PQresultStatus(result.get());
  return status == PGRES_COMMAND_OK || status == PGRES_TUPLES_OK || status == PGRES_EMPTY_QUERY;
}

std::string text_of(const char* text) { return text != nullptr ? text : ""; }

struct FreeMemory {
  void operator()(void* of_library) const { PQfreemem(of_library); }
};

/// Opens a session. One whose server has become silent is given up after about ten seconds, unless the address says
/// otherwise: a statement would wait for a quarter of an hour.
PGconn* connect(const std::string& address) {
  constexpr std::array<const char*, 7> names{"connect_timeout",     "tcp_user_timeout", "keepalives_idle",
                                             "keepalives_interval", "keepalives_count", "dbname",
                                             nullptr};
  const std::array<const char*, 7> values{"10", "10000", "5", "2", "3", address.c_str(), nullptr};
  return PQconnectdbParams(names.data(), values.data(), 1);
}

}  // namespace

ServerSession::ServerSession(const std::string& address, std::string settings)
    : connection_{connect(address)}, settings_{std::move(settings)} {
  if (!connection_) throw std::bad_alloc{};
  name_ = text_of(PQdb(connection_.get())) + " at " + text_of(PQhost(connection_.get()));
  if (PQstatus(connection_.get()) != CONNECTION_OK) throw failure_of(nullptr, connection_.get(), name_);
  PQsetNoticeProcessor(connection_.get(), [](void*, const char*) {}, nullptr);
  run_script(settings_);
}

void ServerSession::reconnect_if_lost() {
  if (PQstatus(connection_.get()) == CONNECTION_OK) return;
  if (has_begun_) throw Failure{messages::store_text<"transaction-undone">(name_), Trouble::not_writable};
  has_missed_ = true;
  PQreset(connection_.get());
  if (PQstatus(connection_.get()) != CONNECTION_OK) throw failure_of(nullptr, connection_.get(), name_);
  parsed_.clear();
  const Result result{PQexec(connection_.get(), settings_.c_str())};
  if (!has_succeeded(result)) throw failure_of(result.get(), connection_.get(), name_);
}

void ServerSession::begin(const std::string& statement) {
  run_script(statement);
  has_begun_ = true;
}

void ServerSession::commit() {
  if (PQtransactionStatus(connection_.get()) != PQTRANS_INTRANS) {
    roll_back();
    throw Failure{messages::store_text<"transaction-undone">(name_), Trouble::not_writable};
  }
  run_script("COMMIT");
  has_begun_ = false;
}

void ServerSession::roll_back() {
  has_begun_ = false;
  if (PQstatus(connection_.get()) == CONNECTION_OK) run_script("ROLLBACK");
}

void ServerSession::run_script(const std::string& script) {
  reconnect_if_lost();
  const Result result{PQexec(connection_.get(), script.c_str())};
  if (!has_succeeded(result)) throw failure_of(result.get(), connection_.get(), name_);
}

std::string ServerSession::parsed(const std::string& sql, const std::vector<Oid>& types) {
  if (const auto known = parsed_.find({sql, types}); known != parsed_.end()) return known->second;
  if (parsed_.size() >= most_parsed) {
    run_script("DEALLOCATE ALL");
    parsed_.clear();
  }
  std::string name = "s" + std::to_string(++names_given_);
  const Result result{
      PQprepare(connection_.get(), name.c_str(), sql.c_str(), static_cast<int>(types.size()), types.data())};
  if (!has_succeeded(result)) throw failure_of(result.get(), connection_.get(), name_);
  parsed_.emplace(std::pair{sql, types}, name);
  return name;
}

void ServerSession::run_in_each(const std::string& statement) {
  run_script(statement);
  settings_ += "; " + statement;
}

Announced ServerSession::announced(std::chrono::milliseconds at_most) {
  reconnect_if_lost();
  Announced heard{.texts = received(), .missed = std::exchange(has_missed_, false)};
  if (heard.missed || !heard.texts.empty()) return heard;
  pollfd socket{.fd = PQsocket(connection_.get()), .events = POLLIN, .revents = 0};
  (void)poll(&socket, 1, static_cast<int>(at_most.count()));
  if (PQconsumeInput(connection_.get()) == 0) throw failure_of(nullptr, connection_.get(), name_);
  heard.texts = received();
  return heard;
}

std::vector<std::string> ServerSession::received() {
  std::vector<std::string> texts;
  while (const std::unique_ptr<PGnotify, FreeMemory> one{PQnotifies(connection_.get())})
    texts.emplace_back(one->extra);
  return texts;
}

Result ServerSession::run(const std::string& sql, const std::vector<WireValue>& values) {
  reconnect_if_lost();
  std::vector<Oid> types;
  std::vector<const char*> bytes;
  std::vector<int> lengths;
  for (const WireValue& value : values) {
    types.push_back(static_cast<Oid>(value.type));
    bytes.push_back(value.is_null ? nullptr : value.bytes.empty() ? "" : value.bytes.data());
    lengths.push_back(static_cast<int>(value.bytes.size()));
  }
  const std::vector<int> binary(values.size(), 1);
  const std::string name = parsed(sql, types);
  Result result{PQexecPrepared(connection_.get(), name.c_str(), static_cast<int>(values.size()), bytes.data(),
                               lengths.data(), binary.data(), 1)};
  if (!has_succeeded(result)) throw failure_of(result.get(), connection_.get(), name_);
  return result;
}

}  // namespace floeplan::sql::postgresql
