#include "robot/files/file_robot.h"

#include <QFileInfo>

namespace mapwright::robot::files {

FileRobot::FileRobot(QString address, FileOptions options, QObject* parent)
    : Robot(parent),
      address_(std::move(address)),
      path_(options.path),
      folder_(!isMapFile(path_)),
      files_(new MapFiles(std::move(options))) {
  files_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("map files"));
  connect(&thread_, &QThread::finished, files_, &QObject::deleteLater);
  connect(files_, &MapFiles::looked, this, [this](bool folder, const QString& trouble) {
    if (!wanted_) return;
    if (std::exchange(folder_, folder) != folder) Q_EMIT identityChanged();
    enter(trouble.isEmpty() ? ConnectionPhase::Online : ConnectionPhase::Refused, trouble);
  });
  connect(files_, &MapFiles::changed, this, [this] {
    if (wanted_) Q_EMIT mapsChanged();
  });
  thread_.start();
}

FileRobot::~FileRobot() {
  files_->disconnect(this);
  thread_.requestInterruption();
  thread_.quit();
  thread_.wait();
}

RobotIdentity FileRobot::identity() const {
  RobotIdentity identity;
  identity.model = folder_ ? tr("Folder of maps") : tr("Map file");
  identity.name = QFileInfo(path_).fileName();
  return identity;
}

QString FileRobot::limits() const { return tr("A local map: there is no robot, so nothing moves on it."); }

void FileRobot::connectToRobot() {
  wanted_ = true;
  if (state_.phase != ConnectionPhase::Online) enter(ConnectionPhase::Connecting);
  QMetaObject::invokeMethod(files_, &MapFiles::watch);
}

void FileRobot::disconnectFromRobot() {
  wanted_ = false;
  QMetaObject::invokeMethod(files_, &MapFiles::leave);
  enter(ConnectionPhase::Offline);
}

void FileRobot::enter(ConnectionPhase phase, const QString& reason) {
  const ConnectionState state{phase, reason, 0, {}, {}};
  if (state == state_) return;
  state_ = state;
  Q_EMIT connectionChanged();
}

void FileRobot::list(AnswerTo<std::vector<map::CatalogueEntry>> reply) {
  wire::askAcross(this, files_, lists_, std::move(reply),
                  [](MapFiles& files, auto answer) { answer(files.list()); });
}

void FileRobot::describe(const map::MapKey& key, AnswerTo<map::CatalogueEntry> reply) {
  wire::askAcross(this, files_, descriptions_, std::move(reply),
                  [key](MapFiles& files, auto answer) { answer(files.describe(key)); });
}

void FileRobot::thumbnail(const map::MapKey& key, AnswerTo<std::string> reply) {
  const std::string name = key.id.empty() ? QFileInfo(path_).fileName().toStdString() : key.id.substr(0, 200);
  QMetaObject::invokeMethod(
      this,
      [reply = std::move(reply), key, name] {
        reply(tl::make_unexpected(map::Problem{map::Severity::Info, map::subjectOf(key, name),
                                               "A file has no small picture of itself.",
                                               map::ProblemCode::Unavailable}));
      },
      Qt::QueuedConnection);
}

void FileRobot::fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply) {
  wire::askAcross(this, files_, whole_maps_, std::move(reply),
                  [key](MapFiles& files, auto answer) { answer(files.fetch(key)); });
}

}  // namespace mapwright::robot::files
