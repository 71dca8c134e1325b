#include "robot/ros/ros_robot.h"

#include <utility>

#include <QPointer>

namespace mapwright::robot::ros {

RosRobot::RosRobot(QString address, LinkOptions options, QObject* parent)
    : Robot(parent),
      address_(std::move(address)),
      known_{sourcesOf(std::nullopt, options.ns), {}, false},
      mailbox_(std::make_shared<wire::TopicMailbox>()),
      tap_(std::make_shared<wire::TapPlace>()),
      deliveries_(std::make_shared<wire::DeliveryPlace>()),
      link_(new RosLink(std::move(options), mailbox_, tap_, deliveries_)),
      catalogue_({this, link_}),
      whole_maps_({this, link_}),
      topics_({this, link_}, tap_, known_),
      waypoints_({this, link_}),
      waypoint_store_(link_),
      picture_store_(link_),
      administration_({this, link_}, [this] { Q_EMIT mapsChanged(); }),
      dispatch_(link_) {
  qRegisterMetaType<ConnectionState>();
  qRegisterMetaType<map::StampedMessage>();
  qRegisterMetaType<map::Problem>();
  qRegisterMetaType<map::Recovery>();
  qRegisterMetaType<RawMessage>();
  qRegisterMetaType<KnownTopics>();
  qRegisterMetaType<Reception>();
  qRegisterMetaType<FoundDispatch>();
  qRegisterMetaType<std::shared_ptr<const ProjectedPart>>();
  link_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("ros link"));
  connect(&thread_, &QThread::finished, link_, &QObject::deleteLater);
  listen();
  thread_.start();
}

RosRobot::~RosRobot() {
  link_->disconnect(this);
  link_->disconnect(&waypoint_store_);
  link_->disconnect(&picture_store_);
  link_->disconnect(&dispatch_);
  thread_.quit();
  thread_.wait();
}

void RosRobot::listen() {
  connect(link_, &RosLink::silenceChanged, this, [this](const QDateTime& since) {
    if (std::exchange(silent_since_, since) != since) Q_EMIT connectionChanged();
  });
  connect(link_, &RosLink::stateChanged, this, [this](const ConnectionState& state) {
    if (state == state_) return;
    state_ = state;
    Q_EMIT connectionChanged();
  });
  connect(link_, &RosLink::topicReceived, this, &Robot::topicReceived);
  connect(link_, &RosLink::mailArrived, this, &RosRobot::takeMail);
  connect(link_, &RosLink::rawReceived, this, &Robot::rawReceived);
  connect(link_, &RosLink::problemFound, this, &Robot::problemFound);
  connect(link_, &RosLink::recovered, this, &Robot::recovered);
  connect(link_, &RosLink::mapManagerStands, this,
          [this](const QString& state) { administration_.setState(state.toStdString()); });
  connect(link_, &RosLink::mapsChanged, this, &Robot::mapsChanged);
  connect(link_, &RosLink::topicsKnown, this, [this](const KnownTopics& known) {
    if (known == known_) return;
    known_ = known;
    Q_EMIT capabilitiesChanged();
  });
  connect(link_, &RosLink::receptionTold, this,
          [this](const Reception& reception) { reception_ = reception; });
  connect(link_, &RosLink::pictureServiceKnown, this, [this](bool there) {
    if (std::exchange(takes_pictures_, there) != there) Q_EMIT capabilitiesChanged();
  });
  connect(link_, &RosLink::dispatchKnown, this, [this](const FoundDispatch& found) {
    const QPointer<RosRobot> alive(this);
    dispatch_.setFound(found);
    // One that disappears keeps its data; its offers say that it offers nothing.
    if (alive && found.any() && !std::exchange(has_dispatch_, true)) Q_EMIT capabilitiesChanged();
  });
  connect(&dispatch_, &MapDispatch::projectedChanged, this, &Robot::mapsChanged);
  connect(link_, &RosLink::mapManagerKnown, this, [this](bool there) {
    if (std::exchange(has_manager_, there) == there) return;
    const QPointer<RosRobot> alive(this);
    Q_EMIT capabilitiesChanged();
    if (alive) Q_EMIT identityChanged();
    // The same catalogue object lists other maps now.
    if (alive) Q_EMIT mapsChanged();
  });
}

void RosRobot::setDeliveryTap(DeliveryTap tap) {
  const bool on = static_cast<bool>(tap);
  deliveries_->set(std::move(tap));
  QMetaObject::invokeMethod(link_, [link = link_, on] { link->setRecorded(on); });
  QMetaObject::invokeMethod(link_, &RosLink::defineTypes);
}

std::optional<std::vector<OfferedTopic>> RosRobot::offered() const {
  if (!known_.offered) return std::nullopt;
  std::vector<OfferedTopic> topics;
  for (const FoundTopic& topic : *known_.offered)
    topics.push_back({QString::fromStdString(topic.name), QString::fromStdString(topic.type)});
  return topics;
}

QStringList RosRobot::choicesFor(map::Stream stream) const {
  QStringList names;
  if (!known_.offered || (known_.manages_maps && stream == map::Stream::WholeMap)) return names;
  for (const std::string& name : ros::choicesFor(stream, *known_.offered))
    names << QString::fromStdString(name);
  return names;
}

void RosRobot::choose(const TopicChoices& choices) {
  chosen_ = choices;
  Choices names;
  for (const auto& [stream, topic] : choices) names[stream] = topic.toStdString();
  QMetaObject::invokeMethod(link_, [link = link_, names] { link->choose(names); });
}

void RosRobot::setEveryMessage(bool on) {
  QMetaObject::invokeMethod(link_, [link = link_, on] { link->setEveryMessage(on); });
}

RobotIdentity RosRobot::identity() const {
  RobotIdentity identity;
  identity.model = has_manager_ ? QStringLiteral("ROS (KABAM)") : QStringLiteral("ROS");
  return identity;
}

void RosRobot::connectToRobot() { QMetaObject::invokeMethod(link_, &RosLink::open); }

void RosRobot::disconnectFromRobot() { QMetaObject::invokeMethod(link_, &RosLink::close); }

void RosRobot::trustCertificate(const QString& sha256) {
  QMetaObject::invokeMethod(link_, [link = link_, pin = net::fingerprintFrom(sha256)] { link->trust(pin); });
}

Absence RosRobot::whyNot(Capability capability) const {
  const bool managers = capability == Capability::Waypoints || capability == Capability::WaypointEditing ||
                        capability == Capability::Administration;
  if (capability == Capability::PictureEditing && has_manager_)
    return {Absence::Reason::NoService, {"service /map_manager/update_map_image"}};
  if (managers || capability == Capability::PictureEditing)
    return {Absence::Reason::NoService, {"KABAM map manager (/map_manager)"}};
  if (capability == Capability::Dispatch)
    return {Absence::Reason::NoService, {"map dispatcher (REP 130: get_sub_map, get_point_map …)"}};
  return {};
}

void RosRobot::takeMail() {
  const QPointer<RosRobot> alive(this);
  for (const map::StampedMessage& message : mailbox_->take()) {
    if (alive) Q_EMIT topicReceived(message);
  }
}

}  // namespace mapwright::robot::ros

#include "moc_ros_robot.cpp"
