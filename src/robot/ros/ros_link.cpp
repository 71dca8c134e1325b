#include "robot/ros/ros_link.h"

#include <algorithm>
#include <utility>

#include <QDateTime>

#include "robot/faults.h"
#include "robot/ros/dispatch_messages.h"
#include "robot/ros/faults.h"
#include "robot/wire/link_state.h"

namespace mapwright::robot::ros {

using net::WebSocketLink;

RosLink::RosLink(LinkOptions options, std::shared_ptr<wire::TopicMailbox> mailbox,
                 std::shared_ptr<wire::TapPlace> tap, std::shared_ptr<wire::DeliveryPlace> deliveries)
    : options_(std::move(options)),
      mailbox_(std::move(mailbox)),
      tap_(std::move(tap)),
      deliveries_(std::move(deliveries)),
      world_(options_.ns),
      sources_(sourcesOf(std::nullopt, options_.ns)) {}

RosLink::~RosLink() {
  // Late results must not reach a half-destroyed object.
  if (!client_) return;
  client_->disconnect(this);
  subscriptions_->disconnect(this);
  live_map_->disconnect(this);
  asked_map_->disconnect(this);
  dispatch_->disconnect(this);
  client_.reset();
}

void RosLink::start() {
  if (client_) return;
  clock_.start();
  net::rosbridge::ClientOptions client = options_.client;
  if (!options_.secret.isEmpty()) {
    net::rosbridge::Credentials credentials;
    credentials.secret = options_.secret;
    credentials.destination = options_.url.host();
    client.credentials = std::move(credentials);
  }
  client_ = std::make_unique<net::rosbridge::Client>(options_.url, std::move(client));
  client_->setTrust(options_.trust);
  api_ = std::make_unique<RosApi>(*client_, options_.look_patience);
  kabam_ = std::make_unique<KabamRequests>(*client_, options_.kabam, [this] { return world_.mapFrame(); });
  subscriptions_ = std::make_unique<RosSubscriptions>(*client_, *api_, options_.topics);
  live_map_ = std::make_unique<LiveMap>(options_.map_patience);
  asked_map_ = std::make_unique<AskedMap>(*client_, options_.asked_map);
  dispatch_ = std::make_unique<DispatchRequests>(*client_, options_.dispatch, options_.dispatch_patience,
                                                 [this] { return world_.mapFrame(); });
  pictures_ = std::make_unique<KabamPictures>(
      KabamPictures::Means{*client_, *kabam_, *live_map_,
                           [this] {
                             for (const Source& source : sourcesFor(map::Stream::WholeMap, sources_)) {
                               if (source.form == Form::Grid) subscriptions_->askAgain(source.topic);
                             }
                           }},
      options_.kabam);
  look_timer_ = std::make_unique<QTimer>();
  pose_timer_ = std::make_unique<QTimer>();
  overdue_timer_ = std::make_unique<QTimer>();
  picture_timer_ = std::make_unique<QTimer>();
  picture_timer_->setSingleShot(true);
  picture_timer_->setInterval(options_.picture_settles);
  look_timer_->setSingleShot(true);
  pose_timer_->setSingleShot(true);
  overdue_timer_->setInterval(options_.topics.look_every);
  wireClient();
  wireParts();
}

void RosLink::wireClient() {
  using net::rosbridge::Client;
  connect(client_.get(), &Client::changed, this, &RosLink::noteLink);
  connect(client_.get(), &Client::opened, this, &RosLink::begin);
  connect(client_.get(), &Client::received, this, &RosLink::take);
  connect(client_.get(), &Client::frameReceived, this,
          [this](std::string_view bytes, bool binary, double received_s) {
            tap_->pass({bytes, binary, received_s});
          });
  connect(client_.get(), &Client::statusReceived, this, [this](const QString& level, const QString& words) {
    const bool serious = level == QLatin1String("error") || level == QLatin1String("warning");
    if (serious) report(map::Severity::Warning, {robot::fault::ItAnswered, {words.left(300).toStdString()}});
  });
  connect(client_.get(), &Client::sharesOneConnection, this, [this](const Fault& why) {
    report(map::Severity::Info, {fault::RosOneConnection, {}, {why}});
  });
  connect(client_.get(), &Client::odd, this,
          [this] { report(map::Severity::Info, {fault::MessageNotUnderstood}); });
}

void RosLink::wireParts() {
  connect(subscriptions_.get(), &RosSubscriptions::problemFound, this, &RosLink::problemFound);
  connect(subscriptions_.get(), &RosSubscriptions::recovered, this, &RosLink::recovered);
  connect(subscriptions_.get(), &RosSubscriptions::dropped, this, [this](const std::string& topic) {
    world_.forget(topic);
    forgetTrouble(topic);
    const auto& map = live_map_->last();
    if (map && map->topic == topic) live_map_->forget();
  });
  connect(live_map_.get(), &LiveMap::wantedChanged, this, [this] {
    if (std::exchange(wish_.whole_map, live_map_->wanted()) != live_map_->wanted()) sync();
  });
  connect(asked_map_.get(), &AskedMap::came, this, &RosLink::takeAskedMap);
  connect(asked_map_.get(), &AskedMap::failed, this, [this](const std::string& service, const Fault& why) {
    note(service, map::ProblemCode::Unavailable, Fault(fault::MapServiceFailed, {service}, {why}));
  });
  connect(dispatch_.get(), &DispatchRequests::offersChanged, this, [this] {
    Q_EMIT dispatchKnown(dispatch_->found());
    sync();  // if it provides the map by region, do not request all of it
  });
  connect(dispatch_.get(), &DispatchRequests::topicsChanged, this, &RosLink::sync);
  connect(dispatch_.get(), &DispatchRequests::lookWanted, this, &RosLink::lookAnew);
  connect(dispatch_.get(), &DispatchRequests::mapChanged, this, &RosLink::dispatchedMapChanged);
  connect(dispatch_.get(), &DispatchRequests::projectedCame, this, &RosLink::projectedCame);
  connect(dispatch_.get(), &DispatchRequests::projectedGone, this, &RosLink::projectedGone);
  connect(dispatch_.get(), &DispatchRequests::extentTold, this,
          [this](const std::optional<map::GridReference>& grid) {
            std::optional<MapExtent> extent;
            if (grid) {
              const std::int64_t cells = std::int64_t(grid->width) * grid->height;
              extent = MapExtent{*grid, aboutBytesOfCells(cells), leastBytesOfCells(cells),
                                 std::int64_t(options_.client.max_message_bytes)};
            }
            Q_EMIT mapExtentTold(extent);
          });
  connect(dispatch_.get(), &DispatchRequests::projectedSilent, this, &RosLink::projectedSilent);
  connect(pictures_.get(), &KabamPictures::doubted, this, [this](const std::string& map_id) {
    pictures_doubted_.insert(map_id);
    picture_timer_->start();
  });
  connect(picture_timer_.get(), &QTimer::timeout, this, &RosLink::comparePicture);
  connect(look_timer_.get(), &QTimer::timeout, this, &RosLink::look);
  connect(pose_timer_.get(), &QTimer::timeout, this, &RosLink::tellPose);
  connect(overdue_timer_.get(), &QTimer::timeout, this, [this] {
    for (WorldResult& result : world_.overdue(wall())) tell(std::move(result));
    tellReception();
  });
}

double RosLink::wall() const {
  return options_.client.wall_s ? options_.client.wall_s()
                                : double(QDateTime::currentMSecsSinceEpoch()) / 1000;
}

bool RosLink::open_() const { return client_ && client_->link().state() == WebSocketLink::State::Open; }

void RosLink::open() {
  start();
  wanted_ = true;
  client_->open();
  if (awaits_manager_) look();
  publishState();
}

void RosLink::close() {
  wanted_ = false;
  was_known_ = false;
  found_ = {};
  if (client_) client_->close();
  noteLink();
}

void RosLink::trust(const QByteArray& pinned_sha256) {
  start();
  options_.trust.pinned_sha256 = pinned_sha256;
  client_->setTrust(options_.trust);
  open();
}

void RosLink::setWanted(const map::Streams& streams, const QStringList& topics) {
  start();
  wish_.streams = streams;
  wish_.names.clear();
  for (const QString& topic : topics) wish_.names.push_back(topic.toStdString());
  sync();
}

void RosLink::setEveryMessage(bool on) {
  start();
  wish_.every_message = on;
  sync();
}

void RosLink::setRecorded(bool on) {
  start();
  wish_.recorded = on;
  sync();
}

void RosLink::choose(const Choices& choices) {
  start();
  const Choices before = std::exchange(choices_, choices);
  if (before == choices || !known_) return;
  // Data of the former topic does not belong to this one.
  const auto other = [&](map::Stream stream) {
    const auto was = before.find(stream), is = choices.find(stream);
    return (was == before.end()) != (is == choices.end()) ||
           (was != before.end() && was->second != is->second);
  };
  if (other(map::Stream::Path)) emitTopic({}, map::PathMessage{}, wall(), {});
  if (other(map::Stream::LocalPath)) emitTopic({}, map::LocalPathMessage{}, wall(), {});
  if (other(map::Stream::Planning)) emitTopic({}, map::PlanningState{}, wall(), {});
  findSources();
  sync();
}

void RosLink::setBasics(const LiveTopics::Basics& basics) {
  start();
  wish_.basics = basics;
  sync();
}

/// Connected, perhaps again: it may be another robot now.
void RosLink::begin() {
  ++round_;
  known_ = looking_ = look_again_ = awaits_manager_ = false;
  deliveries_->forget();
  delivered_types_.clear();
  defined_types_.clear();
  defining_ = false;
  reception_ = {};
  least_late_s_.reset();
  before_ = mailbox_->replaced() + world_.gaveWay();
  world_.forgetAll();
  kabam_->book().forget();
  live_map_->forget();
  asked_map_->beginAnew();
  dispatch_->beginAnew();
  subscriptions_->beginAnew();
  overdue_timer_->start();
  look();
}

void RosLink::noteLink() {
  if (!open_() && client_) {
    ++round_;
    known_ = looking_ = look_again_ = awaits_manager_ = false;
    look_timer_->stop();
    overdue_timer_->stop();
    subscriptions_->pause();
    asked_map_->beginAnew();
    dispatch_->lose();
    while (!troubles_.empty()) forgetTrouble(troubles_.begin()->first);
    // Requests waiting for the first connection keep waiting; otherwise there is nothing to wait for.
    if (client_->link().state() != WebSocketLink::State::Connecting) {
      const auto early = early_;
      for (const EarlyPtr& one : early) endEarly(one, map::FailureKind::Unreachable);
      live_map_->endAll({.kind = map::FailureKind::Unreachable, .cause = {fault::LinkBrokeOff}});
    }
  }
  publishState();
}

void RosLink::publishState() {
  ConnectionState state;
  if (client_) state = wire::stateOf(client_->link(), wanted_);
  if (state.phase == ConnectionPhase::Online && !known_) state.phase = ConnectionPhase::Connecting;
  const std::string host =
      QStringLiteral("%1:%2").arg(options_.url.host()).arg(options_.url.port()).toStdString();
  if (state.failure == map::FailureKind::NotARobot) {
    state.reason = {fault::NoRosbridgeThere, {host}, {state.reason}};
  }
  if (awaits_manager_) {
    state.phase = ConnectionPhase::Interrupted;
    state.failure = map::FailureKind::NotARobot;
    state.reason = {fault::NoMapManagerThere, {host}};
    state.retry_in_ms = std::max(0, look_timer_->remainingTime());
  }
  Q_EMIT silenceChanged(client_ ? client_->link().silentSince().value_or(QDateTime()) : QDateTime());
  Q_EMIT stateChanged(state);
}

void RosLink::report(map::Severity severity, Fault reason) {
  const QString host = QStringLiteral("%1:%2").arg(options_.url.host()).arg(options_.url.port());
  Q_EMIT problemFound(
      {severity, map::Subject(map::SubjectKind::Robot, host.toStdString()), std::move(reason)});
}

/// Results in progress may be outdated.
void RosLink::lookAnew() {
  look_again_ = looking_;
  look();
}

void RosLink::look() {
  if (std::exchange(looking_, true)) return;
  api_->look(options_.ns, options_.dispatch, [this, round = round_](Found found) {
    if (round != round_) return;
    if (std::exchange(look_again_, false)) {
      looking_ = false;
      return look();
    }
    keepUnheard(found);
    auto manager = mapManagerIn(found, options_.ns);
    if (manager || found.services) return takeLook(std::move(found), std::move(manager));
    // Services are not listed: send it a request.
    const std::string place = has_manager_ ? kabam_->book().place() : options_.ns + "/map_manager";
    api_->probeMapManager(place, [this, round, found = std::move(found), place](std::optional<bool> there) {
      if (round == round_)
        takeLook(found, there.value_or(has_manager_) ? std::optional(place) : std::nullopt);
    });
  });
}

/// Who has told before is only slow now, and nothing is taken away because nothing was heard: not on the next
/// connection either, unless somebody says otherwise there.
void RosLink::keepUnheard(Found& found) const {
  if (!found.topics && (known_ || found.topics_silent)) {
    found.topics = found_.topics;
    found.unsent = found_.unsent;
  }
  if (!found.services && (known_ || found.services_silent))
    found.dispatch_services = found_.dispatch_services;
  if (!found.services && found.services_silent) {
    found.services = found_.services;
    found.map_services = found_.map_services;
  }
}

void RosLink::takeLook(Found found, std::optional<std::string> manager) {
  looking_ = false;
  look_timer_->start(options_.look_every);
  if (!manager && options_.kabam_only && !was_known_) return awaitManager();
  awaits_manager_ = false;
  found_ = std::move(found);
  dispatch_->take(dispatchIn(found_.dispatch_services, sentTopics(found_), options_.dispatch));
  wish_.managers_own.clear();
  if (manager) {
    kabam_->book().setPlace(*manager);
    wish_.managers_own = kabam_->book().topics();
  } else {
    kabam_->book().forget();
  }
  findSources();
  const bool takes_pictures =
      manager && (!found_.services || std::find(found_.services->begin(), found_.services->end(),
                                                *manager + "/update_map_image") != found_.services->end());
  const bool first = !std::exchange(known_, true);
  was_known_ = true;
  const bool other = std::exchange(has_manager_, manager.has_value()) != has_manager_;
  Q_EMIT pictureServiceKnown(takes_pictures);
  if (first || other) Q_EMIT mapManagerKnown(has_manager_);
  sync();
  if (!first) return;
  known_since_.start();
  publishState();
  const auto early = early_;
  for (const EarlyPtr& one : early) endEarly(one, std::nullopt);
}

/// It may be started after the server: looks for it until it is there.
void RosLink::awaitManager() {
  awaits_manager_ = true;
  const auto early = early_;
  for (const EarlyPtr& one : early) endEarly(one, map::FailureKind::Unreachable);
  publishState();
}

void RosLink::findSources() {
  sources_ = sourcesOf(found_.topics, options_.ns);
  Choices choices = choices_;
  // Editing, and requests by region, refer to the robot's current map.
  if (managesMaps()) choices.erase(map::Stream::WholeMap);
  ros::choose(sources_, choices, found_.topics);
  if (!choices.contains(map::Stream::WholeMap)) addMapServices(sources_, found_.map_services);
  std::set<std::string> patched;
  for (const Source& source : sources_) {
    if (source.form == Form::GridPatch) patched.insert(source.base);
  }
  world_.keepGrids(std::move(patched));
  Q_EMIT topicsKnown({sources_, found_.topics, managesMaps()});
}

bool RosLink::managesMaps() const { return !wish_.managers_own.empty() || dispatch_->found().any(); }

void RosLink::sync() {
  // Nothing is subscribed before the topics are known.
  if (!known_) return;
  // The map of a dispatcher may have gigabytes: fetching all of it is the user's decision.
  wish_.map_by_region = dispatch_->found().has(DispatchService::GridRegion);
  wish_.dispatchers_own = dispatch_->topics();
  wish_.dispatchers_tried = dispatch_->triedTopic();
  const auto wanted = topicsFor(wish_, sources_, found_);
  subscriptions_->ask(wanted, found_);
  const bool by_topic = std::any_of(wanted.begin(), wanted.end(), [](const auto& topic) {
    return std::any_of(topic.second.sources.begin(), topic.second.sources.end(), [](const Source& source) {
      return source.stream == map::Stream::WholeMap && source.form == Form::Grid;
    });
  });
  const bool chosen = choices_.contains(map::Stream::WholeMap) && !managesMaps();
  const bool map_wanted =
      !chosen && (wish_.whole_map || (wish_.streams.contains(map::Stream::WholeMap) && !wish_.map_by_region));
  AskedMap::Services services{found_.map_services, found_.services.has_value()};
  if (!services.known) {
    services.names = usualMapServices(options_.ns);
    if (options_.dispatch.expected)
      services.names.insert(services.names.begin(), nameBy(options_.dispatch, DispatchName::GetMap));
  }
  asked_map_->want(map_wanted, by_topic, std::move(services));
}

}  // namespace mapwright::robot::ros

#include "moc_ros_link.cpp"
