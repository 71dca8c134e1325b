#include "robot/recorded/recorded_robot.h"

#include <cstring>
#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "recording/source.h"
#include "robot/recorded/faults.h"

namespace mapwright::robot::recorded {
namespace {

Q_LOGGING_CATEGORY(lcRecorded, "mapwright.recorded", QtWarningMsg)

map::Failure onlyRead(map::Subject subject) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = std::move(subject),
          .asked_for = map::AskedFor::Change,
          .reason = map::FailureReason::Told,
          .cause = {faultText("recorded", "recordings on this computer are read-only here")}};
}

}  // namespace

bool hasRecordingName(const QString& path) {
  QString name = path.toLower();
  for (const char* const packed : {".zstd", ".zst"}) {
    if (name.endsWith(QLatin1String(packed))) name.chop(qsizetype(std::strlen(packed)));
  }
  return name.endsWith(QLatin1String(".mcap")) || name.endsWith(QLatin1String(".bag")) ||
         name.endsWith(QLatin1String(".db3"));
}

bool isRecording(const QString& path) {
  const QFileInfo info(path);
  if (info.isDir() || info.fileName() == QLatin1String("metadata.yaml"))
    return recording::isRosbagFolder(path.toStdString());
  if (hasRecordingName(path)) return true;
  // Opening a pipe would block.
  if (!info.isFile()) return false;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return false;
  const QByteArray start = file.read(recording::kLookedAt);
  return recording::looksLikeRecording(
      {reinterpret_cast<const std::uint8_t*>(start.constData()), std::size_t(start.size())});
}

std::string bagNameOf(const QString& path) {
  const QFileInfo info(QDir::cleanPath(path));
  // The folder is the recording.
  if (info.fileName() == QLatin1String("metadata.yaml"))
    return QFileInfo(info.absolutePath()).fileName().toStdString();
  return info.fileName().toStdString();
}

Call Library::list(OutcomeTo<std::vector<BagEntry>> reply) {
  return file_.ask(wire::kBagList, std::move(reply), &RecordedFile::bags);
}

Call Library::info(const BagKey& key, OutcomeTo<BagInfo> reply) {
  return file_.ask(subjectOf(key), std::move(reply), &RecordedFile::info, key);
}

Call Library::messages(const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply) {
  return file_.ask(subjectOf(key), std::move(reply), &RecordedFile::messages, key, range);
}

Call Library::picture(const std::string& topic, const std::string& url,
                      OutcomeTo<std::shared_ptr<const std::string>> reply) {
  return file_.ask({map::SubjectKind::Topic, topic}, std::move(reply), &RecordedFile::picture, topic, url);
}

Call Library::record(const BagOrder&, OutcomeTo<BagEntry> reply) {
  return file_.refuse(std::move(reply), onlyRead(wire::kRecordingList));
}

Call Library::remove(const BagKey& key, OutcomeTo<BagKey> reply) {
  return file_.refuse(std::move(reply), onlyRead(subjectOf(key)));
}

Call Library::download(const BagKey& key, const QString&, OutcomeTo<BagDownload> reply) {
  return file_.refuse(std::move(reply), onlyRead(subjectOf(key)));
}

void Topics::set(const RecordingFacts& facts) {
  known_ = facts.topics;
  streams_ = facts.streams;
}

QStringList Topics::topicsOf(map::Stream stream) const {
  const auto found = streams_.find(stream);
  return found == streams_.end() ? QStringList() : found->second;
}

RecordedRobot::RecordedRobot(QString address, RecordedOptions options, QObject* parent)
    : Robot(parent),
      address_(std::move(address)),
      link_log_(lcRecorded(), options.path.toStdString()),
      file_(new RecordedFile(options)),
      library_(file_),
      submaps_(file_),
      catalogue_(file_),
      whole_maps_(file_),
      waypoints_(file_) {
  qRegisterMetaType<RecordingFacts>();
  qRegisterMetaType<Fault>();
  qRegisterMetaType<map::Problem>();
  qRegisterMetaType<map::Recovery>();
  identity_.model = tr("Recording");
  identity_.name = QString::fromStdString(bagNameOf(options.path));
  file_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("recording"));
  connect(&thread_, &QThread::finished, file_, &QObject::deleteLater);
  connect(file_, &RecordedFile::problemFound, this, &Robot::problemFound);
  connect(file_, &RecordedFile::recovered, this, &Robot::recovered);
  connect(file_, &RecordedFile::opened, this, [this](const RecordingFacts& facts) {
    qCInfo(lcRecorded, "%s: %zu topics, %lld of them understood", qUtf8Printable(identity_.name),
           facts.offered.size(), (long long)(facts.topics.size()));
    facts_ = facts;
    topics_.set(facts);
    RobotIdentity identity = facts.identity;
    if (identity.model.isEmpty()) identity.model = tr("Recording");
    if (identity.name.isEmpty()) identity.name = identity_.name;
    if (std::exchange(identity_, identity) != identity) Q_EMIT identityChanged();
    Q_EMIT capabilitiesChanged();
    if (wanted_) enter(ConnectionPhase::Online);
  });
  connect(file_, &RecordedFile::refused, this, [this](const Fault& why) {
    if (wanted_) enter(ConnectionPhase::Refused, why);
  });
  thread_.start();
}

RecordedRobot::~RecordedRobot() {
  file_->disconnect(this);
  thread_.requestInterruption();
  thread_.quit();
  thread_.wait();
}

void RecordedRobot::connectToRobot() {
  wanted_ = true;
  if (state_.phase != ConnectionPhase::Online) enter(ConnectionPhase::Connecting);
  QMetaObject::invokeMethod(file_, &RecordedFile::open);
}

void RecordedRobot::disconnectFromRobot() {
  wanted_ = false;
  enter(ConnectionPhase::Offline);
}

QStringList RecordedRobot::choicesFor(map::Stream stream) const {
  const auto found = facts_.choices.find(stream);
  return found == facts_.choices.end() ? QStringList() : found->second;
}

void RecordedRobot::choose(const TopicChoices& choices) {
  chosen_ = choices;
  ros::Choices names;
  for (const auto& [stream, topic] : choices) names[stream] = topic.toStdString();
  QMetaObject::invokeMethod(file_, [file = file_, names] { file->choose(names); });
}

void RecordedRobot::enter(ConnectionPhase phase, const Fault& reason) {
  const ConnectionState state{phase, reason, 0, {}, {}};
  if (state == state_) return;
  state_ = state;
  link_log_.record(state);
  Q_EMIT connectionChanged();
}

}  // namespace mapwright::robot::recorded

#include "moc_recorded_robot.cpp"
