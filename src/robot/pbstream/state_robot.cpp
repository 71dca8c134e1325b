#include "robot/pbstream/state_robot.h"

#include <algorithm>
#include <utility>

#include <QFileInfo>

#include "robot/pbstream/state_messages.h"
#include "robot/submap_list_topic.h"

namespace mapwright::robot::pbstream {
namespace {

Q_LOGGING_CATEGORY(lcStateFile, "mapwright.files", QtWarningMsg)

constexpr std::size_t kMostNamed = 20;

map::Problem problemOf(Fault loss) {
  return {map::Severity::Warning, map::SubjectKind::SubmapList, std::move(loss), map::ProblemCode::Odd};
}

/// Problems of one pattern replace each other: those of one kind are one problem that names them.
std::vector<map::Problem> problemsOf(const std::vector<Fault>& losses) {
  std::vector<std::pair<std::string, std::vector<Fault>>> kinds;
  for (const Fault& loss : losses) {
    const std::string pattern = map::patternOf(problemOf(loss));
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.first == pattern; });
    if (kind == kinds.end()) {
      kinds.push_back({pattern, {loss}});
    } else {
      kind->second.push_back(loss);
    }
  }
  std::vector<map::Problem> problems;
  for (auto& [pattern, alike] : kinds) {
    const auto count = std::int64_t(alike.size());
    if (count == 1) {
      problems.push_back(problemOf(std::move(alike.front())));
      continue;
    }
    alike.resize(std::min(alike.size(), kMostNamed));
    problems.push_back(
        problemOf({std::size_t(count) > kMostNamed ? faultText("pbstream", "%1 losses, the first of them")
                                                   : faultText("pbstream", "%1 losses"),
                   {count},
                   std::move(alike)}));
  }
  return problems;
}

std::string fileName(const StateOptions& options) { return QFileInfo(options.path).fileName().toStdString(); }

}  // namespace

QStringList StateTopics::known() const {
  return {QLatin1String(kSubmapListTopic), QLatin1String(kTrajectoryTopic), QLatin1String(kConstraintsTopic),
          QLatin1String(kLandmarksTopic)};
}

QStringList StateTopics::topicsOf(map::Stream stream) const {
  switch (stream) {
    case map::Stream::Trajectory:
      return {QLatin1String(kTrajectoryTopic)};
    case map::Stream::Constraints:
      return {QLatin1String(kConstraintsTopic)};
    case map::Stream::Landmarks:
      return {QLatin1String(kLandmarksTopic)};
    default:
      return {};
  }
}

StateRobot::StateRobot(QString address, StateOptions options, QObject* parent)
    : Robot(parent),
      address_(std::move(address)),
      path_(options.path),
      link_log_(lcStateFile(), options.path.toStdString()),
      reader_(new StateReader(options)),
      submaps_(reader_),
      graph_(reader_, {map::SubjectKind::Map, {}, fileName(options)}) {
  qRegisterMetaType<std::vector<map::StampedMessage>>();
  qRegisterMetaType<Fault>();
  qRegisterMetaType<std::vector<Fault>>();
  identity_.model = tr("Cartographer state file");
  identity_.name = QString::fromStdString(fileName(options));
  reader_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("state file"));
  connect(&thread_, &QThread::finished, reader_, &QObject::deleteLater);
  connect(reader_, &StateReader::opened, this,
          [this](const std::vector<map::StampedMessage>& messages, const std::vector<Fault>& losses,
                 bool three_d) {
            if (!wanted_) return;
            const QString model =
                three_d ? tr("Cartographer state file (3D)") : tr("Cartographer state file");
            if (std::exchange(identity_.model, model) != model) Q_EMIT identityChanged();
            const bool again = state_.phase == ConnectionPhase::Online;
            enter(ConnectionPhase::Online);
            for (const map::StampedMessage& message : messages) {
              if (wanted_) Q_EMIT topicReceived(message);
            }
            // After the list, which says nothing of these.
            if (wanted_) Q_EMIT recovered({map::SubjectKind::SubmapList, map::ProblemCode::Odd});
            for (const map::Problem& problem : problemsOf(losses)) {
              if (wanted_) Q_EMIT problemFound(problem);
            }
            if (again && wanted_) Q_EMIT mapsChanged();
          });
  connect(reader_, &StateReader::refused, this, [this](const Fault& why) {
    if (wanted_) enter(ConnectionPhase::Refused, why);
  });
  thread_.start();
}

StateRobot::~StateRobot() {
  reader_->disconnect(this);
  thread_.requestInterruption();
  thread_.quit();
  thread_.wait();
}

void StateRobot::connectToRobot() {
  wanted_ = true;
  if (state_.phase != ConnectionPhase::Online) enter(ConnectionPhase::Connecting);
  QMetaObject::invokeMethod(reader_, &StateReader::open);
}

void StateRobot::disconnectFromRobot() {
  wanted_ = false;
  QMetaObject::invokeMethod(reader_, &StateReader::leave);
  enter(ConnectionPhase::Offline);
}

void StateRobot::enter(ConnectionPhase phase, const Fault& reason) {
  const ConnectionState state{phase, reason, 0, {}, {}};
  if (state == state_) return;
  state_ = state;
  link_log_.record(state);
  Q_EMIT connectionChanged();
}

}  // namespace mapwright::robot::pbstream

#include "moc_state_robot.cpp"
