#include "robot/aimdk/aimdk_robot.h"

#include <utility>

#include <QJsonDocument>
#include <QJsonObject>
#include <QPointer>

#include "robot/aimdk/faults.h"

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

/// The live topics of another robot, without its maps.
class TopicsBeside : public LiveTopics {
 public:
  explicit TopicsBeside(LiveTopics& topics) : topics_(topics) {}
  QStringList known() const override { return topics_.known(); }
  QStringList topicsOf(map::Stream stream) const override {
    return isOfMaps(stream) ? QStringList() : topics_.topicsOf(stream);
  }
  void setWanted(const map::Streams& streams, const QStringList& topics) override {
    map::Streams some = streams;
    std::erase_if(some, [](map::Stream stream) { return isOfMaps(stream); });
    topics_.setWanted(some, topics);
  }
  void setBasics(const Basics& basics) override { topics_.setBasics(basics); }
  void setWatching(bool on) override { topics_.setWatching(on); }
  void setTap(FrameTap tap) override { topics_.setTap(std::move(tap)); }

 private:
  LiveTopics& topics_;
};

}  // namespace

std::optional<Obstacle> AimdkAdministration::obstacle(MapChange change,
                                                      const map::CatalogueEntry* map) const {
  switch (change) {
    case MapChange::Rename:
    case MapChange::Load:
    case MapChange::Delete:
      if (!map || map->key.kind != map::MapKind::Stored) return Obstacle::NotOfThisMap;
      if (change == MapChange::Rename) return std::nullopt;
      if (mapping_ == true && (change == MapChange::Load || map->is_current)) return Obstacle::WhileMapping;
      return change == MapChange::Load && map->is_current ? std::optional(Obstacle::IsLoaded) : std::nullopt;
    case MapChange::StartMapping:
      if (!mapping_) return Obstacle::NotKnownYet;
      return *mapping_ ? std::optional(Obstacle::WhileMapping) : std::nullopt;
    case MapChange::CancelMapping:
    case MapChange::Save:
      if (!mapping_) return Obstacle::NotKnownYet;
      return *mapping_ ? std::nullopt : std::optional(Obstacle::NotMapping);
    case MapChange::StopMapping:
      return Obstacle::EndsBySaving;
    default:
      return Obstacle::NotOffered;
  }
}

Call AimdkAdministration::carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) {
  return changes_.change(isOfMapping(order.change) ? wire::kMapList : map::subjectOf(order.key),
                         changes_.telling(changed_, std::move(reply)), &MapChanges::carryOut, order);
}

Call AimdkWaypointStore::read(const map::MapKey& key, OutcomeTo<StoredWaypoints> reply) {
  OutcomeTo<PixelPoints> onPoints = [this, reply = std::move(reply)](Outcome<PixelPoints> points) {
    if (!points) return reply(fail(std::move(points.error())));
    pixel_m_ = points->pixel_m;
    reply(std::move(points->stored));
  };
  return points_.ask(map::placesOf(key), std::move(onPoints), &PointChanges::read, key);
}

std::vector<WaypointRequest> AimdkWaypointStore::plan(const StoredWaypoints& now,
                                                      const std::vector<WaypointChange>& changes) const {
  std::vector<WaypointRequest> requests;
  for (const WaypointChange& change : changes) {
    if (change.before || change.after) requests.push_back({{change}, now.revision});
  }
  return requests;
}

WaypointCall AimdkWaypointStore::callOf(const map::MapKey& key, const WaypointRequest& request) const {
  if (request.changes.empty() || !request.changes.front().after) return {};
  const WaypointChange& change = request.changes.front();
  const map::Waypoint& point = *change.after;
  const auto qt = [](const std::string& text) { return QString::fromStdString(text); };
  const QJsonObject arguments{
      {QStringLiteral("map_id"), qt(key.id)},
      {QStringLiteral("point_id"), change.before ? QJsonValue(qt(change.id)) : QJsonValue(0)},
      {QStringLiteral("name"), qt(point.name)},
      {QStringLiteral("point_type"), qt(point.type)},
      {QStringLiteral("x"), point.position_m.x()},
      {QStringLiteral("y"), point.position_m.y()},
      {QStringLiteral("yaw"), point.yaw_rad.value_or(0)}};
  return {"SetNaviPoint", QJsonDocument(arguments).toJson(QJsonDocument::Compact).toStdString()};
}

Call AimdkWaypointStore::perform(const map::MapKey& key, const WaypointRequest& request,
                                 OutcomeTo<WaypointReceipt> reply) {
  return points_.change(map::placesOf(key), std::move(reply), &PointChanges::perform, key, request);
}

AimdkRobot::AimdkRobot(QString address, LinkOptions options, RobotBeside beside, QObject* parent)
    : AimdkRobot(std::move(address),
                 wire::startLink<AimdkLink>(QStringLiteral("aimdk link"), std::move(options)),
                 std::move(beside), parent) {}

AimdkRobot::AimdkRobot(QString address, wire::StartedLink<AimdkLink> started, RobotBeside beside,
                       QObject* parent)
    : NetworkRobot(std::move(address), started.link, std::move(started.thread), parent),
      beside_(std::move(beside)),
      catalogue_(started.link),
      whole_maps_(started.link),
      points_(started.link),
      administration_(started.link, [this] { Q_EMIT mapsChanged(); }),
      waypoint_store_(started.link) {
  qRegisterMetaType<NewerServices>();
  connect(started.link, &AimdkLink::currentMapChanged, this, &Robot::mapsChanged);
  connect(started.link, &AimdkLink::newerKnown, this, [this](const NewerServices& newer) {
    has_newer_ = newer.there;
    administration_.setMapping(newer.mapping);
    Q_EMIT capabilitiesChanged();
  });
  if (beside_.robot) listenBeside();
}

void AimdkRobot::listenBeside() {
  Robot* const beside = beside_.robot.get();
  live_ = std::make_unique<TopicsBeside>(*beside->liveTopics());
  connect(beside, &Robot::topicReceived, this, [this](const map::StampedMessage& message) {
    if (!isOfMaps(message.message)) Q_EMIT topicReceived(message);
  });
  connect(beside, &Robot::rawReceived, this, &Robot::rawReceived);
  connect(beside, &Robot::problemFound, this, &Robot::problemFound);
  connect(beside, &Robot::recovered, this, &Robot::recovered);
  connect(beside, &Robot::capabilitiesChanged, this, &Robot::capabilitiesChanged);
  connect(beside, &Robot::connectionChanged, this, &AimdkRobot::updateCompanion);
}

AimdkRobot::~AimdkRobot() {
  if (beside_.robot) beside_.robot->disconnect(this);
  live_.reset();
  beside_.robot.reset();
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
  const bool by_other = connection().phase == ConnectionPhase::Online && !since.isValid();
  return by_other ? silent_beside_ : since;
}

void AimdkRobot::connectToRobot() {
  NetworkRobot::connectToRobot();
  beside_wanted_ = true;
  connectBeside();
}

void AimdkRobot::connectBeside() {
  if (!beside_.robot || !beside_wanted_) return;
  trusted_beside_.isEmpty()
      ? beside_.robot->connectToRobot()
      : beside_.robot->trustCertificate(std::exchange(trusted_beside_, {}));  // connects
}

std::optional<UntrustedCertificate> AimdkRobot::certificateBeside() const {
  return beside_.robot ? beside_.robot->connection().certificate : std::nullopt;
}

void AimdkRobot::trustBeside(const QString& sha256) {
  trusted_beside_ = sha256;
  connectBeside();
}

void AimdkRobot::disconnectFromRobot() {
  NetworkRobot::disconnectFromRobot();
  beside_wanted_ = false;
  if (!beside_.robot) return;
  beside_.robot->disconnectFromRobot();
  recoverBeside();
}

void AimdkRobot::setDeliveryTap(DeliveryTap tap) {
  NetworkRobot::setDeliveryTap(tap);
  Delivers* const beside = beside_.robot ? deliversOf(*beside_.robot) : nullptr;
  if (beside) beside->setDeliveryTap(std::move(tap));
}

void AimdkRobot::updateCompanion() {
  const QPointer<AimdkRobot> alive(this);
  const ConnectionState state = beside_.robot->connection();
  const QDateTime since = robot::silentSince(*beside_.robot).value_or(QDateTime());
  const bool other_certificate = std::exchange(certificate_beside_, state.certificate) != state.certificate;
  const bool other_silence = std::exchange(silent_beside_, since) != since;
  if (other_certificate || other_silence) Q_EMIT connectionChanged();
  if (!alive) return;
  if (state.phase == ConnectionPhase::Online || !beside_wanted_) return recoverBeside();
  const bool away = state.phase == ConnectionPhase::Interrupted || state.phase == ConnectionPhase::Refused;
  // Repeated failures are not news, unless the reason changes.
  if (!away || !state.reason.any() || away_beside_ == state.reason) return;
  away_beside_ = state.reason;
  const std::string host = beside_.host.toStdString();
  Q_EMIT problemFound({map::Severity::Warning,
                       {map::SubjectKind::Robot, host},
                       {fault::PoseSourceAway, {host}, {state.reason}},
                       map::ProblemCode::Unavailable});
}

void AimdkRobot::recoverBeside() {
  if (!std::exchange(away_beside_, std::nullopt)) return;
  Q_EMIT recovered({{map::SubjectKind::Robot, beside_.host.toStdString()}, map::ProblemCode::Unavailable});
}

bool AimdkRobot::isUnconfirmed(Capability capability) const {
  return capability == Capability::Administration || capability == Capability::WaypointEditing;
}

Absence AimdkRobot::unavailableReason(Capability capability) const {
  if (capability == Capability::Administration || capability == Capability::WaypointEditing)
    return has_newer_ ? Absence{Absence::Reason::ReadOnly, {"Agibot"}}
                      : Absence{Absence::Reason::NotToldYet, {}};
  if (capability == Capability::Live) return {Absence::Reason::NoService, {"?tf=ws://HOST:9090"}};
  return {};
}

}  // namespace mapwright::robot::aimdk

#include "moc_aimdk_robot.cpp"
