#include "robot/files/file_robot.h"

#include <QFileInfo>
#include <QSet>

namespace mapwright::robot::files {
namespace {

constexpr qsizetype kMostWatched = 1'000;  // a folder of more is watched as a folder only

QString stamp(const QString& path) { return QString::fromStdString(stampOf(path)); }

}  // namespace

FileRobot::FileRobot(QString address, FileOptions options, QObject* parent)
    : Robot(parent), address_(std::move(address)), options_(std::move(options)) {
  settle_.setSingleShot(true);
  settle_.setInterval(options_.settle);
  connect(&settle_, &QTimer::timeout, this, &FileRobot::tellChange);
  // Files that are replaced by renaming are lost to the watcher; their folder tells.
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, [this] { settle_.start(); });
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, [this] { settle_.start(); });
}

bool FileRobot::isFolder() const { return QFileInfo(options_.path).isDir(); }

RobotIdentity FileRobot::identity() const {
  RobotIdentity identity;
  identity.model = isFolder() ? tr("Folder of maps") : tr("Map file");
  identity.name = QFileInfo(options_.path).fileName();
  return identity;
}

QString FileRobot::limits() const { return tr("A local map: there is no robot, so nothing moves on it."); }

void FileRobot::connectToRobot() {
  stamps_ = watchAndStamp();
  look();
}

void FileRobot::disconnectFromRobot() {
  settle_.stop();
  const QStringList watched = watcher_.files() + watcher_.directories();
  if (!watched.isEmpty()) watcher_.removePaths(watched);
  enter(ConnectionPhase::Offline);
}

void FileRobot::enter(ConnectionPhase phase, const QString& reason) {
  const ConnectionState state{phase, reason, 0, {}, {}};
  if (state == state_) return;
  state_ = state;
  Q_EMIT connectionChanged();
}

void FileRobot::look() {
  if (isFolder()) {
    const bool any = !mapFilesIn(options_.path).isEmpty();
    enter(any ? ConnectionPhase::Online : ConnectionPhase::Refused,
          any ? QString() : tr("There are no maps (map.yaml, PNG, PGM, BMP) in %1.").arg(options_.path));
    return;
  }
  const auto whole = readLocalMap(options_.path, options_.place);
  enter(whole ? ConnectionPhase::Online : ConnectionPhase::Refused,
        whole ? QString() : QString::fromStdString(whole.error()));
}

QStringList FileRobot::watchAndStamp() {
  QStringList files, folders;
  const PictureYamls beside(isFolder() ? options_.path : QFileInfo(options_.path).absolutePath());
  const auto add = [&](const QString& path) {
    files << path;
    folders << QFileInfo(path).absolutePath();
    // A picture alone lies where the map.yaml beside it says.
    if (!isFolder()) files << beside.naming(path);
    const auto whole = readLocalMap(path, options_.place, &beside);
    if (whole && whole->path != path.toStdString()) {
      files << QString::fromStdString(whole->path);
      folders << QFileInfo(files.last()).absolutePath();
    }
  };
  if (isFolder()) {
    folders << options_.path;
    for (const QString& name : mapFilesIn(options_.path).mid(0, kMostWatched)) {
      add(options_.path + QLatin1Char('/') + name);
    }
  } else {
    add(options_.path);
  }
  QStringList stamps;
  QSet<QString> wanted;
  for (const QString& file : files) {
    stamps << stamp(file);
    if (QFileInfo::exists(file)) wanted << file;
  }
  for (const QString& folder : folders) {
    if (QFileInfo(folder).isDir()) wanted << folder;
  }
  const QStringList now = watcher_.files() + watcher_.directories();
  const QSet<QString> watched(now.begin(), now.end());
  const QSet<QString> missing = wanted - watched, done = watched - wanted;
  if (!missing.isEmpty()) watcher_.addPaths(QStringList(missing.begin(), missing.end()));
  if (!done.isEmpty()) watcher_.removePaths(QStringList(done.begin(), done.end()));
  return stamps;
}

void FileRobot::tellChange() {
  const QStringList stamps = watchAndStamp();
  if (stamps == stamps_) return;
  stamps_ = stamps;
  look();
  Q_EMIT mapsChanged();
}

QString FileRobot::pathOf(const map::MapKey& key) const {
  if (key.kind != map::MapKind::File) return {};
  const QString id = QString::fromStdString(key.id);
  if (!isFolder())
    return id.isEmpty() || id == QFileInfo(options_.path).fileName() ? options_.path : QString();
  // Only what the list holds: an id is no way out of the folder.
  return mapFilesIn(options_.path).contains(id) ? options_.path + QLatin1Char('/') + id : QString();
}

map::Problem FileRobot::problem(const map::MapKey& key, std::string sentence, map::Severity severity) const {
  const std::string name =
      key.id.empty() ? QFileInfo(options_.path).fileName().toStdString() : key.id.substr(0, 200);
  return {severity, map::subjectOf(key, name), std::move(sentence), map::ProblemCode::Unavailable};
}

template <typename T>
void FileRobot::later(AnswerTo<T> reply, Answer<T> answer) {
  QMetaObject::invokeMethod(
      this, [reply = std::move(reply), answer = std::move(answer)] { reply(answer); }, Qt::QueuedConnection);
}

void FileRobot::list(AnswerTo<std::vector<map::CatalogueEntry>> reply) {
  std::vector<map::CatalogueEntry> entries;
  if (isFolder()) {
    const PictureYamls beside(options_.path);
    for (const QString& name : mapFilesIn(options_.path)) {
      entries.push_back(entryOf({map::MapKind::File, name.toStdString()},
                                options_.path + QLatin1Char('/') + name, options_.place, &beside));
      entries.back().index = int(entries.size()) - 1;
    }
  } else if (QFileInfo::exists(options_.path)) {
    entries.push_back(entryOf({map::MapKind::File, {}}, options_.path, options_.place));
    entries.back().is_current = true;
  }
  later<std::vector<map::CatalogueEntry>>(std::move(reply), std::move(entries));
}

void FileRobot::describe(const map::MapKey& key, AnswerTo<map::CatalogueEntry> reply) {
  const QString path = pathOf(key);
  if (path.isEmpty()) {
    later<map::CatalogueEntry>(
        std::move(reply), tl::make_unexpected(problem(key, "There is no such map.", map::Severity::Error)));
    return;
  }
  later<map::CatalogueEntry>(std::move(reply), entryOf(key, path, options_.place));
}

void FileRobot::thumbnail(const map::MapKey& key, AnswerTo<std::string> reply) {
  later<std::string>(
      std::move(reply),
      tl::make_unexpected(problem(key, "A file has no small picture of itself.", map::Severity::Info)));
}

void FileRobot::fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply) {
  const QString path = pathOf(key);
  if (path.isEmpty()) {
    later<map::WholeMap>(std::move(reply),
                         tl::make_unexpected(problem(key, "There is no such map.", map::Severity::Error)));
    return;
  }
  auto whole = readLocalMap(path, options_.place);
  if (!whole) {
    later<map::WholeMap>(std::move(reply),
                         tl::make_unexpected(problem(key, whole.error(), map::Severity::Error)));
    return;
  }
  whole->key = key;
  later<map::WholeMap>(std::move(reply), std::move(*whole));
}

}  // namespace mapwright::robot::files
