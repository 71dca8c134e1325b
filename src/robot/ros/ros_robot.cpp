#include "robot/ros/ros_robot.h"

#include <utility>

#include <QPointer>

namespace mapwright::robot::ros {

RosRobot::RosRobot(QString address, LinkOptions options, QObject* parent)
    : RosRobot(std::move(address), wire::startLink<RosLink>(QStringLiteral("ros link"), options),
               std::int64_t(options.client.max_message_bytes),
               {sourcesOf(std::nullopt, options.ns), {}, false}, parent) {}

RosRobot::RosRobot(QString address, wire::StartedLink<RosLink> started, std::int64_t longest_message,
                   KnownTopics known, QObject* parent)
    : NetworkRobot(std::move(address), started.link, std::move(started.thread), parent),
      link_(started.link),
      known_(std::move(known)),
      catalogue_(link_, &RosLink::maps),
      whole_maps_(link_, &RosLink::maps),
      topics_(link_, known_),
      waypoint_store_(link_),
      waypoints_(waypoint_store_),
      picture_store_(link_),
      administration_(link_, [this] { Q_EMIT mapsChanged(); }),
      dispatch_(link_, longest_message) {
  qRegisterMetaType<KnownTopics>();
  qRegisterMetaType<Reception>();
  qRegisterMetaType<FoundDispatch>();
  qRegisterMetaType<std::shared_ptr<const ProjectedPart>>();
  listen();
}

RosRobot::~RosRobot() { stopLink(); }

void RosRobot::listen() {
  connect(&link_->kabam(), &KabamRequests::stands, this,
          [this](const QString& state) { administration_.setState(state.toStdString()); });
  connect(&link_->kabam(), &KabamRequests::mapsChanged, this, &Robot::mapsChanged);
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
  connect(&link_->dispatch(), &DispatchRequests::offersChanged, this, [this](const FoundDispatch& found) {
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
  NetworkRobot::setDeliveryTap(std::move(tap));
  QMetaObject::invokeMethod(link_, [link = link_, on] { link->setRecorded(on); });
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

}  // namespace mapwright::robot::ros

#include "moc_ros_robot.cpp"
