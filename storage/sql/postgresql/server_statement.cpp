#include "storage/sql/postgresql/server_statement.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "storage/sql/driver/failure.hpp"

namespace floeplan::sql::postgresql {

ServerStatement::ServerStatement(ServerSession& session, const std::string& sql)
    : session_{session}, text_{server_text(sql)}, values_(text_.ours.size()) {}

void ServerStatement::put(int parameter, WireValue value) {
  if (result_) throw Failure{"a statement must be reset before its values change"};
  const auto place = std::ranges::find(text_.ours, parameter);
  if (place == text_.ours.end()) throw Failure{"a statement has no parameter " + std::to_string(parameter)};
  values_[static_cast<std::size_t>(place - text_.ours.begin())] = std::move(value);
}

bool ServerStatement::step() {
  if (!result_) result_ = session_.run(text_.sql, values_);
  if (row_ + 1 >= PQntuples(result_.get())) {
    reset();
    return false;
  }
  ++row_;
  return true;
}

int ServerStatement::run() {
  const Result result = session_.run(text_.sql, values_);
  reset();
  const std::string_view told = PQcmdTuples(result.get());
  int changed = 0;
  std::from_chars(told.data(), told.data() + told.size(), changed);
  return changed;
}

void ServerStatement::reset() {
  result_.reset();
  row_ = -1;
}

bool ServerStatement::is_null(int column) const {
  check(column);
  return PQgetisnull(result_.get(), row_, column) != 0;
}

std::string ServerStatement::text(int column) const {
  check(column);
  return text_at(result_.get(), row_, column);
}

std::int64_t ServerStatement::integer(int column) const {
  check(column);
  return integer_at(result_.get(), row_, column);
}

double ServerStatement::real(int column) const {
  check(column);
  return real_at(result_.get(), row_, column);
}

std::span<const std::byte> ServerStatement::blob(int column) const {
  check(column);
  return bytes_at(result_.get(), row_, column);
}

void ServerStatement::check(int column) const {
  if (!result_ || row_ < 0) throw Failure{"a statement that stands at no row has no values"};
  if (column < 0 || column >= PQnfields(result_.get()))
    throw Failure{"a statement has no column " + std::to_string(column)};
}

}  // namespace floeplan::sql::postgresql
