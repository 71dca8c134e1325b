#include "robot/recorded/recorded_robot.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QFile>
#include <QFileInfo>

#include "recording/mcap_reader.h"
#include "recording/ros1_bag.h"
#include "robot/recorded/faults.h"

namespace mapwright::robot::recorded {
namespace {

map::Failure onlyRead(map::Subject subject) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = std::move(subject),
          .asked_for = map::AskedFor::Change,
          .reason = map::FailureReason::Told,
          .cause = {fault::RecordingOnlyRead}};
}

}  // namespace

bool isRecording(const QString& path) {
  const QFileInfo info(path);
  const QString suffix = info.suffix().toLower();
  if (suffix == QLatin1String("mcap") || suffix == QLatin1String("bag")) return !info.isDir();
  // Opening a pipe would block.
  if (!info.isFile()) return false;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return false;
  const QByteArray start = file.read(16);
  const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(start.constData()),
                                            std::size_t(start.size()));
  return recording::looksLikeMcap(bytes) || recording::looksLikeBag(bytes);
}

std::string bagNameOf(const QString& path) { return QFileInfo(path).fileName().toStdString(); }

Call Library::list(OutcomeTo<std::vector<BagEntry>> reply) {
  return wire::askAcross(line_.asker, line_.file, lists_,
                         map::Subject(map::SubjectKind::Catalogue, map::kBagsPart), std::move(reply),
                         [](RecordedFile& file, const auto&, auto answer) { answer(file.list()); });
}

Call Library::info(const BagKey& key, OutcomeTo<BagInfo> reply) {
  return wire::askAcross(line_.asker, line_.file, infos_, subjectOf(key), std::move(reply),
                         [key](RecordedFile& file, const auto&, auto answer) { answer(file.info(key)); });
}

Call Library::messages(const BagKey& key, const BagRange& range, OutcomeTo<BagChunkPtr> reply) {
  return wire::askAcross(line_.asker, line_.file, chunks_, subjectOf(key), std::move(reply),
                         [key, range](RecordedFile& file, const auto& errand, auto answer) {
                           file.messages(errand, key, range, std::move(answer));
                         });
}

Call Library::picture(const std::string& topic, const std::string& url,
                      OutcomeTo<std::shared_ptr<const std::string>> reply) {
  return wire::askAcross(
      line_.asker, line_.file, pictures_, map::Subject(map::SubjectKind::Topic, topic), std::move(reply),
      [topic, url](RecordedFile& file, const auto&, auto answer) { answer(file.picture(topic, url)); });
}

Call Library::record(const BagOrder&, OutcomeTo<BagEntry> reply) {
  return wire::endLater<BagEntry>(
      line_.asker, recordings_, std::move(reply),
      tl::make_unexpected(onlyRead({map::SubjectKind::Catalogue, map::kRecordingsPart})));
}

Call Library::remove(const BagKey& key, OutcomeTo<BagKey> reply) {
  return wire::endLater<BagKey>(line_.asker, removals_, std::move(reply),
                                tl::make_unexpected(onlyRead(subjectOf(key))));
}

Call Library::download(const BagKey& key, const QString&, OutcomeTo<BagDownload> reply) {
  return wire::endLater<BagDownload>(line_.asker, downloads_, std::move(reply),
                                     tl::make_unexpected(onlyRead(subjectOf(key))));
}

Call Submaps::fetch(const map::SubmapKey& key, Reply reply) {
  forgetOver();
  Call call = wire::askAcross(
      line_.asker, line_.file, answers_, map::subjectOf(key.id),
      OutcomeTo<map::SubmapAnswer>([key, reply = std::move(reply)](Outcome<map::SubmapAnswer> outcome) {
        if (outcome) return reply(std::move(*outcome));
        map::SubmapAnswer cancelled;
        cancelled.key = key;
        cancelled.outcome = map::SubmapAnswer::Outcome::Cancelled;
        reply(std::move(cancelled));
      }),
      [key](RecordedFile& file, const auto&, auto answer) { answer(file.submap(key)); });
  calls_.emplace_back(key, call);
  return call;
}

void Submaps::forgetOver() {
  std::erase_if(calls_, [](const auto& one) { return one.second.over(); });
}

void Submaps::cancelAll() {
  for (const auto& [key, call] : std::exchange(calls_, {})) call.cancel();
}

void Submaps::cancel(const map::SubmapKey& key) {
  for (const auto& [of, call] : calls_) {
    if (of == key) call.cancel();
  }
}

Call Catalogue::list(OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  return wire::askAcross(line_.asker, line_.file, lists_,
                         map::Subject(map::SubjectKind::Catalogue, map::kMapsPart), std::move(reply),
                         [](RecordedFile& file, const auto&, auto answer) { answer(file.maps()); });
}

Call Catalogue::describe(const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  return wire::askAcross(line_.asker, line_.file, descriptions_, map::subjectOf(key), std::move(reply),
                         [key](RecordedFile& file, const auto&, auto answer) {
                           const auto maps = file.maps();
                           if (!maps) return answer(tl::make_unexpected(maps.error()));
                           for (const map::CatalogueEntry& entry : *maps) {
                             if (entry.key == key) return answer(entry);
                           }
                           answer(tl::make_unexpected(map::Failure{.kind = map::FailureKind::RejectedByRobot,
                                                                   .subject = map::subjectOf(key),
                                                                   .reason = map::FailureReason::NotThere}));
                         });
}

Call Catalogue::thumbnail(const map::MapKey& key, OutcomeTo<std::string> reply) {
  return wire::endLater<std::string>(
      line_.asker, thumbnails_, std::move(reply),
      tl::make_unexpected(map::Failure{.kind = map::FailureKind::Unsupported,
                                       .subject = map::subjectOf(key),
                                       .asked_for = map::AskedFor::SmallPicture,
                                       .reason = map::FailureReason::NotOffered}));
}

Call WholeMaps::fetch(const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
  return wire::askAcross(line_.asker, line_.file, maps_, map::subjectOf(key), std::move(reply),
                         [key](RecordedFile& file, const auto&, auto answer) { answer(file.wholeMap(key)); });
}

Call Waypoints::waypoints(const map::MapKey& key, OutcomeTo<map::WaypointList> reply) {
  return wire::askAcross(
      line_.asker, line_.file, lists_, map::placesOf(key), std::move(reply),
      [key](RecordedFile& file, const auto&, auto answer) { answer(file.waypoints(key)); });
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
      file_(new RecordedFile(options)),
      library_({this, file_}),
      submaps_({this, file_}),
      catalogue_({this, file_}),
      whole_maps_({this, file_}),
      waypoints_({this, file_}) {
  qRegisterMetaType<RecordingFacts>();
  qRegisterMetaType<Fault>();
  qRegisterMetaType<map::Problem>();
  qRegisterMetaType<map::Recovery>();
  identity_.model = tr("Recording");
  identity_.name = QFileInfo(options.path).fileName();
  file_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("recording"));
  connect(&thread_, &QThread::finished, file_, &QObject::deleteLater);
  connect(file_, &RecordedFile::problemFound, this, &Robot::problemFound);
  connect(file_, &RecordedFile::recovered, this, &Robot::recovered);
  connect(file_, &RecordedFile::opened, this, [this](const RecordingFacts& facts) {
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
  Q_EMIT connectionChanged();
}

}  // namespace mapwright::robot::recorded

#include "moc_recorded_robot.cpp"
