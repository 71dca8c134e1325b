#include "robot/axbot/axbot_robot.h"

#include <utility>

#include <QPointer>

#include "robot/axbot/parse_topics.h"

namespace mapwright::robot::axbot {

std::optional<Obstacle> Administration::obstacle(MapChange change, const map::CatalogueEntry* map) const {
  switch (change) {
    case MapChange::Rename:
    case MapChange::Load:
    case MapChange::Delete:
      if (!map || map->key.kind != map::MapKind::Stored) return Obstacle::NotOfThisMap;
      if (change != MapChange::Load) return std::nullopt;
      if (mapping_ == true) return Obstacle::WhileMapping;
      return map->is_current ? std::optional(Obstacle::IsLoaded) : std::nullopt;
    case MapChange::StartMapping:
    case MapChange::ContinueMapping:
    case MapChange::Save:
      return mapping_ == true ? std::optional(Obstacle::WhileMapping) : std::nullopt;
    case MapChange::StopMapping:
    case MapChange::CancelMapping:
      return mapping_ == false ? std::optional(Obstacle::NotMapping) : std::nullopt;
    default:
      return Obstacle::NotOffered;
  }
}

Call Administration::carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) {
  // What it answers is newer than the last message about its state.
  OutcomeTo<map::CatalogueEntry> noted = [this, change = order.change,
                                          reply = std::move(reply)](Outcome<map::CatalogueEntry> now) {
    const bool starts = change == MapChange::StartMapping || change == MapChange::ContinueMapping;
    const bool ends = change == MapChange::StopMapping || change == MapChange::CancelMapping;
    if (now && (starts || ends)) mapping_ = starts;
    reply(std::move(now));
  };
  return changes_.change(order.key.id.empty() ? wire::kMapList : map::subjectOf(order.key),
                         changes_.telling(changed_, std::move(noted)), &MapChanges::carryOut, order);
}

Call Administration::progress(OutcomeTo<std::optional<MappingProgress>> reply) {
  return changes_.ask({map::SubjectKind::Catalogue, map::kMappingsPart}, std::move(reply),
                      &MapChanges::progress);
}

AxbotRobot::AxbotRobot(QString address, LinkOptions options, QObject* parent)
    : AxbotRobot(std::move(address),
                 wire::startLink<AxbotLink>(QStringLiteral("axbot link"), std::move(options)), parent) {}

AxbotRobot::AxbotRobot(QString address, wire::StartedLink<AxbotLink> started, QObject* parent)
    : NetworkRobot(std::move(address), started.link, std::move(started.thread), parent),
      submaps_(started.link),
      catalogue_(started.link, &AxbotLink::maps),
      whole_maps_(started.link),
      overview_(started.link),
      topics_(started.link),
      administration_(started.link, [this] { Q_EMIT mapsChanged(); }),
      bags_(started.link, &AxbotLink::bags),
      overlays_(started.link, [this] { Q_EMIT mapsChanged(); }),
      pose_setting_(started.link),
      transfer_(started.link, [this] { Q_EMIT mapsChanged(); }) {
  qRegisterMetaType<RobotIdentity>();
  connect(started.link, &AxbotLink::identityChanged, this, [this](const RobotIdentity& identity) {
    if (identity == identity_) return;
    identity_ = identity;
    Q_EMIT identityChanged();
  });
  connect(started.link, &AxbotLink::overviewUnknown, this, [this](const QString& answer) {
    if (std::exchange(overview_unknown_, answer) != answer) Q_EMIT capabilitiesChanged();
  });
}

AxbotRobot::~AxbotRobot() { stopLink(); }

/// Whoever is connected again may have got another firmware meanwhile.
void AxbotRobot::cameOnline() {
  if (std::exchange(overview_unknown_, std::nullopt)) Q_EMIT capabilitiesChanged();
}

Absence AxbotRobot::unavailableReason(Capability capability) const {
  if (capability == Capability::Overview && overview_unknown_)
    return {Absence::Reason::FirmwareLacks, {overview_unknown_->toStdString()}};
  if (capability == Capability::WaypointEditing) return {Absence::Reason::NotYetHere, {}};
  return {};
}

void AxbotRobot::onTopic(const map::StampedMessage& stamped) {
  bool other_map = false;
  if (const auto* info = std::get_if<map::MapInfo>(&stamped.message)) {
    const map::MapInfo known{info->name, info->uid, info->map_version, info->overlays_version, {}, {}};
    other_map = last_map_info_ && *last_map_info_ != known;
    last_map_info_ = known;
  }
  bool other_state = false;
  if (const auto* slam = std::get_if<map::SlamStatus>(&stamped.message))
    other_state = administration_.onMapping(slam->state == "slam");
  const QPointer<AxbotRobot> alive(this);
  Q_EMIT topicReceived(stamped);
  if (alive && other_state) Q_EMIT capabilitiesChanged();
  if (alive && other_map) Q_EMIT mapsChanged();
}

std::optional<std::string> AxbotRobot::jsonOf(const Delivery& message) const {
  return message.encoding == "protobuf" ? jsonOfBinaryBody(message.bytes) : std::nullopt;
}

}  // namespace mapwright::robot::axbot

#include "moc_axbot_robot.cpp"
