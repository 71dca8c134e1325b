#include "robot/aimdk/live_beside.h"

#include <utility>

#include "robot/aimdk/faults.h"
#include "robot/robot.h"

namespace mapwright::robot::aimdk {
namespace {

/// Streams of the robot's maps: the interface provides these, and the two may disagree.
bool isOfMaps(map::Stream stream) {
  using map::Stream;
  return stream == Stream::WholeMap || stream == Stream::Incremental || stream == Stream::MapInfo ||
         stream == Stream::EnvMatch || stream == Stream::EnvSymmetry;
}

bool isOfMaps(const map::TopicMessage& message) {
  if (std::holds_alternative<map::MapInfo>(message) || std::holds_alternative<map::SubmapList>(message))
    return true;
  const auto* const grid = std::get_if<map::GridMessage>(&message);
  return grid && grid->kind != map::GridKind::CostmapLow && grid->kind != map::GridKind::CostmapHigh;
}

}  // namespace

LiveBeside::LiveBeside(std::unique_ptr<Robot> source, QString host)
    : source_(std::move(source)), subject_(map::SubjectKind::Robot, host.toStdString()) {
  connect(source_.get(), &Robot::topicReceived, this, [this](const map::StampedMessage& message) {
    if (!isOfMaps(message.message)) Q_EMIT topicReceived(message);
  });
  connect(source_.get(), &Robot::rawReceived, this, &LiveBeside::rawReceived);
  connect(source_.get(), &Robot::problemFound, this, &LiveBeside::problemFound);
  connect(source_.get(), &Robot::recovered, this, &LiveBeside::recovered);
  connect(source_.get(), &Robot::capabilitiesChanged, this, &LiveBeside::topicsChanged);
  connect(source_.get(), &Robot::connectionChanged, this, &LiveBeside::noteLink);
}

void LiveBeside::connectToRobot() {
  wanted_ = true;
  trusted_.isEmpty() ? source_->connectToRobot()
                     : source_->trustCertificate(std::exchange(trusted_, {}));  // connects
}

void LiveBeside::trustCertificate(const QString& sha256) {
  trusted_ = sha256;
  if (wanted_) connectToRobot();
}

void LiveBeside::disconnectFromRobot() {
  wanted_ = false;
  source_->disconnectFromRobot();
  tellOff();
}

QStringList LiveBeside::topicsOf(map::Stream stream) const {
  return isOfMaps(stream) ? QStringList() : topics().topicsOf(stream);
}

void LiveBeside::setWanted(const map::Streams& streams, const QStringList& topics) {
  map::Streams some = streams;
  std::erase_if(some, [](map::Stream stream) { return isOfMaps(stream); });
  this->topics().setWanted(some, topics);
}

void LiveBeside::setDeliveryTap(DeliveryTap tap) {
  if (Delivers* const source = deliversOf(*source_)) source->setDeliveryTap(std::move(tap));
}

void LiveBeside::noteLink() {
  const ConnectionState state = source_->connection();
  if (std::exchange(certificate_, state.certificate) != state.certificate) Q_EMIT certificateChanged();
  const QDateTime since = robot::silentSince(*source_).value_or(QDateTime());
  if (std::exchange(silent_since_, since) != since) Q_EMIT silenceChanged();
  if (state.phase == ConnectionPhase::Online || !wanted_) return tellOff();
  const bool away = state.phase == ConnectionPhase::Interrupted || state.phase == ConnectionPhase::Refused;
  // Repeated failures are not news, unless the reason changes.
  if (!away || !state.reason.any() || told_ == state.reason) return;
  told_ = state.reason;
  map::Problem problem;
  problem.severity = map::Severity::Warning;
  problem.subject = subject_;
  problem.reason = {fault::PoseSourceAway, {subject_.id}, {state.reason}};
  problem.code = map::ProblemCode::Unavailable;
  Q_EMIT problemFound(problem);
}

void LiveBeside::tellOff() {
  if (!std::exchange(told_, std::nullopt)) return;
  Q_EMIT recovered({subject_, map::ProblemCode::Unavailable});
}

}  // namespace mapwright::robot::aimdk

#include "moc_live_beside.cpp"
