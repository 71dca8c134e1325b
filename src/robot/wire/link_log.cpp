#include "robot/wire/link_log.h"

namespace mapwright::robot::wire {
namespace {

const char* nameOf(ConnectionPhase phase) {
  switch (phase) {
    case ConnectionPhase::Offline:
      return "offline";
    case ConnectionPhase::Connecting:
      return "connecting";
    case ConnectionPhase::Online:
      return "online";
    case ConnectionPhase::Interrupted:
      return "interrupted";
    case ConnectionPhase::Refused:
      break;
  }
  return "refused";
}

}  // namespace

void LinkLog::note(const ConnectionState& state) {
  const bool same = state.phase == last_.phase && state.reason == last_.reason;
  last_ = state;
  if (same) return;
  const std::string why = inEnglish(state.reason);
  const std::string next =
      state.retry_in_ms ? "; retry in " + std::to_string(*state.retry_in_ms) + " ms" : std::string();
  qCInfo(category_, "%s: %s%s%s%s", who_.c_str(), nameOf(state.phase), why.empty() ? "" : ": ", why.c_str(),
         next.c_str());
}

void LinkLog::note(const Fault& fault) {
  qCInfo(category_, "%s: %s", who_.c_str(), inEnglish(fault).c_str());
}

}  // namespace mapwright::robot::wire
