#include "robot/ros/ros_link.h"

#include <algorithm>
#include <utility>

#include <QDateTime>

#include "net/plain_sentences.h"
#include "robot/faults.h"
#include "robot/ros/faults.h"
#include "robot/wire/net_results.h"
#include "words/qt_versions.h"
#include "words/shortened.h"

namespace mapwright::robot::ros {
namespace {

Q_LOGGING_CATEGORY(lcRos, "mapwright.ros", QtWarningMsg)

using net::WebSocketLink;
using net::rosbridge::TopicMessage;

constexpr std::chrono::milliseconds kPoseEvery{50};  // told at most so often
constexpr qint64 kPoseAnywayMs = 1'000;              // a robot that stands still is told of, too
constexpr qint64 kFramesMs = 2'000;                  // for the frames of map and robot to be known
constexpr qint64 kPoseMissingMs = 2'000;             // before it is told that it has none

constexpr qint64 kTellAgainMs = 5'000;
constexpr qint64 kReceptionEveryMs = 1'000;
constexpr double kLateS = 1;
constexpr qint64 kShownWhole = 64 * 1024;  // longer messages are shortened for the inspector

map::Subject topicSubject(const std::string& topic) { return {map::SubjectKind::Topic, topic}; }

RawMessage rawOf(const TopicMessage& message) {
  RawMessage raw;
  raw.topic = QString::fromStdString(message.topic);
  raw.received = words::utcOfMs(qint64(message.received_s * 1000));
  raw.bytes = message.bytes;
  raw.binary = message.binary;
  raw.text = message.bytes <= kShownWhole ? message.msg.toWholeJson() : message.msg.toJson(kMaxRawText);
  return raw;
}

}  // namespace

RosLink::RosLink(LinkOptions options)
    : RobotLink(lcRos(), options.url, options.secret),
      options_(std::move(options)),
      world_(options_.ns),
      sources_(sourcesOf(std::nullopt, options_.ns)),
      client_(std::make_unique<net::rosbridge::Client>(options_.url, clientOptions())),
      api_(*client_, options_.look_timeout),
      subscriptions_(*client_, api_, options_.topics),
      deliveries_(outputs_->deliveries, api_, graph_, sources_, [this] { return wall(); }),
      live_map_(options_.map_timeout),
      map_service_(*client_, options_.map_service),
      dispatch_(*client_, options_.dispatch, options_.dispatch_timeouts,
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
  // What is in progress must not reach a half-destroyed object.
  client_->disconnect(this);
  subscriptions_.disconnect(this);
  live_map_.disconnect(this);
  map_service_.disconnect(this);
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
  connect(client_.get(), &Client::changed, this, &RosLink::onLink);
  connect(client_.get(), &Client::opened, this, &RosLink::begin);
  connect(client_.get(), &Client::received, this, &RosLink::onReceived);
  connect(client_.get(), &Client::frameReceived, this,
          [this](std::string_view bytes, bool binary, double received_s) {
            outputs_->tap.pass({bytes, binary, received_s});
          });
  connect(client_.get(), &Client::statusReceived, this, [this](const QString& level, const QString& words) {
    const bool serious = level == QLatin1String("error") || level == QLatin1String("warning");
    if (serious)
      report(map::Severity::Warning,
             {robot::fault::ItAnswered, {words::shortened(words, 300).toStdString()}});
  });
  connect(client_.get(), &Client::sharesOneConnection, this, [this](const Fault& why) {
    report(map::Severity::Info,
           {faultText("ros",
                      "The rosbridge server does not accept a second connection: %1. Maps and clouds "
                      "share the connection with poses, so poses may be late while a map is sent."),
            {},
            {why}});
  });
  connect(client_.get(), &Client::odd, this,
          [this] { report(map::Severity::Info, {fault::MessageNotUnderstood}); });
  connect(&subscriptions_, &RosSubscriptions::problemFound, this, &RosLink::problemFound);
  connect(&subscriptions_, &RosSubscriptions::recovered, this, &RosLink::recovered);
  connect(&subscriptions_, &RosSubscriptions::dropped, this, [this](const std::string& topic) {
    world_.forget(topic);
    reportUnplacedMarkers();
    forgetTrouble(topic);
    const auto& map = live_map_.last();
    if (map && map->topic == topic) live_map_.forget();
  });
  connect(&live_map_, &LiveMap::wantedChanged, this, [this] {
    if (std::exchange(selection_.whole_map, live_map_.wanted()) != live_map_.wanted()) sync();
  });
  connect(&map_service_, &MapFromService::came, this, &RosLink::onAskedMap);
  connect(&map_service_, &MapFromService::failed, this, [this](const std::string& service, const Fault& why) {
    updateTrouble(service, map::ProblemCode::Unavailable, Fault(fault::MapServiceFailed, {service}, {why}));
  });
  // Whoever gives the map by region is not asked for all of it.
  connect(&dispatch_, &DispatchRequests::offersChanged, this, &RosLink::sync);
  connect(&dispatch_, &DispatchRequests::topicsChanged, this, &RosLink::sync);
  connect(&dispatch_, &DispatchRequests::lookWanted, this, &RosLink::lookAnew);
  connect(&look_timer_, &QTimer::timeout, this, &RosLink::look);
  connect(&pose_timer_, &QTimer::timeout, this, &RosLink::notifyPose);
  connect(&overdue_timer_, &QTimer::timeout, this, [this] {
    WorldResults results = world_.overdue(wall());
    reportUnplacedMarkers();
    for (WorldResult& result : results) emitResult(std::move(result));
    notifyReception();
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
  graph_ = {};
  client_->close();
  onLink();
}

void RosLink::trust(const QByteArray& pinned_sha256) {
  options_.trust.pinned_sha256 = pinned_sha256;
  client_->setTrust(options_.trust);
  open();
}

void RosLink::setWanted(const map::Streams& streams, const QStringList& topics) {
  selection_.streams = streams;
  selection_.names.clear();
  for (const QString& topic : topics) selection_.names.push_back(topic.toStdString());
  sync();
}

void RosLink::setEveryMessage(bool on) {
  selection_.every_message = on;
  sync();
}

void RosLink::setRecorded(bool on) {
  selection_.recorded = on;
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
  selection_.basics = basics;
  sync();
}

/// Connected, perhaps again: it may be another robot now.
void RosLink::begin() {
  ++round_;
  known_ = looking_ = look_again_ = awaits_manager_ = false;
  deliveries_.beginAnew();
  reception_ = {};
  least_late_s_.reset();
  before_ = outputs_->mailbox.replaced() + world_.replaced();
  world_.forgetAll();
  reportUnplacedMarkers();
  kabam_.state().forget();
  live_map_.forget();
  map_service_.beginAnew();
  dispatch_.beginAnew();
  subscriptions_.beginAnew();
  overdue_timer_.start();
  look();
}

void RosLink::onLink() {
  if (!isOpen()) {
    ++round_;
    known_ = looking_ = look_again_ = awaits_manager_ = false;
    look_timer_.stop();
    overdue_timer_.stop();
    deliveries_.pause();
    subscriptions_.pause();
    map_service_.beginAnew();
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
    state.reason = {
        faultText("ros",
                  "there is a server at %1, but not a rosbridge server: %2. Check the address and the port."),
        {host},
        {state.reason}};
  }
  if (awaits_manager_) {
    state.phase = ConnectionPhase::Interrupted;
    state.failure = map::FailureKind::NotARobot;
    state.reason = {fault::NoMapManagerThere, {host}};
    state.retry_in_ms = std::max(0, look_timer_.remainingTime());
  }
  link_log_.record(state);
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
  api_.look(options_.ns, options_.dispatch, [this, round = round_](RosGraph found) {
    if (round != round_) return;
    if (std::exchange(look_again_, false)) {
      looking_ = false;
      return look();
    }
    keepUnheard(found);
    auto manager = mapManagerIn(found, options_.ns);
    if (manager || found.services) return onLook(std::move(found), std::move(manager));
    // Nobody tells: it is asked something.
    const std::string manager_ns = kabam_.there() ? kabam_.state().ns() : options_.ns + "/map_manager";
    api_.probeMapManager(
        manager_ns, [this, round, found = std::move(found), manager_ns](std::optional<bool> there) {
          if (round == round_)
            onLook(found, there.value_or(kabam_.there()) ? std::optional(manager_ns) : std::nullopt);
        });
  });
}

/// Who has told before is only slow now, and nothing is taken away because nothing was heard: not on the next
/// connection either, unless somebody says otherwise there.
void RosLink::keepUnheard(RosGraph& found) const {
  if (!found.topics && (known_ || found.topics_silent)) {
    found.topics = graph_.topics;
    found.unsent = graph_.unsent;
  }
  if (!found.services && (known_ || found.services_silent))
    found.dispatch_services = graph_.dispatch_services;
  if (!found.services && found.services_silent) {
    found.services = graph_.services;
    found.map_services = graph_.map_services;
  }
}

void RosLink::onLook(RosGraph found, std::optional<std::string> manager) {
  looking_ = false;
  look_timer_.start(options_.look_every);
  if (!(found == graph_) || !known_) {
    const auto count = [](const auto& list) { return list ? std::to_string(list->size()) : "unknown"; };
    qCInfo(lcRos, "topics: %s, services: %s, map manager: %s", count(found.topics).c_str(),
           count(found.services).c_str(), manager ? manager->c_str() : "none");
  }
  if (!manager && options_.kabam_only && !was_known_) return awaitManager();
  awaits_manager_ = false;
  graph_ = std::move(found);
  dispatch_.setDispatcher(dispatcherIn(graph_.dispatch_services, sentTopics(graph_), options_.dispatch));
  const bool other = kabam_.setNamespace(manager);
  selection_.managers_own = manager ? kabam_.state().topics() : std::vector<std::string>();
  findSources();
  const bool takes_pictures =
      manager && (!graph_.services || std::find(graph_.services->begin(), graph_.services->end(),
                                                *manager + "/update_map_image") != graph_.services->end());
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
  sources_ = sourcesOf(graph_.topics, options_.ns);
  Choices choices = choices_;
  // Editing, and requests by region, refer to the robot's current map.
  if (managesMaps()) choices.erase(map::Stream::WholeMap);
  ros::choose(sources_, choices, graph_.topics);
  if (!choices.contains(map::Stream::WholeMap)) addMapServices(sources_, graph_.map_services);
  std::set<std::string> patched;
  for (const Source& source : sources_) {
    if (source.form == Form::GridPatch) patched.insert(source.base);
  }
  world_.keepGrids(std::move(patched));
  std::vector<std::string> robots = robotsIn(sources_, options_.ns);
  if (robots.size() > 1 && options_.ns.empty() && robots != robots_) {
    std::string list;
    for (const std::string& robot : robots)
      list += (list.empty() ? "" : ", ") + (robot.empty() ? "/" : robot);
    report(map::Severity::Info, {fault::RosSeveralRobots, {list}});
  }
  robots_ = robots;
  world_.setRobots(std::move(robots));
  Q_EMIT topicsKnown({sources_, graph_.topics, managesMaps()});
}

void RosLink::whenKnown(const wire::TaskPtr& task, const map::Subject& subject, map::AskedFor asked_for,
                        Checked then) {
  using End = wire::WaitList::End;
  const auto ended = [subject, asked_for, then = std::move(then)](End how) {
    if (how == End::Held) return then(std::nullopt);
    map::Failure failure =
        failed(how, subject, fault::NoAnswerInTime, faultText("ros", "there is no connection to the robot"));
    failure.asked_for = asked_for;
    then(std::move(failure));
  };
  const bool connecting = client_->link().state() == WebSocketLink::State::Connecting;
  const bool coming = !awaits_manager_ && (isOpen() || connecting);
  if (!known_ && !coming) return ended(End::Dropped);
  early_.await(
      task, std::nullopt, [this] { return known_; }, ended);
}

bool RosLink::managesMaps() const { return !selection_.managers_own.empty() || dispatch_.dispatcher().any(); }

void RosLink::sync() {
  // Nothing is subscribed before the topics are known.
  if (!known_) return;
  // The map of a dispatcher that gives it by region may be gigabytes: about the whole people decide.
  selection_.map_by_region = dispatch_.dispatcher().has(DispatchService::GridRegion);
  selection_.dispatchers_own = dispatch_.topics();
  selection_.dispatchers_tried = dispatch_.triedTopic();
  const auto wanted = topicsFor(selection_, sources_, graph_);
  subscriptions_.ask(wanted, graph_);
  const bool by_topic = std::any_of(wanted.begin(), wanted.end(), [](const auto& topic) {
    return std::any_of(topic.second.sources.begin(), topic.second.sources.end(), [](const Source& source) {
      return source.stream == map::Stream::WholeMap && source.form == Form::Grid;
    });
  });
  const bool chosen = choices_.contains(map::Stream::WholeMap) && !managesMaps();
  const bool map_wanted =
      !chosen && (selection_.whole_map ||
                  (selection_.streams.contains(map::Stream::WholeMap) && !selection_.map_by_region));
  MapFromService::Services services{graph_.map_services, graph_.services.has_value()};
  if (!services.known) {
    services.names = usualMapServices(options_.ns);
    if (options_.dispatch.expected)
      services.names.insert(services.names.begin(), nameBy(options_.dispatch, DispatchService::Grid));
  }
  map_service_.want(map_wanted, by_topic, std::move(services));
}

void RosLink::onReceived(const TopicMessage& message) {
  deliveries_.onMessage(message);
  if (passesRaw(message.bytes)) Q_EMIT rawReceived(rawOf(message));
  const WantedTopic* const wanted = subscriptions_.heard(message.topic);
  if (!wanted) return;
  onManagerMessage(message);
  if (std::any_of(selection_.dispatchers_own.begin(), selection_.dispatchers_own.end(),
                  [&](const Endpoint& own) { return own.name == message.topic; }))
    updateTrouble(message.topic, map::ProblemCode::Unreadable, dispatch_.hear(message.topic, message.msg));
  ++reception_.came;
  bool of_pose = false;
  const std::vector<Source> sources = wanted->sources;
  if (!sources.empty()) recordDelay(sources.front(), message);
  for (const Source& source : sources) {
    WorldResults results = world_.add(source, message.msg, message.received_s);
    reportUnplacedMarkers();
    for (WorldResult& result : results) emitResult(std::move(result));
    of_pose |= source.stream == map::Stream::Pose;
    if (source.stream == map::Stream::WholeMap && source.form == Form::Grid) map_service_.heard();
  }
  if (of_pose && selection_.basics.pose && !pose_timer_.isActive()) {
    const qint64 since = pose_told_.isValid() ? pose_told_.elapsed() : qint64(kPoseEvery.count());
    pose_timer_.start(std::max(std::chrono::milliseconds(0), kPoseEvery - std::chrono::milliseconds(since)));
  }
}

// Clocks differ: what counts is the delay relative to the fastest message.
void RosLink::recordDelay(const Source& source, const TopicMessage& message) {
  const bool of_sensor =
      source.form == Form::LaserScan || source.form == Form::PointCloud || source.form == Form::Odometry;
  const auto stamp_s = of_sensor ? message.msg["header"]["stamp"].time() : std::nullopt;
  if (!stamp_s || *stamp_s == 0) return;
  const double delay_s = message.received_s - *stamp_s;
  least_late_s_ = std::min(delay_s, least_late_s_.value_or(delay_s));
  if (delay_s > *least_late_s_ + kLateS) ++reception_.late;
}

void RosLink::notifyReception() {
  if (reception_told_.isValid() && reception_told_.elapsed() < kReceptionEveryMs) return;
  reception_told_.start();
  Reception now = reception_;
  now.dropped = qint64(outputs_->mailbox.replaced() + world_.replaced() - before_);
  for (const auto& [pair, age_s] : world_.ages(wall())) {
    now.transforms.push_back(
        {QString::fromStdString(pair.parent), QString::fromStdString(pair.child), age_s});
  }
  Q_EMIT receptionTold(now);
}

void RosLink::reportUnplacedMarkers() {
  if (unplaced_markers_ == world_.waitingMarkers()) return;
  unplaced_markers_ = world_.waitingMarkers();
  std::map<QString, int> told;
  for (const auto& [topic, count] : unplaced_markers_) told[QString::fromStdString(topic)] = count;
  Q_EMIT unplacedMarkersTold(told);
}

void RosLink::onAskedMap(const std::string& service, const net::rosbridge::CallAnswer& answer) {
  const auto known = std::find_if(sources_.begin(), sources_.end(), [&](const Source& source) {
    return source.form == Form::MapService && source.topic == service;
  });
  Source source{map::Stream::WholeMap, Form::MapService, service, {}, {}, true};
  const std::vector<Source> maps = sourcesFor(map::Stream::WholeMap, sources_);
  if (known != sources_.end()) {
    source.base = known->base;
  } else if (!maps.empty()) {
    source.base = maps.front().topic;
  }
  updateTrouble(service, map::ProblemCode::Unavailable, std::nullopt);
  deliveries_.onMap(service, answer);
  // Patches, and whoever listens to the topic, take it for what that would have brought.
  if (!source.base.empty()) source.topic = source.base;
  for (WorldResult& result : world_.add(source, answer.values["map"], wall())) emitResult(std::move(result));
  if (!source.base.empty()) subscriptions_.replacedBy(source.base, service);
}

void RosLink::onManagerMessage(const TopicMessage& message) {
  if (!kabam_.there()) return;
  KabamState& state = kabam_.state();
  const KabamState::Update update = state.apply(message.topic, message.frame, message.msg);
  if (!update.own) return;
  const std::optional<Fault> odd =
      update.readable ? std::nullopt : std::optional<Fault>(fault::MessageNotUnderstood);
  updateTrouble(message.topic, map::ProblemCode::Unreadable, odd);
  if (update.maps && state.current() && !state.current()->map.id.empty())
    emitTopic(state.topics().front(), state.mapInfo(), message.received_s, std::nullopt);
  if (update.maps) pictures_.sawMap();
  kabam_.emitChanges(update);
}

void RosLink::emitResult(WorldResult result) {
  const std::string topic = result.topic;
  if (result.message || result.unreadable)
    updateTrouble(topic, map::ProblemCode::Unreadable, result.unreadable);
  if (result.message || result.unplaced) updateTrouble(topic, map::ProblemCode::Unplaced, result.unplaced);
  std::optional<Fault> odd;
  if (!result.notes.empty()) odd = result.notes.front();
  if (!result.unreadable) updateTrouble(topic, map::ProblemCode::Odd, odd);
  if (!result.message) return;
  const auto* const grid = std::get_if<map::GridMessage>(&*result.message);
  const bool whole = grid && grid->kind == map::GridKind::WholeMap;
  if (whole) {
    live_map_.onGrid(*grid);
    if (live_map_.last()) dispatch_.sawMap(live_map_.last()->fingerprint);
    pictures_.sawMap();
  }
  emitTopic(topic, std::move(*result.message), result.received_s, result.recorded_s);
}

void RosLink::updateTrouble(const std::string& topic, map::ProblemCode code,
                            const std::optional<Fault>& reason) {
  if (reason) {
    Trouble& trouble = troubles_[topic][code];
    const qint64 now = clock_.elapsed();
    if (trouble.reason == *reason && now - trouble.told_ms < kTellAgainMs) return;
    trouble = {*reason, now};
    qCInfo(lcRos, "%s: %s", topic.c_str(), inEnglish(*reason).c_str());
    Q_EMIT problemFound({map::Severity::Warning, topicSubject(topic), *reason, code});
    return;
  }
  const auto troubles = troubles_.find(topic);
  if (troubles == troubles_.end() || troubles->second.erase(code) == 0) return;
  Q_EMIT recovered({topicSubject(topic), code});
}

void RosLink::forgetTrouble(const std::string& topic) {
  const auto troubles = troubles_.extract(topic);
  if (troubles.empty()) return;
  for (const auto& [code, trouble] : troubles.mapped()) Q_EMIT recovered({topicSubject(topic), code});
}

// The first transforms may be only those of the wheels, and a pose may arrive before any of them: the robot
// would seem to jump when the others arrive.
bool RosLink::framesComplete() const {
  const bool map_expected = (!selection_.map_by_region || selection_.whole_map) &&
                            !sourcesFor(map::Stream::WholeMap, sources_).empty();
  const bool transforms_expected = std::any_of(sources_.begin(), sources_.end(),
                                               [](const Source& source) { return source.form == Form::Tf; });
  return (!map_expected || world_.fixedByMap()) && (!transforms_expected || world_.posedByTransforms());
}

void RosLink::notifyPose() {
  if (known_since_.elapsed() < kFramesMs && !framesComplete()) {
    pose_timer_.start(std::chrono::milliseconds(kFramesMs / 20));
    return;
  }
  const auto pose = world_.pose();
  const std::vector<Source> sources = sourcesFor(map::Stream::Pose, sources_);
  if (!pose || sources.empty()) return;
  const std::string topic = sources.front().topic;
  if (!*pose) {
    if (!pose_missing_.isValid()) pose_missing_.start();
    if (pose_missing_.elapsed() < kPoseMissingMs) return;
    pose_missing_.start();
    updateTrouble(topic, map::ProblemCode::Unplaced, pose->error());
    return;
  }
  pose_missing_.invalidate();
  updateTrouble(topic, map::ProblemCode::Unplaced, std::nullopt);
  const bool again = !pose_told_.isValid() || pose_told_.elapsed() >= kPoseAnywayMs;
  if (last_pose_ == **pose && !again) return;
  last_pose_ = **pose;
  pose_told_.start();
  emitTopic(topic, map::TrackedPose{**pose}, wall(), std::nullopt);
}

void RosLink::emitTopic(const std::string& topic, map::TopicMessage message, double received_s,
                        std::optional<double> recorded_s) {
  pass({std::move(message), received_s, recorded_s, topic});
}

}  // namespace mapwright::robot::ros

#include "moc_ros_link.cpp"
