#include "robot/ros/ros_link.h"

#include <algorithm>
#include <utility>

#include <QDateTime>

#include "robot/wire/link_state.h"

namespace mapwright::robot::ros {

using net::WebSocketLink;

RosLink::RosLink(LinkOptions options, std::shared_ptr<wire::TopicMailbox> mailbox,
                 std::shared_ptr<wire::TapPlace> tap)
    : options_(std::move(options)),
      mailbox_(std::move(mailbox)),
      tap_(std::move(tap)),
      world_(options_.ns),
      sources_(sourcesOf(std::nullopt, options_.ns)) {}

RosLink::~RosLink() {
  // What is under way must not reach a half-destroyed object.
  if (!client_) return;
  client_->disconnect(this);
  subscriptions_->disconnect(this);
  live_map_->disconnect(this);
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
  look_timer_ = std::make_unique<QTimer>();
  pose_timer_ = std::make_unique<QTimer>();
  overdue_timer_ = std::make_unique<QTimer>();
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
    if (serious)
      report(map::Severity::Warning, {map::ReasonCode::ItAnswered, {words.left(300).toStdString()}});
  });
  connect(client_.get(), &Client::odd, this,
          [this] { report(map::Severity::Info, {map::ReasonCode::MessageNotUnderstood}); });
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
  connect(look_timer_.get(), &QTimer::timeout, this, &RosLink::look);
  connect(pose_timer_.get(), &QTimer::timeout, this, &RosLink::tellPose);
  connect(overdue_timer_.get(), &QTimer::timeout, this, [this] {
    for (WorldResult& result : world_.overdue(wall())) tell(std::move(result));
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
  refused_ = false;
  client_->open();
  publishState();
}

void RosLink::close() {
  wanted_ = false;
  was_known_ = false;
  refused_ = false;
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

void RosLink::setBasics(const LiveTopics::Basics& basics) {
  start();
  wish_.basics = basics;
  sync();
}

/// Open, perhaps again: another robot may answer there now.
void RosLink::begin() {
  ++round_;
  known_ = looking_ = false;
  found_ = {};
  world_.forgetAll();
  kabam_->book().forget();
  live_map_->forget();
  subscriptions_->beginAnew();
  overdue_timer_->start();
  look();
}

void RosLink::noteLink() {
  if (!open_() && client_) {
    ++round_;
    known_ = looking_ = false;
    look_timer_->stop();
    overdue_timer_->stop();
    subscriptions_->pause();
    while (!troubles_.empty()) forgetTrouble(troubles_.begin()->first);
    // Who waits for a first connection goes on waiting; there is none to wait for any more otherwise.
    if (client_->link().state() != WebSocketLink::State::Connecting) {
      const auto early = early_;
      for (const EarlyPtr& one : early) endEarly(one, map::FailureKind::Unreachable);
      live_map_->endAll({.kind = map::FailureKind::Unreachable, .cause = {map::ReasonCode::LinkBrokeOff}});
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
    state.reason = {map::ReasonCode::NoRosbridgeThere, {host}, {state.reason}};
  }
  if (refused_) {
    state.phase = ConnectionPhase::Refused;
    state.failure = map::FailureKind::NotARobot;
    state.reason = {map::ReasonCode::NoMapManagerThere, {host}};
  }
  Q_EMIT stateChanged(state);
}

void RosLink::report(map::Severity severity, map::Reason reason) {
  const QString host = QStringLiteral("%1:%2").arg(options_.url.host()).arg(options_.url.port());
  Q_EMIT problemFound(
      {severity, map::Subject(map::SubjectKind::Robot, host.toStdString()), std::move(reason)});
}

void RosLink::look() {
  if (std::exchange(looking_, true)) return;
  api_->look([this, round = round_](Found found) {
    if (round != round_) return;
    auto manager = mapManagerIn(found, options_.ns);
    if (manager || found.services) return takeLook(std::move(found), std::move(manager));
    // Nobody tells: it is asked something.
    const std::string place = options_.ns + "/map_manager";
    api_->probeMapManager(place, [this, round, found = std::move(found), place](bool there) {
      if (round == round_) takeLook(found, there ? std::optional(place) : std::nullopt);
    });
  });
}

void RosLink::takeLook(Found found, std::optional<std::string> manager) {
  looking_ = false;
  look_timer_->start(options_.look_every);
  // One that has told before is only slow now.
  if (known_ && !found.topics) found.topics = found_.topics;
  if (!manager && options_.kabam_only && !was_known_) return refuse();
  found_ = std::move(found);
  sources_ = sourcesOf(found_.topics, options_.ns);
  KnownTopics topics{sources_, {}};
  if (found_.topics) {
    for (const FoundTopic& topic : *found_.topics) topics.names.push_back(topic.name);
  }
  Q_EMIT topicsKnown(topics);
  wish_.managers_own.clear();
  if (manager) {
    kabam_->book().setPlace(*manager);
    wish_.managers_own = kabam_->book().topics();
  } else {
    kabam_->book().forget();
  }
  std::set<std::string> patched;
  for (const Source& source : sources_) {
    if (source.form == Form::GridPatch) patched.insert(source.base);
  }
  world_.keepGrids(std::move(patched));
  const bool first = !std::exchange(known_, true);
  was_known_ = true;
  const bool other = std::exchange(has_manager_, manager.has_value()) != has_manager_;
  if (first || other) Q_EMIT mapManagerKnown(has_manager_);
  sync();
  if (!first) return;
  known_since_.start();
  publishState();
  const auto early = early_;
  for (const EarlyPtr& one : early) endEarly(one, std::nullopt);
}

void RosLink::refuse() {
  refused_ = true;
  client_->close();
  noteLink();
}

void RosLink::sync() {
  // Before it is known what there is, nothing is asked for.
  if (!known_) return;
  subscriptions_->ask(topicsFor(wish_, sources_, found_), found_);
}

}  // namespace mapwright::robot::ros
