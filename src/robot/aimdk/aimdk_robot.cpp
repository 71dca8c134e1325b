#include "robot/aimdk/aimdk_robot.h"

#include <utility>

namespace mapwright::robot::aimdk {

AimdkRobot::AimdkRobot(QString address, LinkOptions options, std::unique_ptr<LiveBeside> live,
                       QObject* parent)
    : AimdkRobot(std::move(address),
                 wire::startLink<AimdkLink>(QStringLiteral("aimdk link"), std::move(options)),
                 std::move(live), parent) {}

AimdkRobot::AimdkRobot(QString address, wire::StartedLink<AimdkLink> started,
                       std::unique_ptr<LiveBeside> live, QObject* parent)
    : NetworkRobot(std::move(address), started.link, std::move(started.thread), parent),
      live_(std::move(live)),
      catalogue_(started.link),
      whole_maps_(started.link),
      points_(started.link) {
  connect(started.link, &AimdkLink::currentMapChanged, this, &Robot::mapsChanged);
  if (live_) {
    connect(live_.get(), &LiveBeside::topicReceived, this, &Robot::topicReceived);
    connect(live_.get(), &LiveBeside::rawReceived, this, &Robot::rawReceived);
    connect(live_.get(), &LiveBeside::problemFound, this, &Robot::problemFound);
    connect(live_.get(), &LiveBeside::recovered, this, &Robot::recovered);
    connect(live_.get(), &LiveBeside::topicsChanged, this, &Robot::capabilitiesChanged);
    connect(live_.get(), &LiveBeside::certificateChanged, this, &Robot::connectionChanged);
    connect(live_.get(), &LiveBeside::silenceChanged, this, &Robot::connectionChanged);
  }
}

AimdkRobot::~AimdkRobot() {
  live_.reset();
  stopLink();
}

RobotIdentity AimdkRobot::identity() const {
  RobotIdentity identity;
  identity.model = QStringLiteral("Agibot (AimDK)");
  return identity;
}

QDateTime AimdkRobot::silentSince() const {
  // Where it is comes by the other server alone.
  const QDateTime since = NetworkRobot::silentSince();
  const bool by_other = live_ && connection().phase == ConnectionPhase::Online && !since.isValid();
  return by_other ? live_->silentSince() : since;
}

void AimdkRobot::connectToRobot() {
  NetworkRobot::connectToRobot();
  if (live_) live_->connectToRobot();
}

std::optional<UntrustedCertificate> AimdkRobot::certificateBeside() const {
  return live_ ? live_->connection().certificate : std::nullopt;
}

void AimdkRobot::trustBeside(const QString& sha256) {
  if (live_) live_->trustCertificate(sha256);
}

void AimdkRobot::disconnectFromRobot() {
  NetworkRobot::disconnectFromRobot();
  if (live_) live_->disconnectFromRobot();
}

void AimdkRobot::setDeliveryTap(DeliveryTap tap) {
  NetworkRobot::setDeliveryTap(tap);
  if (live_) live_->setDeliveryTap(std::move(tap));
}

Absence AimdkRobot::whyNot(Capability capability) const {
  if (capability == Capability::Administration || capability == Capability::WaypointEditing ||
      capability == Capability::PictureEditing)
    return {Absence::Reason::ReadOnly, {"Agibot"}};
  if (capability == Capability::Live) return {Absence::Reason::NoService, {"?tf=ws://HOST:9090"}};
  return {};
}

}  // namespace mapwright::robot::aimdk

#include "moc_aimdk_robot.cpp"
