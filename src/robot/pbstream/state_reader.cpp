#include "robot/pbstream/state_reader.h"

#include <algorithm>
#include <atomic>
#include <sys/stat.h>
#include <utility>

#include <QFileInfo>
#include <QThread>

#include "pbstream/submap_texture.h"
#include "robot/pbstream/state_messages.h"
#include "robot/wire/failures.h"
#include "robot/wire/robot_link.h"

namespace mapwright::robot::pbstream {
namespace {

using mapwright::pbstream::StateFile;
using Outcome = map::SubmapAnswer::Outcome;

/// It changes whenever the file does.
std::string stampOf(const QString& path) {
  struct stat about {};
  if (::stat(path.toStdString().c_str(), &about) != 0) return "gone";
  return std::to_string(about.st_size) + " " + std::to_string(about.st_mtim.tv_sec) + "." +
         std::to_string(about.st_mtim.tv_nsec) + " " + std::to_string(about.st_ino);
}

map::SubmapAnswer answerTo(const map::SubmapKey& key, Outcome outcome, Fault reason = {}) {
  map::SubmapAnswer answer;
  answer.key = key;
  answer.outcome = outcome;
  answer.reason = std::move(reason);
  return answer;
}

/// What a file does not hold now will not come later: it is not asked for again until the file changes.
map::SubmapAnswer decoded(const StateFile& file, const map::SubmapKey& key) {
  if (key.uuid != file.uuid) return answerTo(key, Outcome::WrongUuid);
  const mapwright::pbstream::StoredSubmap* const submap = file.find(key.id);
  const geometry::Pose3* const pose = file.poseOf(key.id);
  if (!submap || !pose)
    return answerTo(key, Outcome::NotFound, faultText("pbstream", "The file does not contain this submap."));
  auto textures = mapwright::pbstream::readTextures(*file.file, *submap, *pose);
  if (!textures) return answerTo(key, Outcome::NotFound, std::move(textures.error()));
  map::SubmapAnswer answer = answerTo(key, Outcome::Ok);
  answer.version = textures->version;
  answer.slices = std::move(textures->slices);
  answer.bytes = std::size_t(submap->record.packed);
  answer.from_cache = true;  // and nothing newer will come
  return answer;
}

}  // namespace

bool hasStateFileName(const QString& path) {
  return path.endsWith(QLatin1String(".pbstream"), Qt::CaseInsensitive);
}

StateReader::StateReader(StateOptions options)
    : options_(std::move(options)), decoding_(std::make_shared<work::Workers>()) {}

StateReader::~StateReader() {
  decoding_.drop();
  decoding_.waitForDone();
}

bool StateReader::ready() {
  if (stamp_.empty()) read();
  return state_ != nullptr;
}

void StateReader::read() {
  stamp_ = stampOf(options_.path);
  auto read = mapwright::pbstream::readStateFile(
      options_.path.toStdString(), [] { return QThread::currentThread()->isInterruptionRequested(); });
  state_ = read ? std::make_shared<const State>(std::move(*read)) : nullptr;
  trouble_ = read ? std::nullopt : std::optional(read.error());
}

void StateReader::open() {
  watch();
  if (stampOf(options_.path) != stamp_) read();
  if (!state_) return Q_EMIT refused(*trouble_);
  Q_EMIT opened(messagesOf(*state_, wire::secondsOfDay()), state_->losses(),
                std::any_of(state_->submaps.begin(), state_->submaps.end(),
                            [](const auto& one) { return one.three_d; }));
}

void StateReader::leave() {
  settle_.reset();
  watcher_.reset();
}

void StateReader::watch() {
  if (!watcher_) {
    watcher_ = std::make_unique<QFileSystemWatcher>();
    settle_ = std::make_unique<QTimer>();
    settle_->setSingleShot(true);
    settle_->setInterval(options_.settle);
    connect(settle_.get(), &QTimer::timeout, this, &StateReader::compare);
    // The watcher loses files that are replaced by renaming; watching their folder helps.
    connect(watcher_.get(), &QFileSystemWatcher::fileChanged, this, [this] { settle_->start(); });
    connect(watcher_.get(), &QFileSystemWatcher::directoryChanged, this, [this] { settle_->start(); });
  }
  for (const QString& path : {options_.path, QFileInfo(options_.path).absolutePath()}) {
    if (QFileInfo::exists(path) && !watcher_->files().contains(path) &&
        !watcher_->directories().contains(path))
      watcher_->addPath(path);
  }
}

void StateReader::compare() {
  if (stampOf(options_.path) != stamp_) open();
}

void StateReader::submap(const wire::TaskPtr& task, const map::SubmapKey& key,
                         OutcomeTo<map::SubmapAnswer> reply) {
  if (!ready()) return reply(answerTo(key, Outcome::NotFound, *trouble_));
  const auto unwanted = std::make_shared<std::atomic_bool>(false);
  task->begun([unwanted] { *unwanted = true; });
  decoding_.start(work::Urgency::Wanted, [this, file = state_, key, unwanted, reply = std::move(reply)] {
    auto answer = std::make_shared<map::SubmapAnswer>(*unwanted ? answerTo(key, Outcome::Cancelled)
                                                                : decoded(*file, key));
    QMetaObject::invokeMethod(
        this, [answer, reply] { reply(std::move(*answer)); }, Qt::QueuedConnection);
  });
}

robot::Outcome<std::shared_ptr<const map::PoseGraph>> StateReader::graph() {
  if (!ready())
    return fail(wire::unfit({map::SubjectKind::Map, {}, QFileInfo(options_.path).fileName().toStdString()},
                            *trouble_));
  return state_->graph;
}

}  // namespace mapwright::robot::pbstream

#include "moc_state_reader.cpp"
