#include "engine/mission/document/message.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/messages/sentence.hpp"

namespace floeplan::mission {
namespace {

Severity severity_of(messages::Rank rank) {
  switch (rank) {
    case messages::Rank::danger: return Severity::error;
    case messages::Rank::caution: return Severity::warning;
    case messages::Rank::note: return Severity::note;
  }
  throw std::logic_error{"Rank without a severity"};
}

}  // namespace

Message finding(int line, const messages::Message& message) {
  return {line, severity_of(message.rank), message.code.substr(0, message.code.find('/')),
          messages::whole_text(message)};
}

Verdict verdict_of(const Messages& messages) {
  const auto any = [&](Severity severity) {
    return std::ranges::find(messages, severity, &Message::severity) != messages.end();
  };
  if (any(Severity::error)) return Verdict::reject;
  return any(Severity::warning) ? Verdict::warn : Verdict::ok;
}

std::string severity_name(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: return "error";
  }
  throw std::logic_error{"Severity without a name"};
}

std::string verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::ok: return "ok";
    case Verdict::warn: return "warn";
    case Verdict::reject: return "reject";
  }
  throw std::logic_error{"Verdict without a name"};
}

}  // namespace floeplan::mission
