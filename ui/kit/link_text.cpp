#include "ui/kit/link_text.h"

#include <algorithm>

#include <QCoreApplication>

#include "robot/robot.h"

namespace mapwright::window {

std::optional<QDateTime> silentOnline(const session::Session& session) {
  if (session.connection().phase != robot::ConnectionPhase::Online) return std::nullopt;
  return robot::silentSince(session.robot());
}

std::optional<QDateTime> valuesAsOf(const session::Session& session) {
  const auto lost = session.staleSince();
  return lost ? lost : silentOnline(session);
}

StateText linkText(const robot::ConnectionState& state, const std::optional<QDateTime>& silent_since,
                   qint64 waited_ms, const QDateTime& now) {
  if (!silent_since) return connectionText(state, waited_ms);
  const qint64 silent_s = std::max<qint64>(1, silent_since->secsTo(now));
  return {Mark::Warning, QCoreApplication::translate("window", "nothing for %1 s").arg(silent_s)};
}

QString linkWord(const robot::ConnectionState& state, const std::optional<QDateTime>& silent_since) {
  return silent_since ? QCoreApplication::translate("window", "silent") : connectionWord(state.phase);
}

}  // namespace mapwright::window
