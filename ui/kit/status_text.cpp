#include "ui/kit/status_text.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "geometry/pose.h"
#include "grids/grid_pyramid.h"
#include "robot/robot.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "session/lacks_picture.h"
#include "words/fixed.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/shortened.h"

namespace mapwright::ui {

namespace {

using robot::ConnectionPhase;
using session::SubmapStatus;

struct StatusLook {
  SubmapStatus status;
  const char *word, *icon;
  Mark mark;
};
constexpr StatusLook kStatusLooks[] = {
    {SubmapStatus::OnScreen, QT_TRANSLATE_NOOP("window", "shown"), "check", Mark::Good},
    {SubmapStatus::Hidden, QT_TRANSLATE_NOOP("window", "hidden"), "eye-off", Mark::Neutral},
    {SubmapStatus::Updating, QT_TRANSLATE_NOOP("window", "updating"), "updating", Mark::Busy},
    {SubmapStatus::Queued, QT_TRANSLATE_NOOP("window", "queued"), "queued", Mark::Neutral},
    {SubmapStatus::Fetching, QT_TRANSLATE_NOOP("window", "fetching"), "fetching", Mark::Busy},
    {SubmapStatus::NoSlice, QT_TRANSLATE_NOOP("window", "no slice"), "empty", Mark::Neutral},
    {SubmapStatus::Missing, QT_TRANSLATE_NOOP("window", "missing"), "missing", Mark::Warning},
    {SubmapStatus::Waiting, QT_TRANSLATE_NOOP("window", "failed"), "waiting", Mark::Warning},
    {SubmapStatus::Corrupt, QT_TRANSLATE_NOOP("window", "corrupt"), "corrupt", Mark::Bad},
    {SubmapStatus::Unplaced, QT_TRANSLATE_NOOP("window", "no pose"), "unplaced", Mark::Bad}};

const StatusLook& lookOf(SubmapStatus status) {
  return *std::find_if(std::begin(kStatusLooks), std::end(kStatusLooks),
                       [status](const StatusLook& look) { return look.status == status; });
}

}  // namespace

QString connectionWord(ConnectionPhase phase) {
  switch (phase) {
    case ConnectionPhase::Offline:
      return QCoreApplication::translate("window", "offline");
    case ConnectionPhase::Connecting:
      return QCoreApplication::translate("window", "connecting");
    case ConnectionPhase::Online:
      return QCoreApplication::translate("window", "connected");
    case ConnectionPhase::Interrupted:
      return QCoreApplication::translate("window", "reconnecting");
    case ConnectionPhase::Refused:
      return QCoreApplication::translate("window", "refused");
  }
  return {};
}

bool wantsSecret(const robot::ConnectionState& state) {
  return state.phase == ConnectionPhase::Refused && state.failure == map::FailureKind::Refused;
}

StateText connectionText(const robot::ConnectionState& state, qint64 waited_ms) {
  const auto because = [&](const QString& text) {
    return state.reason.any() ? words::about(text, sentences::wordsOf(state.reason)) : text;
  };
  switch (state.phase) {
    case ConnectionPhase::Offline:
      return {Mark::Neutral, QCoreApplication::translate("window", "offline")};
    case ConnectionPhase::Connecting:
      return {Mark::Busy, QCoreApplication::translate("window", "connecting…")};
    case ConnectionPhase::Online:
      return {Mark::Good,
              state.round_trip_ms
                  ? QCoreApplication::translate("window", "connected %1 ms").arg(*state.round_trip_ms)
                  : QCoreApplication::translate("window", "connected")};
    case ConnectionPhase::Interrupted: {
      const QString attempt = state.attempt > 0
                                  ? QCoreApplication::translate("window", " (attempt %1)").arg(state.attempt)
                                  : QString();
      if (!state.retry_in_ms)
        return {Mark::Warning, because(QCoreApplication::translate("window", "reconnecting%1").arg(attempt))};
      const qint64 left = std::max<qint64>(0, *state.retry_in_ms - waited_ms);
      if (left == 0)
        return {Mark::Warning,
                because(QCoreApplication::translate("window", "reconnecting now%1").arg(attempt))};
      return {Mark::Warning, because(QCoreApplication::translate("window", "reconnecting in %1 s%2")
                                         .arg(QString::number((left + 999) / 1000), attempt))};
    }
    case ConnectionPhase::Refused:
      return {Mark::Bad, because(QCoreApplication::translate("window", "refused"))};
  }
  return {};
}

QString loadingText(const session::SubmapCounts& counts) {
  if (!counts.list_received) return {};
  if (counts.listed == 0) return QCoreApplication::translate("window", "no submaps");
  QStringList parts;
  parts << QCoreApplication::translate("window", "%1 of %2 submaps")
               .arg(countText(counts.shown), countText(counts.listed));
  const auto add = [&parts](int count, const QString& word) {
    if (count > 0) parts << QStringLiteral("%1 %2").arg(countText(count), word);
  };
  add(counts.hidden, QCoreApplication::translate("window", "hidden"));
  add(counts.missing, QCoreApplication::translate("window", "missing"));
  add(counts.failed, QCoreApplication::translate("window", "failed"));
  add(counts.corrupt, QCoreApplication::translate("window", "corrupt"));
  add(counts.without_slice, QCoreApplication::translate("window", "without this slice"));
  return words::listed(parts);
}

QString trafficText(const session::SubmapCounts& counts) {
  // How many of them are on their way at this moment is known to the adapter alone.
  const int coming = counts.fetching + counts.queued;
  return coming > 0 ? QCoreApplication::translate("window", "%1 to come").arg(countText(coming)) : QString();
}

QString plainWords(const std::string& words, int limit) {
  // Only the beginning matters: a robot may send megabytes.
  const QString line =
      QString::fromUtf8(words.data(), qsizetype(std::min<std::size_t>(words.size(), 8 * std::size_t(limit))));
  return words::shortened(words::plainName(line), limit);
}

QString plainWords(const QString& words, int limit) { return plainWords(words.toStdString(), limit); }

QString mapTitle(const std::string& name) {
  const QString title = plainWords(name, 300);
  return title.isEmpty() ? QCoreApplication::translate("window", "(no name)") : title;
}

QString mapCalled(const QString& name, const map::MapKey& key, int limit) {
  QString called = plainWords(name.toStdString(), limit);
  if (called.isEmpty()) {
    switch (key.kind) {
      case map::MapKind::Live:
        called = QCoreApplication::translate("window", "the live map");
        break;
      case map::MapKind::File:
        called = QCoreApplication::translate("window", "the file");
        break;
      default:
        called = plainWords("map " + map::toText(key), limit);
    }
  }
  return called;
}

QString mapProgressText(const session::MapSlot& slot) {
  const QString name = mapCalled(slot.name(), slot.key(), 40);
  switch (slot.phase()) {
    case session::MapSlot::Phase::Fetching:
      return slot.key().kind == map::MapKind::Live
                 ? QCoreApplication::translate("window", "Waiting for %1").arg(name)
                 : QCoreApplication::translate("window", "Fetching %1").arg(name);
    case session::MapSlot::Phase::Reading:
      // A newer version of the whole map on screen, as some robots send it several times a second.
      if (slot.cells() && slot.shown().key == slot.key() && slot.cells()->complete()) return {};
      return QCoreApplication::translate("window", "Reading %1 %2 %")
          .arg(name, QString::number(int(slot.progress() * 100)));
    case session::MapSlot::Phase::Failed:
      return session::lacksPicture(slot)
                 ? QCoreApplication::translate("window", "%1, without its picture").arg(name)
                 : QCoreApplication::translate("window", "%1 failed").arg(name);
    case session::MapSlot::Phase::Empty:
    case session::MapSlot::Phase::Ready:
      break;
  }
  return {};
}

QString mapOnScreen(const session::MapSlot& slot, int limit) {
  const map::WholeMap& shown = slot.shown();
  const bool other = slot.cells() && !(shown.key == slot.key());
  return other ? mapCalled(QString::fromStdString(shown.name), shown.key, limit)
               : mapCalled(slot.name(), slot.key(), limit);
}

QString mapShownText(const session::MapSlot& slot) {
  const QString progress = mapProgressText(slot);
  if (!progress.isEmpty() || !slot.cells()) return progress;
  return QCoreApplication::translate("mapwright::ui::StatusText", "%1, %2 x %3 cells")
      .arg(mapOnScreen(slot, 40), countText(slot.reference().width), countText(slot.reference().height));
}

QString coordinatesText(const Eigen::Vector2d& world_m, double scale_m_per_px) {
  if (!world_m.allFinite() || !(scale_m_per_px > 0)) return QStringLiteral("x ? y ? m");
  // The last digit is never finer than about a pixel: 2 cm and 5 cm per pixel give centimetres, 2 mm gives
  // millimetres.
  const int decimals = std::clamp(int(std::ceil(-std::log10(scale_m_per_px) - 1e-9)), 0, 3);
  return QStringLiteral("x %1 y %2 m")
      .arg(words::fixed(world_m.x(), decimals), words::fixed(world_m.y(), decimals));
}

QString coordinatesForClipboard(const Eigen::Vector2d& world_m) {
  return QStringLiteral("%1, %2").arg(words::fixed(world_m.x(), 3), words::fixed(world_m.y(), 3));
}

QString occupancyText(std::optional<int> occupied_percent) {
  if (!occupied_percent) return QCoreApplication::translate("window", "unknown");
  const int occupied = std::clamp(*occupied_percent, 0, 100);
  if (occupied >= 50) return QCoreApplication::translate("window", "occupied %1 %").arg(occupied);
  return QCoreApplication::translate("window", "free %1 %").arg(100 - occupied);
}

QString scaleText(double scale_m_per_px, double dots_per_inch) {
  if (!(scale_m_per_px > 0) || !std::isfinite(scale_m_per_px)) return {};
  const double denominator = scale_m_per_px * dots_per_inch / 0.0254;
  // Three significant digits are enough for a screen's resolution.
  const double step = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(1.0, denominator))) - 2));
  const double shown = std::round(denominator / step) * step;
  const QString ratio = denominator >= 1
                            ? QStringLiteral("1:%1").arg(countText(qint64(shown)))
                            : QStringLiteral("%1:1").arg(QString::number(1 / denominator, 'g', 3));
  double value = scale_m_per_px;
  QString unit = QStringLiteral("m/px");
  if (value < 0.01 - 1e-12) {
    value *= 1000;
    unit = QStringLiteral("mm/px");
  } else if (value < 1 - 1e-12) {
    value *= 100;
    unit = QStringLiteral("cm/px");
  } else if (value >= 1000) {
    value /= 1000;
    unit = QStringLiteral("km/px");
  }
  return QStringLiteral("%1  %2 %3").arg(ratio, QString::number(value, 'g', 3), unit);
}

QString rotationText(double rotation_rad) {
  if (!std::isfinite(rotation_rad)) return {};
  double degrees = geometry::degreesFromRadians(geometry::normalizeAngle(rotation_rad));
  degrees = std::round(degrees * 10) / 10;
  if (degrees <= -180) degrees += 360;
  return QStringLiteral("%1°").arg(words::fixed(degrees, degrees == std::round(degrees) ? 0 : 1));
}

QString bytesText(qint64 bytes) {
  const QLocale c = QLocale::c();
  if (bytes < 1000) return QStringLiteral("%1 B").arg(bytes);
  double value = double(bytes);
  for (const auto* unit : {"KB", "MB", "GB"}) {
    value /= 1000;
    if (value < 999.95 || qstrcmp(unit, "GB") == 0) {
      return QStringLiteral("%1 %2").arg(c.toString(value, 'f', value < 99.95 ? 1 : 0), QLatin1String(unit));
    }
  }
  return {};
}

QString countText(qint64 count) { return QLocale(QLocale::English).toString(count); }

QString problemsText(qint64 count) {
  const int form = sentences::formOf(count);
  return sentences::counted(QCoreApplication::translate("window", "%1 problems", nullptr, form), count);
}

QString submapsText(qint64 count) {
  const int form = sentences::formOf(count);
  return sentences::counted(QCoreApplication::translate("window", "%1 submaps", nullptr, form), count);
}

QString statusWord(SubmapStatus status) { return QCoreApplication::translate("window", lookOf(status).word); }

QString statusIcon(SubmapStatus status) { return QLatin1String(lookOf(status).icon); }

Mark statusMark(SubmapStatus status) { return lookOf(status).mark; }

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

}  // namespace mapwright::ui
