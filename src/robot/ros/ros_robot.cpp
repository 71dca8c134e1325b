#include "robot/ros/ros_robot.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include <QPointer>

#include "robot/ros/dispatch_messages.h"
#include "robot/ros/faults.h"
#include "robot/ros/kabam_messages.h"
#include "robot/ros/kabam_pictures.h"
#include "robot/ros/kabam_plan.h"
#include "robot/wire/forwarded.h"

namespace mapwright::robot::ros {
namespace {

/// A request of the dispatcher, once it is known what the robot can do.
template <typename Request>
auto whenKnown(map::AskedFor asked_for, Request request) {
  // `rest`: its arguments, and the reply.
  return [asked_for, request](RosLink& link, const wire::TaskPtr& task, const auto&... rest) {
    link.whenKnown(task, map::Subject(std::string(kDispatcher)), asked_for,
                   [&link, task, request, rest...](std::optional<map::Failure> failure) {
                     const auto& reply = std::get<sizeof...(rest) - 1>(std::tie(rest...));
                     if (failure) return reply(fail(std::move(*failure)));
                     std::invoke(request, link.dispatch(), task, rest...);
                   });
  };
}

}  // namespace

QStringList Topics::known() const {
  QStringList names;
  for (const Endpoint& topic : known_.offered.value_or(std::vector<Endpoint>()))
    names << QString::fromStdString(topic.name);
  if (!names.isEmpty()) return names;
  for (const Source& source : known_.sources) names << QString::fromStdString(source.topic);
  names.removeDuplicates();
  return names;
}

QStringList Topics::topicsOf(map::Stream stream) const {
  QStringList names;
  for (const Source& source : sourcesFor(stream, known_.sources)) {
    // Patches are reported under the name of their grid.
    if (source.form != Form::GridPatch) names << QString::fromStdString(source.topic);
  }
  names.removeDuplicates();
  return names;
}

KabamWaypointStore::KabamWaypointStore(RosLink* link) : kabam_(link, &RosLink::kabam) {
  connect(&link->kabam(), &KabamRequests::waypointsChanged, this, &WaypointStore::changed);
  connect(&link->kabam(), &KabamRequests::named, this, &WaypointStore::named);
}

Call KabamWaypointStore::read(const map::MapKey& key, OutcomeTo<StoredWaypoints> reply) {
  return kabam_.ask(map::placesOf(key), std::move(reply), &KabamRequests::waypoints, key);
}

std::vector<WaypointRequest> KabamWaypointStore::plan(const StoredWaypoints& now,
                                                      const std::vector<WaypointChange>& changes) const {
  return planWaypoints(now, changes);
}

WaypointCall KabamWaypointStore::callOf(const map::MapKey& key, const WaypointRequest& request) const {
  if (request.changes.empty()) return {};
  const WaypointChange& change = request.changes.front();
  const WaypointService service = serviceOf(change);
  const bool creates = service == WaypointService::Create, deletes = service == WaypointService::Delete;
  const QByteArray message =
      waypointJson(deletes ? *change.before : *change.after, creates ? std::string() : change.id, key.id, {});
  return {nameOf(service), manageWaypointArgs(message, deletes).toStdString()};
}

Call KabamWaypointStore::perform(const map::MapKey& key, const WaypointRequest& request,
                                 OutcomeTo<WaypointReceipt> reply) {
  return kabam_.change(map::placesOf(key), std::move(reply), &KabamRequests::perform, key, request);
}

std::optional<Obstacle> KabamAdministration::obstacle(MapChange change,
                                                      const map::CatalogueEntry* map) const {
  const bool mapping = state_ == "MAPPING";
  if (change == MapChange::ContinueMapping || change == MapChange::CancelMapping) return Obstacle::NotOffered;
  if (change == MapChange::StartMapping || change == MapChange::StopMapping || change == MapChange::Save) {
    if (state_.empty()) return Obstacle::NotKnownYet;
    if (change == MapChange::StartMapping && mapping) return Obstacle::WhileMapping;
    if (change == MapChange::StopMapping && !mapping) return Obstacle::NotMapping;
    // It works with a map. Without one there may be a mapping from before that is not saved.
    if (change == MapChange::Save && !mapped_ && state_ == "ACTIVE") return Obstacle::NothingToSave;
    return std::nullopt;
  }
  if (!map || map->key.kind != map::MapKind::Stored) return Obstacle::NotOfThisMap;
  switch (change) {
    case MapChange::Load:
      if (mapping) return Obstacle::WhileMapping;
      if (map->is_archived) return Obstacle::IsArchived;
      return map->is_current ? std::optional(Obstacle::IsLoaded) : std::nullopt;
    case MapChange::Archive:
      if (mapping && map->is_current) return Obstacle::WhileMapping;
      return map->is_archived ? std::optional(Obstacle::IsArchived) : std::nullopt;
    case MapChange::Unarchive:
      return map->is_archived ? std::nullopt : std::optional(Obstacle::IsNotArchived);
    case MapChange::Delete:
      return mapping && map->is_current ? std::optional(Obstacle::WhileMapping) : std::nullopt;
    default:
      return std::nullopt;
  }
}

Call KabamAdministration::carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) {
  if (obstacle(order.change, nullptr) == Obstacle::NotOffered)
    return kabam_.refuse(std::move(reply), wire::notOffered(wire::kMapList, map::AskedFor::Change));
  // What was mapped is stored, or left for another map.
  if (order.change == MapChange::Save || order.change == MapChange::Load)
    reply = [this, reply = std::move(reply)](Outcome<map::CatalogueEntry> outcome) {
      if (outcome) mapped_ = false;
      reply(std::move(outcome));
    };
  return kabam_.change(order.key.id.empty() ? wire::kMapList : map::subjectOf(order.key),
                       kabam_.telling(changed_, std::move(reply)), &KabamRequests::carryOut, order);
}

KabamPictureStore::KabamPictureStore(RosLink* link) : pictures_(link, &RosLink::pictures) {
  connect(&link->pictures(), &KabamPictures::changed, this, [this](const QString& map_id) {
    Q_EMIT changed({map::MapKind::Stored, map_id.toStdString()});
  });
}

std::optional<PictureObstacle> KabamPictureStore::obstacle(const map::WholeMap& map) const {
  if (map.key.kind != map::MapKind::Stored) return PictureObstacle::NotStored;
  return std::nullopt;
}

bool KabamPictureStore::holdsCell(const map::WholeMap&, std::uint8_t cell) const {
  return shadeOf(cell).has_value();
}

Call KabamPictureStore::write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) {
  return pictures_.change(map::subjectOf(change.map), std::move(reply), &KabamPictures::write, change);
}

RosDispatch::RosDispatch(RosLink* link, std::int64_t longest_message) : link_(link) {
  const DispatchRequests* const requests = &link->dispatch();
  connect(requests, &DispatchRequests::mapChanged, this, &MapDispatch::mapChanged);
  connect(requests, &DispatchRequests::projectedChanged, this,
          [this](int index, const std::shared_ptr<const ProjectedPart>& part) {
            const bool known = projected_.erase(index) > 0;
            if (part) projected_[index] = part;
            if (known || part) Q_EMIT projectedChanged(index);
          });
  connect(requests, &DispatchRequests::extentTold, this,
          [this, longest_message](const std::optional<map::GridReference>& grid) {
            std::optional<MapExtent> extent;
            if (grid) {
              const std::int64_t cells = std::int64_t(grid->width) * grid->height;
              extent = MapExtent{*grid, aboutBytesOfCells(cells), leastBytesOfCells(cells), longest_message};
            }
            if (std::exchange(extent_, extent) != extent) Q_EMIT extentChanged();
          });
  connect(requests, &DispatchRequests::projectedSilent, this, [this](const QStringList& topics) {
    silent_.clear();
    for (const QString& topic : topics) silent_.push_back(topic.toStdString());
  });
}

void RosDispatch::setDispatcher(const Dispatcher& dispatcher) {
  const bool other = dispatcher.offers() != dispatcher_.offers();
  dispatcher_ = dispatcher;
  if (other) Q_EMIT offersChanged();
}

map::Subject RosDispatch::subjectOf(DispatchService service) const {
  const auto there = dispatcher_.serviceOf(service);
  return map::Subject(there ? there->name : std::string(kDispatcher));
}

/// Meaningless requests are not sent (docs/protocols/rep130-map-dispatcher.md, "Maps in space").
map::Failure RosDispatch::refused(DispatchService service, map::AskedFor asked_for, FaultCode why) const {
  return {.kind = map::FailureKind::Refused,
          .subject = subjectOf(service),
          .asked_for = asked_for,
          .reason = map::FailureReason::Unfit,
          .cause = why};
}

Call RosDispatch::grid(const std::optional<map::GridRegion>& region, OutcomeTo<map::GridPart> reply) {
  const auto service = region ? DispatchService::GridRegion : DispatchService::Grid;
  if (region && !isSound(*region))
    return link_.refuse(std::move(reply), refused(service, map::AskedFor::All, fault::RegionMeansNothing));
  return link_.ask(subjectOf(service), std::move(reply),
                   whenKnown(map::AskedFor::All, &DispatchRequests::grid), region);
}

Call RosDispatch::cloud(CloudKind kind, const std::optional<map::CloudRegion>& region,
                        OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply) {
  const auto service = cloudService(kind, region.has_value());
  if (region && !isSound(*region))
    return link_.refuse(std::move(reply), refused(service, map::AskedFor::All, fault::RegionMeansNothing));
  return link_.ask(subjectOf(service), std::move(reply),
                   whenKnown(map::AskedFor::All, &DispatchRequests::cloud), kind, region);
}

Call RosDispatch::save(const std::string& filename, OutcomeTo<std::string> reply) {
  const bool control = std::any_of(filename.begin(), filename.end(),
                                   [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  if (filename.empty() || filename.size() > 4096 || control) {
    return link_.refuse(std::move(reply),
                        refused(DispatchService::Save, map::AskedFor::Change, fault::FileNameMeansNothing));
  }
  return link_.change(subjectOf(DispatchService::Save), std::move(reply),
                      whenKnown(map::AskedFor::Change, &DispatchRequests::save), filename);
}

Call RosDispatch::projections(OutcomeTo<std::vector<map::Projection>> reply) {
  return link_.ask(subjectOf(DispatchService::ReadProjections), std::move(reply),
                   whenKnown(map::AskedFor::All, &DispatchRequests::projections));
}

Call RosDispatch::project(const std::vector<map::Projection>& wanted,
                          OutcomeTo<std::vector<map::Projection>> reply) {
  const bool sound =
      wanted.size() <= kMostProjections &&
      std::all_of(wanted.begin(), wanted.end(), [](const map::Projection& one) { return isSound(one); });
  if (!sound) {
    return link_.refuse(std::move(reply), refused(DispatchService::ChangeProjections, map::AskedFor::Change,
                                                  fault::ProjectionMeansNothing));
  }
  return link_.change(subjectOf(DispatchService::ChangeProjections), std::move(reply),
                      whenKnown(map::AskedFor::Change, &DispatchRequests::project), wanted);
}

std::vector<ProjectedPart> RosDispatch::projected() const {
  std::vector<ProjectedPart> all;
  for (const auto& [index, part] : projected_) all.push_back(*part);
  return all;
}

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
  qRegisterMetaType<std::map<QString, int>>();
  qRegisterMetaType<Dispatcher>();
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
  connect(link_, &RosLink::unplacedMarkersTold, this,
          [this](const std::map<QString, int>& by_topic) { unplaced_markers_ = by_topic; });
  connect(link_, &RosLink::pictureServiceKnown, this, [this](bool there) {
    if (std::exchange(takes_pictures_, there) != there) Q_EMIT capabilitiesChanged();
  });
  connect(&link_->dispatch(), &DispatchRequests::offersChanged, this, [this](const Dispatcher& dispatcher) {
    const QPointer<RosRobot> alive(this);
    dispatch_.setDispatcher(dispatcher);
    // One that disappears keeps its data; its offers say that it offers nothing.
    if (alive && dispatcher.any() && !std::exchange(has_dispatch_, true)) Q_EMIT capabilitiesChanged();
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
  for (const Endpoint& topic : *known_.offered)
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

Absence RosRobot::unavailableReason(Capability capability) const {
  const bool managers = capability == Capability::Waypoints || capability == Capability::WaypointEditing ||
                        capability == Capability::Administration;
  if (capability == Capability::PictureEditing && has_manager_)
    return {Absence::Reason::NoService,
            {QT_TRANSLATE_NOOP("Absence", "service /map_manager/update_map_image")}};
  if (managers || capability == Capability::PictureEditing)
    return {Absence::Reason::NoService, {QT_TRANSLATE_NOOP("Absence", "KABAM map manager (/map_manager)")}};
  if (capability == Capability::Dispatch)
    return {Absence::Reason::NoService,
            {QT_TRANSLATE_NOOP("Absence", "map dispatcher (REP 130: get_sub_map, get_point_map …)")}};
  return {};
}

}  // namespace mapwright::robot::ros

#include "moc_ros_robot.cpp"
