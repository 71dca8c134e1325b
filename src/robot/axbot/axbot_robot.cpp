#include "robot/axbot/axbot_robot.h"

#include <tuple>
#include <utility>

#include <QPointer>

namespace mapwright::robot::axbot {

AxbotRobot::AxbotRobot(QString address, LinkOptions options, QObject* parent)
    : Robot(parent),
      address_(std::move(address)),
      mailbox_(std::make_shared<wire::TopicMailbox>()),
      tap_(std::make_shared<wire::TapPlace>()),
      deliveries_(std::make_shared<wire::DeliveryPlace>()),
      link_(new AxbotLink(std::move(options), mailbox_, tap_, deliveries_)),
      submaps_({this, link_}),
      catalogue_({this, link_}),
      whole_maps_({this, link_}),
      overview_({this, link_}),
      topics_({this, link_}, tap_),
      administration_({this, link_}, [this] { Q_EMIT mapsChanged(); }),
      bags_({this, link_}) {
  qRegisterMetaType<ConnectionState>();
  qRegisterMetaType<RobotIdentity>();
  qRegisterMetaType<map::StampedMessage>();
  qRegisterMetaType<map::Problem>();
  qRegisterMetaType<map::Recovery>();
  qRegisterMetaType<map::SubmapAnswer>();
  qRegisterMetaType<RawMessage>();
  link_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("axbot link"));
  connect(&thread_, &QThread::finished, link_, &QObject::deleteLater);
  connect(link_, &AxbotLink::silenceChanged, this, [this](const QDateTime& since) {
    if (std::exchange(silent_since_, since) != since) Q_EMIT connectionChanged();
  });
  connect(link_, &AxbotLink::stateChanged, this, [this](const ConnectionState& state) {
    if (state == state_) return;
    const bool again = state.phase == ConnectionPhase::Online && state_.phase != ConnectionPhase::Online;
    state_ = state;
    const QPointer<AxbotRobot> alive(this);
    Q_EMIT connectionChanged();
    // After a reconnect the robot may have other firmware.
    if (alive && again && std::exchange(overview_unknown_, std::nullopt)) Q_EMIT capabilitiesChanged();
  });
  connect(link_, &AxbotLink::identityChanged, this, [this](const RobotIdentity& identity) {
    if (identity == identity_) return;
    identity_ = identity;
    Q_EMIT identityChanged();
  });
  connect(link_, &AxbotLink::topicReceived, this, &AxbotRobot::takeTopic);
  connect(link_, &AxbotLink::mailArrived, this, &AxbotRobot::takeMail);
  connect(link_, &AxbotLink::rawReceived, this, &Robot::rawReceived);
  connect(link_, &AxbotLink::problemFound, this, &Robot::problemFound);
  connect(link_, &AxbotLink::recovered, this, &Robot::recovered);
  connect(link_, &AxbotLink::overviewUnknown, this, [this](const QString& answer) {
    if (std::exchange(overview_unknown_, answer) != answer) Q_EMIT capabilitiesChanged();
  });
  thread_.start();
}

AxbotRobot::~AxbotRobot() {
  link_->disconnect(this);
  thread_.quit();
  thread_.wait();
}

void AxbotRobot::connectToRobot() { QMetaObject::invokeMethod(link_, &AxbotLink::open); }

void AxbotRobot::trustCertificate(const QString& sha256) {
  QMetaObject::invokeMethod(link_, [link = link_, pin = net::fingerprintFrom(sha256)] { link->trust(pin); });
}

void AxbotRobot::disconnectFromRobot() { QMetaObject::invokeMethod(link_, &AxbotLink::close); }

Absence AxbotRobot::whyNot(Capability capability) const {
  if (capability == Capability::Overview && overview_unknown_)
    return {Absence::Reason::FirmwareLacks, {overview_unknown_->toStdString()}};
  if (capability == Capability::WaypointEditing) return {Absence::Reason::NotYetHere, {}};
  return {};
}

void AxbotRobot::takeTopic(const map::StampedMessage& stamped) {
  bool other_map = false;
  if (const auto* info = std::get_if<map::MapInfo>(&stamped.message)) {
    const map::MapInfo known{info->name, info->uid, info->map_version, info->overlays_version, {}};
    other_map =
        last_map_info_ && std::tie(last_map_info_->name, last_map_info_->uid, last_map_info_->map_version,
                                   last_map_info_->overlays_version) !=
                              std::tie(known.name, known.uid, known.map_version, known.overlays_version);
    last_map_info_ = known;
  }
  const QPointer<AxbotRobot> alive(this);
  Q_EMIT topicReceived(stamped);
  if (alive && other_map) Q_EMIT mapsChanged();
}

void AxbotRobot::takeMail() {
  const QPointer<AxbotRobot> alive(this);
  for (const map::StampedMessage& message : mailbox_->take()) {
    if (alive) Q_EMIT topicReceived(message);
  }
}

}  // namespace mapwright::robot::axbot

#include "moc_axbot_robot.cpp"
