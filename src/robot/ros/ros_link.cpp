#include "robot/ros/ros_link.h"

#include <algorithm>
#include <utility>

#include <QDateTime>

#include "net/plain_sentences.h"
#include "robot/faults.h"
#include "robot/ros/faults.h"
#include "robot/ros/log.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::ros {

using net::WebSocketLink;

Q_LOGGING_CATEGORY(lcRos, "mapwright.ros", QtWarningMsg)

RosLink::RosLink(LinkOptions options)
    : RobotLink(lcRos(), options.url),
      options_(std::move(options)),
      world_(options_.ns),
      sources_(sourcesOf(std::nullopt, options_.ns)),
      client_(std::make_unique<net::rosbridge::Client>(options_.url, clientOptions())),
      api_(*client_, options_.look_patience),
      subscriptions_(*client_, api_, options_.topics),
      deliveries_(places_->deliveries, api_, found_, sources_, [this] { return wall(); }),
      live_map_(options_.map_patience),
      asked_map_(*client_, options_.asked_map),
      dispatch_(*client_, options_.dispatch, options_.dispatch_patience,
                [this] { return world_.mapFrame(); }),
      kabam_(*client_, options_.kabam, std::bind_front(&RosLink::whenKnown, this),
             [this] { return world_.mapFrame(); }),
      pictures_({*client_, kabam_, live_map_,
                 [this] {
                   for (const Source& source : sourcesFor(map::Stream::WholeMap, sources_)) {
                     if (source.form == Form::Grid) subscriptions_.askAgain(source.topic);
                   }
                 },
                 [this] { return known_; }},
                options_.kabam, options_.picture_settles),
      maps_({kabam_, dispatch_, live_map_, world_, sources_, std::bind_front(&RosLink::whenKnown, this)}) {
  clock_.start();
  client_->setTrust(options_.trust);
  look_timer_.setSingleShot(true);
  pose_timer_.setSingleShot(true);
  overdue_timer_.setInterval(options_.topics.look_every);
  listen();
}

RosLink::~RosLink() {
  // What is under way must not reach a half-destroyed object.
  client_->disconnect(this);
  subscriptions_.disconnect(this);
  live_map_.disconnect(this);
  asked_map_.disconnect(this);
  dispatch_.disconnect(this);
  client_.reset();
}

net::rosbridge::ClientOptions RosLink::clientOptions() const {
  net::rosbridge::ClientOptions client = options_.client;
  if (!options_.secret.isEmpty()) {
    net::rosbridge::Credentials credentials;
    credentials.secret = options_.secret;
    credentials.destination = options_.url.host();
    client.credentials = std::move(credentials);
  }
  return client;
}

void RosLink::listen() {
  using net::rosbridge::Client;
  connect(client_.get(), &Client::changed, this, &RosLink::noteLink);
  connect(client_.get(), &Client::opened, this, &RosLink::begin);
  connect(client_.get(), &Client::received, this, &RosLink::take);
  connect(client_.get(), &Client::frameReceived, this,
          [this](std::string_view bytes, bool binary, double received_s) {
            places_->tap.pass({bytes, binary, received_s});
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
  connect(&subscriptions_, &RosSubscriptions::problemFound, this, &RosLink::problemFound);
  connect(&subscriptions_, &RosSubscriptions::recovered, this, &RosLink::recovered);
  connect(&subscriptions_, &RosSubscriptions::dropped, this, [this](const std::string& topic) {
    world_.forget(topic);
    forgetTrouble(topic);
    const auto& map = live_map_.last();
    if (map && map->topic == topic) live_map_.forget();
  });
  connect(&live_map_, &LiveMap::wantedChanged, this, [this] {
    if (std::exchange(wish_.whole_map, live_map_.wanted()) != live_map_.wanted()) sync();
  });
  connect(&asked_map_, &AskedMap::came, this, &RosLink::takeAskedMap);
  connect(&asked_map_, &AskedMap::failed, this, [this](const std::string& service, const Fault& why) {
    note(service, map::ProblemCode::Unavailable, Fault(fault::MapServiceFailed, {service}, {why}));
  });
  // Whoever gives the map by region is not asked for all of it.
  connect(&dispatch_, &DispatchRequests::offersChanged, this, &RosLink::sync);
  connect(&dispatch_, &DispatchRequests::topicsChanged, this, &RosLink::sync);
  connect(&dispatch_, &DispatchRequests::lookWanted, this, &RosLink::lookAnew);
  connect(&look_timer_, &QTimer::timeout, this, &RosLink::look);
  connect(&pose_timer_, &QTimer::timeout, this, &RosLink::tellPose);
  connect(&overdue_timer_, &QTimer::timeout, this, [this] {
    for (WorldResult& result : world_.overdue(wall())) tell(std::move(result));
    tellReception();
  });
}

double RosLink::wall() const {
  return options_.client.wall_s ? options_.client.wall_s() : wire::secondsOfDay();
}

void RosLink::open() {
  wanted_ = true;
  client_->open();
  if (awaits_manager_) look();
  publishState();
}

void RosLink::close() {
  wanted_ = false;
  was_known_ = false;
  found_ = {};
  client_->close();
  noteLink();
}

void RosLink::trust(const QByteArray& pinned_sha256) {
  options_.trust.pinned_sha256 = pinned_sha256;
  client_->setTrust(options_.trust);
  open();
}

void RosLink::setWanted(const map::Streams& streams, const QStringList& topics) {
  wish_.streams = streams;
  wish_.names.clear();
  for (const QString& topic : topics) wish_.names.push_back(topic.toStdString());
  sync();
}

void RosLink::setEveryMessage(bool on) {
  wish_.every_message = on;
  sync();
}

void RosLink::setRecorded(bool on) {
  wish_.recorded = on;
  sync();
  deliveries_.define();
}

void RosLink::choose(const Choices& choices) {
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
  wish_.basics = basics;
  sync();
}

/// Connected, perhaps again: it may be another robot now.
void RosLink::begin() {
  ++round_;
  known_ = looking_ = look_again_ = awaits_manager_ = false;
  deliveries_.beginAnew();
  reception_ = {};
  least_late_s_.reset();
  before_ = places_->mailbox.replaced() + world_.gaveWay();
  world_.forgetAll();
  kabam_.book().forget();
  live_map_.forget();
  asked_map_.beginAnew();
  dispatch_.beginAnew();
  subscriptions_.beginAnew();
  overdue_timer_.start();
  look();
}

void RosLink::noteLink() {
  if (!isOpen()) {
    ++round_;
    known_ = looking_ = look_again_ = awaits_manager_ = false;
    look_timer_.stop();
    overdue_timer_.stop();
    deliveries_.pause();
    subscriptions_.pause();
    asked_map_.beginAnew();
    dispatch_.lose();
    while (!troubles_.empty()) forgetTrouble(troubles_.begin()->first);
    // Requests waiting for the first connection keep waiting; otherwise there is nothing to wait for.
    if (client_->link().state() != WebSocketLink::State::Connecting) {
      early_.drop();
      live_map_.lose();
    }
  }
  publishState();
}

void RosLink::publishState() {
  ConnectionState state = wire::stateOf(client_->link(), wanted_);
  if (state.phase == ConnectionPhase::Online && !known_) state.phase = ConnectionPhase::Connecting;
  const std::string host = wire::hostOf(options_.url);
  if (state.failure == map::FailureKind::NotARobot) {
    state.reason = {fault::NoRosbridgeThere, {host}, {state.reason}};
  }
  if (awaits_manager_) {
    state.phase = ConnectionPhase::Interrupted;
    state.failure = map::FailureKind::NotARobot;
    state.reason = {fault::NoMapManagerThere, {host}};
    state.retry_in_ms = std::max(0, look_timer_.remainingTime());
  }
  link_log_.note(state);
  Q_EMIT silenceChanged(client_->link().silentSince().value_or(QDateTime()));
  Q_EMIT stateChanged(state);
}

/// What is being told now may be of before.
void RosLink::lookAnew() {
  look_again_ = looking_;
  look();
}

void RosLink::look() {
  if (std::exchange(looking_, true)) return;
  api_.look(options_.ns, options_.dispatch, [this, round = round_](Found found) {
    if (round != round_) return;
    if (std::exchange(look_again_, false)) {
      looking_ = false;
      return look();
    }
    keepUnheard(found);
    auto manager = mapManagerIn(found, options_.ns);
    if (manager || found.services) return takeLook(std::move(found), std::move(manager));
    // Nobody tells: it is asked something.
    const std::string place = kabam_.there() ? kabam_.book().place() : options_.ns + "/map_manager";
    api_.probeMapManager(place, [this, round, found = std::move(found), place](std::optional<bool> there) {
      if (round == round_)
        takeLook(found, there.value_or(kabam_.there()) ? std::optional(place) : std::nullopt);
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
  look_timer_.start(options_.look_every);
  if (!(found == found_) || !known_) {
    const auto count = [](const auto& list) { return list ? std::to_string(list->size()) : "unknown"; };
    qCInfo(lcRos, "topics: %s, services: %s, map manager: %s", count(found.topics).c_str(),
           count(found.services).c_str(), manager ? manager->c_str() : "none");
  }
  if (!manager && options_.kabam_only && !was_known_) return awaitManager();
  awaits_manager_ = false;
  found_ = std::move(found);
  dispatch_.take(dispatchIn(found_.dispatch_services, sentTopics(found_), options_.dispatch));
  const bool other = kabam_.setPlace(manager);
  wish_.managers_own = manager ? kabam_.book().topics() : std::vector<std::string>();
  findSources();
  const bool takes_pictures =
      manager && (!found_.services || std::find(found_.services->begin(), found_.services->end(),
                                                *manager + "/update_map_image") != found_.services->end());
  const bool first = !std::exchange(known_, true);
  was_known_ = true;
  Q_EMIT pictureServiceKnown(takes_pictures);
  if (first || other) Q_EMIT mapManagerKnown(kabam_.there());
  sync();
  if (!first) return;
  known_since_.start();
  publishState();
  early_.look();
}

/// It may be started after the server: looks for it until it is there.
void RosLink::awaitManager() {
  awaits_manager_ = true;
  early_.drop();
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

void RosLink::whenKnown(const wire::TaskPtr& task, const map::Subject& subject, map::AskedFor asked_for,
                        std::function<void(std::optional<map::Failure>)> then) {
  using End = wire::WaitList::End;
  const auto ended = [subject, asked_for, then = std::move(then)](End how) {
    if (how == End::Held) return then(std::nullopt);
    map::Failure failure{.kind = map::FailureKind::Cancelled, .subject = subject, .asked_for = asked_for};
    if (how == End::Dropped) {
      failure.kind = map::FailureKind::Unreachable;
      failure.cause = {fault::NotConnected};
    }
    then(std::move(failure));
  };
  const bool connecting = client_->link().state() == WebSocketLink::State::Connecting;
  const bool coming = !awaits_manager_ && (isOpen() || connecting);
  if (!known_ && !coming) return ended(End::Dropped);
  early_.await(
      task, std::nullopt, [this] { return known_; }, ended);
}

bool RosLink::managesMaps() const { return !wish_.managers_own.empty() || dispatch_.found().any(); }

void RosLink::sync() {
  // Nothing is subscribed before the topics are known.
  if (!known_) return;
  // The map of a dispatcher that gives it by region may be gigabytes: about the whole people decide.
  wish_.map_by_region = dispatch_.found().has(DispatchService::GridRegion);
  wish_.dispatchers_own = dispatch_.topics();
  wish_.dispatchers_tried = dispatch_.triedTopic();
  const auto wanted = topicsFor(wish_, sources_, found_);
  subscriptions_.ask(wanted, found_);
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
  asked_map_.want(map_wanted, by_topic, std::move(services));
}

}  // namespace mapwright::robot::ros

#include "moc_ros_link.cpp"
