#include "edit/drafts.h"

#include <cmath>
#include <utility>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLoggingCategory>
#include <QPointer>
#include <QTimer>
#include <QUuid>

#include "disk/file_error.h"
#include "disk/private_folder.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "edit/faults.h"
#include "words/text.h"

namespace mapwright::edit {
namespace {

Q_LOGGING_CATEGORY(lcEdit, "mapwright.edit", QtWarningMsg)

constexpr int kFormat = 1;
constexpr std::size_t kLongestDraft = std::size_t(256) << 20;

using words::text;

QJsonObject jsonOf(const map::Waypoint& point) {
  QJsonObject object{
      {QStringLiteral("id"), text(point.id)},        {QStringLiteral("name"), text(point.name)},
      {QStringLiteral("type"), text(point.type)},    {QStringLiteral("x_m"), point.position_m.x()},
      {QStringLiteral("y_m"), point.position_m.y()}, {QStringLiteral("source"), text(point.source)}};
  if (point.yaw_rad) object[QStringLiteral("yaw_rad")] = *point.yaw_rad;
  QJsonArray tags;
  for (const std::string& tag : point.tags) tags << text(tag);
  object[QStringLiteral("tags")] = tags;
  return object;
}

std::optional<map::Waypoint> waypointFrom(const QJsonObject& object) {
  map::Waypoint point;
  for (const auto& [name, into] : {std::pair{"id", &point.id},
                                   {"name", &point.name},
                                   {"type", &point.type},
                                   {"source", &point.source}}) {
    const QJsonValue value = object.value(QLatin1String(name));
    if (!value.isString()) return std::nullopt;
    *into = value.toString().toStdString();
  }
  const QJsonValue x = object.value(QLatin1String("x_m")), y = object.value(QLatin1String("y_m")),
                   yaw = object.value(QLatin1String("yaw_rad")), tags = object.value(QLatin1String("tags"));
  if (!x.isDouble() || !y.isDouble() || !tags.isArray()) return std::nullopt;
  point.position_m = {x.toDouble(), y.toDouble()};
  if (yaw.isDouble()) point.yaw_rad = yaw.toDouble();
  if (!point.position_m.allFinite() || !std::isfinite(point.yaw_rad.value_or(0))) return std::nullopt;
  for (const QJsonValue& tag : tags.toArray()) {
    if (!tag.isString()) return std::nullopt;
    point.tags.push_back(tag.toString().toStdString());
  }
  return point;
}

QString stemOf(const DraftIdentity& of) {
  const QByteArray text = of.kind.toUtf8() + '\n' + of.map.toUtf8() + '\n' + of.address.toUtf8();
  return QString::fromLatin1(QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex().left(24));
}

std::unique_ptr<QLockFile> lockOf(const QString& path) {
  auto lock = std::make_unique<QLockFile>(path + QStringLiteral(".lock"));
  lock->setStaleLockTime(0);  // held as long as the program runs
  return lock;
}

Fault notRemoved(const QString& path) {
  return {faultText("edit", "The draft %1 cannot be removed."), {path.toStdString()}};
}

}  // namespace

QByteArray toBytes(const DraftFrame& frame) {
  const QJsonObject object{{QStringLiteral("mapwright_draft"), kFormat},
                           {QStringLiteral("address"), frame.of.address},
                           {QStringLiteral("map"), frame.of.map},
                           {QStringLiteral("kind"), frame.of.kind},
                           {QStringLiteral("made_ms"), double(frame.made.toMSecsSinceEpoch())},
                           {QStringLiteral("changes"), frame.changes}};
  return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

std::optional<DraftFrame> draftFrame(const QByteArray& bytes) {
  const QJsonObject frame = QJsonDocument::fromJson(bytes).object();
  const auto at = [&](const char* name) { return frame.value(QLatin1String(name)); };
  if (at("mapwright_draft").toInt() != kFormat || !at("address").isString() || !at("map").isString() ||
      !at("kind").isString() || !at("made_ms").isDouble() || !at("changes").isArray())
    return std::nullopt;
  return DraftFrame{{at("address").toString(), at("map").toString(), at("kind").toString()},
                    QDateTime::fromMSecsSinceEpoch(qint64(at("made_ms").toDouble())),
                    at("changes").toArray()};
}

QByteArray toBytes(const WaypointDraft& draft) {
  QJsonArray rows;
  for (const Change& change : draft.changes) {
    QJsonObject row{{QStringLiteral("key"), text(change.key)}};
    if (change.before) row[QStringLiteral("before")] = jsonOf(*change.before);
    if (change.after) row[QStringLiteral("after")] = jsonOf(*change.after);
    rows << row;
  }
  return toBytes(DraftFrame{draft.of, draft.made, rows});
}

std::optional<WaypointDraft> waypointDraftFrom(const QByteArray& bytes) {
  const auto frame = draftFrame(bytes);
  if (!frame) return std::nullopt;
  WaypointDraft draft{frame->of, frame->made, {}};
  for (const QJsonValue& value : frame->changes) {
    const QJsonObject row = value.toObject();
    Change change{row.value(QLatin1String("key")).toString().toStdString()};
    for (const auto& [name, into] : {std::pair{"before", &change.before}, {"after", &change.after}}) {
      const QJsonValue item = row.value(QLatin1String(name));
      if (item.isUndefined()) continue;
      *into = waypointFrom(item.toObject());
      if (!*into) return std::nullopt;
    }
    if (change.key.empty() || (!change.before && !change.after)) return std::nullopt;
    draft.changes.push_back(std::move(change));
  }
  return draft;
}

DraftFile::DraftFile(QString folder, const DraftIdentity& of)
    : folder_(std::move(folder)),
      path_(folder_ + QLatin1Char('/') + stemOf(of) + QLatin1Char('-') +
            QUuid::createUuid().toString(QUuid::Id128) + QStringLiteral(".json")) {}

std::optional<Fault> DraftFile::write(const QByteArray& bytes) {
  if (!disk::makePrivateFolder(folder_.toStdString()))
    return Fault(fault::DraftFolderNotMade, {folder_.toStdString()});
  if (!lock_) {
    auto lock = lockOf(path_);
    if (!lock->tryLock())
      return Fault(
          faultText("edit", "Drafts cannot be saved: no file can be created in %1. Is the disk full?"),
          {folder_.toStdString()});
    lock_ = std::move(lock);
  }
  const auto fault = disk::writeFile(path_.toStdString(), {bytes.constData(), std::size_t(bytes.size())});
  disk::makePrivate(path_.toStdString());
  if (!fault) {
    qCDebug(lcEdit, "draft %s: %lld bytes written", qUtf8Printable(path_), qint64(bytes.size()));
    return std::nullopt;
  }
  qCInfo(lcEdit, "draft %s: %s", qUtf8Printable(path_), inEnglish(disk::notWritten(*fault)).c_str());
  return disk::notWritten(*fault);
}

std::optional<Fault> DraftFile::remove() {
  const bool gone = !QFile::exists(path_) || QFile::remove(path_);
  lock_.reset();
  return gone ? std::nullopt : std::optional(notRemoved(path_));
}

LeftDrafts leftDrafts(const QString& folder, const DraftIdentity& of) {
  LeftDrafts left;
  const QStringList names =
      QDir(folder).entryList({stemOf(of) + QStringLiteral("-*.json")}, QDir::Files, QDir::Time);
  for (const QString& name : names) {
    LeftDraft draft{folder + QLatin1Char('/') + name, {}, lockOf(folder + QLatin1Char('/') + name)};
    // In a read-only folder nothing can be locked, but drafts there can still be restored.
    if (!draft.lock->tryLock() && draft.lock->error() == QLockFile::LockFailedError) continue;
    if (!QFile::exists(draft.path)) continue;
    auto bytes = disk::readFile(draft.path.toStdString(), kLongestDraft);
    if (!bytes) {
      left.notes.push_back({faultText("edit", "The draft %1 cannot be read"),
                            {draft.path.toStdString()},
                            {bytes.error().cause}});
      continue;
    }
    draft.bytes = QByteArray::fromStdString(*bytes);
    qCInfo(lcEdit, "draft %s: left by another run, %lld bytes", qUtf8Printable(draft.path),
           qint64(draft.bytes.size()));
    left.drafts.push_back(std::move(draft));
  }
  return left;
}

std::optional<Fault> removeDraft(LeftDraft draft) {
  if (!QFile::exists(draft.path) || QFile::remove(draft.path)) return std::nullopt;
  return notRemoved(draft.path);
}

Fault setAside(LeftDraft draft) {
  qCInfo(lcEdit, "draft %s: cannot be understood, set aside", qUtf8Printable(draft.path));
  const QString aside = draft.path + QStringLiteral(".broken");
  QFile::remove(aside);
  const std::string path = draft.path.toStdString();
  if (!QFile::rename(draft.path, aside))
    return {faultText("edit", "The draft %1 is not in a known format."), {path}};
  return {faultText("edit", "The draft %1 is not in a known format. It was renamed to %2."),
          {path, aside.toStdString()}};
}

Later byTheClock() {
  return [](std::chrono::milliseconds wait, std::function<void()> then) {
    QTimer::singleShot(wait, std::move(then));
  };
}

DraftKeeper::DraftKeeper(QString folder, const DraftIdentity& of, std::function<Job()> content, Later later,
                         std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent),
      content_(std::move(content)),
      later_(std::move(later)),
      file_(std::move(folder), of),
      share_(std::move(workers)) {}

void DraftKeeper::touch() {
  if (writing_) again_ = true;
  if (!writing_) beginAfter(kWait);
}

void DraftKeeper::beginAfter(std::chrono::milliseconds wait) {
  if (std::exchange(waiting_, true)) return;
  later_(wait, [self = QPointer<DraftKeeper>(this)] {
    if (!self || !std::exchange(self->waiting_, false)) return;
    self->begin();
  });
}

void DraftKeeper::begin() {
  writing_ = true;
  again_ = false;
  share_.startLong([this, job = content_()] {
    const std::optional<Fault> trouble = job ? file_.write(job()) : file_.remove();
    QMetaObject::invokeMethod(
        this,
        [this, trouble] {
          writing_ = false;
          setTrouble(trouble);
          Q_EMIT written();
          // What cannot be written now may work later.
          if (again_ || trouble) beginAfter(trouble ? kRetry : kWait);
        },
        Qt::QueuedConnection);
  });
}

std::optional<Fault> DraftKeeper::flush() {
  waiting_ = false;
  share_.waitForDone();
  const Job job = content_();
  const std::optional<Fault> trouble = job ? file_.write(job()) : file_.remove();
  setTrouble(trouble);
  return trouble;
}

void DraftKeeper::setTrouble(const std::optional<Fault>& trouble) {
  const bool changed = trouble_ != trouble.value_or(Fault());
  trouble_ = trouble.value_or(Fault());
  if (changed) Q_EMIT troubleChanged();
  if (trouble_.any()) return;
  // Only now are the changes of these saved elsewhere.
  for (LeftDraft& draft : std::exchange(replaced_, {})) removeDraft(std::move(draft));
}

}  // namespace mapwright::edit

#include "moc_drafts.cpp"
