#include "robot/axbot/axbot_link.h"

#include <algorithm>
#include <cmath>

#include <QDateTime>

#include "map/submap_version.h"
#include "robot/axbot/device_info.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/parse_maps.h"
#include "robot/faults.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::axbot {
namespace {

Q_LOGGING_CATEGORY(lcAxbot, "mapwright.axbot", QtWarningMsg)

constexpr int kSubscribeAnswerMs = 3'000;
constexpr std::chrono::milliseconds kListExpectedWithin{10'000};  // before it is remarked upon
constexpr qint64 kCacheBudgetBytes = qint64(2) << 30;
constexpr std::chrono::milliseconds kLongestAskAgain{60'000};
constexpr int kSubmapsAtOnce = 4;  // network requests in parallel; those from disk are additional

QUrl socketUrl(const QUrl& base, bool binary) {
  QUrl url = base;
  url.setScheme(base.scheme() == QLatin1String("https") ? QStringLiteral("wss") : QStringLiteral("ws"));
  url.setPath(base.path() + QStringLiteral("/ws/v2/topics"));
  if (binary) url.setQuery(QStringLiteral("pb=1"));
  return url;
}

}  // namespace

AxbotLink::AxbotLink(LinkOptions options)
    : RobotLink(lcAxbot(), options.base, options.secret),
      options_(std::move(options)),
      cache_(options_.cache_folder.isEmpty()
                 ? nullptr
                 : std::make_unique<net::HttpCache>(options_.cache_folder, kCacheBudgetBytes)),
      http_(options_.base, options_.secret, cache_.get()),
      maps_(server()),
      changes_(server(), maps_,
               [this] {
                 return robot_ahead_s_ ? std::optional(options_.wall_s() + *robot_ahead_s_) : std::nullopt;
               }),
      bags_(server(), options_.recording_patience),
      overlays_(server()),
      sightings_(server()),
      transfers_(server(), maps_),
      poses_(
          server(),
          [this](const QStringList& topics) {
            held_ = topics;
            askForWanted();
          },
          options_.pose_patience),
      grids_(server()),
      // Old firmware does not know the query; if the handshake is refused for it, it is left out.
      socket_({socketUrl(options_.base, true), socketUrl(options_.base, false)}, options_.secret,
              options_.socket) {
  if (cache_) {
    cache_->setTrouble([this](const Fault& why) {
      Q_EMIT problemFound({map::Severity::Warning,
                           map::SubjectKind::DiskCache,
                           {faultText("axbot", "The robot's answers cannot be saved to disk"),
                            {},
                            {why},
                            Consequence::AskedAgainEachTime}});
    });
  }
  grids_.setReceiver([this](map::TopicMessage message) {
    const auto* grid = std::get_if<map::GridMessage>(&message);
    const std::string topic = grid ? grid->topic : std::string();
    emitTopic(topic, std::move(message));
  });
  grids_.setKeeper([this](const std::string& topic, const std::string& data_url,
                          std::shared_ptr<const std::string> picture) {
    wire::DeliveryTapSlot::Parcel parcel = parcelOf(data_url, std::move(picture), options_.wall_s());
    parcel.kind = Delivery::Kind::Picture;
    parcel.encoding = "image/png";
    parcel.slot = "picture of " + topic;
    outputs_->deliveries.pass(std::move(parcel));
  });
  http_.setTrust(options_.trust);
  socket_.setTrust(options_.trust);
  for (QTimer* timer : {&list_timer_, &subscribe_timer_, &older_timer_, &again_timer_})
    timer->setSingleShot(true);
  connect(&older_timer_, &QTimer::timeout, this, [this] {
    qCDebug(lcAxbot, "topics are silent: their older names are tried too");
    older_.merge(silentStreams());
    askForWanted();
  });
  connect(&again_timer_, &QTimer::timeout, this, &AxbotLink::askAgainForOnceSaid);
  connect(&list_timer_, &QTimer::timeout, this, [this] {
    Q_EMIT problemFound({map::Severity::Warning,
                         map::SubjectKind::SubmapList,
                         {faultText("axbot",
                                    "The robot has not sent a list yet. It may have no SLAM session, or its "
                                    "firmware may not have the topic %1. Still listening."),
                          {"/submap_list"}},
                         map::ProblemCode::Unavailable});
  });
  connect(&subscribe_timer_, &QTimer::timeout, this, [this] {
    if (topics_confirmed_) return;
    qCInfo(lcAxbot, "no list of topics was confirmed: they are enabled one by one");
    subscriptions_.setTakesLists(false);
    send(subscriptions_.all());
  });
  connect(&socket_, &net::WebSocketLink::changed, this, &AxbotLink::publishState);
  connect(&socket_, &net::WebSocketLink::opened, this, [this] {
    outputs_->deliveries.forget();
    robot_ahead_s_.reset();
    delivered_definition_ = false;
    topics_confirmed_ = false;
    subscribed_ = false;
    // It may have new firmware.
    heard_topics_.clear();
    again_timer_.stop();
    again_timer_.setInterval(options_.ask_again_after);
    older_.clear();
    older_timer_.stop();
    askForWanted();
    device_info_answered_ ? subscribe() : askDeviceInfo();
  });
  connect(&socket_, &net::WebSocketLink::textReceived, this, &AxbotLink::onText);
  connect(&socket_, &net::WebSocketLink::binaryReceived, this, &AxbotLink::onBinary);
}

RobotServer AxbotLink::server() {
  return {.http = http_,
          .base = options_.base,
          .timeout = options_.answer_timeout,
          .report = [this](const map::Problem& found) { Q_EMIT problemFound(found); },
          .recovered = [this](const map::Recovery& well) { Q_EMIT recovered(well); }};
}

void AxbotLink::open() {
  wanted_ = true;
  socket_.open();
}

void AxbotLink::close() {
  wanted_ = false;
  list_timer_.stop();
  subscribe_timer_.stop();
  older_timer_.stop();
  http_.cancelAll();
  grids_.cancelAll();
  socket_.close();
  publishState();
}

QUrl AxbotLink::submapUrl(const map::SubmapKey& key, std::int32_t version) const {
  return urlOnRobot(
      options_.base,
      QStringLiteral("/ros/slam/submaps/%1/%2/%3")
          .arg(pathSegment(key.uuid), QString::number(key.id.trajectory), QString::number(key.id.index)),
      version == map::kNoVersion ? QString() : QStringLiteral("ver=%1").arg(version));
}

void AxbotLink::askDeviceInfo() {
  if (device_info_asked_) return;
  device_info_asked_ = true;
  net::HttpRequest request;
  request.url = urlOnRobot(options_.base, QStringLiteral("/device/info"));
  request.timeout = std::chrono::milliseconds(5'000);
  request.max_bytes = qint64(4) << 20;
  http_.send(request, [this](const net::HttpAnswer& answer) { onDeviceInfo(answer); });
}

void AxbotLink::onDeviceInfo(const net::HttpAnswer& answer) {
  device_info_asked_ = false;
  if (answer.ok()) {
    const DeviceInfo info = deviceInfoIn(answer.body);
    const RobotIdentity& identity = info.identity;
    subscriptions_.setTakesLists(info.takes_topic_lists);
    qCInfo(lcAxbot, "model \"%s\", firmware \"%s\", takes lists of topics: %s",
           qUtf8Printable(identity.model), qUtf8Printable(identity.version),
           subscriptions_.takesLists() ? "yes" : "no");
    Q_EMIT identityChanged(identity);
  } else if (answer.kind != net::HttpAnswer::Kind::Cancelled) {
    // Not fatal: the robot is then taken for the oldest kind.
    report(map::Severity::Info, {faultText("axbot", "It does not report what it is"), {}, {answer.reason}});
  }
  device_info_answered_ = answer.kind == net::HttpAnswer::Kind::Answered;
  if (socket_.state() == net::WebSocketLink::State::Open) subscribe();
}

void AxbotLink::subscribe() {
  subscribed_ = true;
  const QStringList names = subscriptions_.names();
  if (names.contains(QLatin1String("/submap_list"))) list_timer_.start(kListExpectedWithin);
  send(subscriptions_.all());
  if (!silentStreams().empty()) older_timer_.start(options_.older_names_after);
  // Some firmware claims to support lists and ignores them.
  if (subscriptions_.takesLists() && !names.isEmpty()) subscribe_timer_.start(kSubscribeAnswerMs);
}

void AxbotLink::setBasics(const LiveTopics::Basics& basics) { subscriptions_.setBasics(basics); }

void AxbotLink::setWanted(const map::Streams& streams, const QStringList& topics) {
  streams_ = streams;
  topics_ = topics;
  askForWanted();
}

void AxbotLink::askForWanted() {
  QStringList names;
  for (const map::Stream stream : streams_) {
    const StreamTopics topics = topicsOf(stream);
    names += topics.usual;
    if (older_.contains(stream)) names += topics.older;
  }
  const QStringList requests = subscriptions_.setWanted(names + topics_ + held_);
  // Before the first subscription everything is included in it.
  if (!subscribed_) return;
  send(requests);
  if (!older_timer_.isActive() && !silentStreams().empty()) older_timer_.start(options_.older_names_after);
}

map::Streams AxbotLink::silentStreams() const {
  map::Streams silent;
  for (const map::Stream stream : streams_) {
    const StreamTopics topics = topicsOf(stream);
    const bool heard = std::any_of(topics.usual.begin(), topics.usual.end(), [&](const QString& topic) {
      return heard_topics_.contains(topic.toStdString());
    });
    if (!topics.older.isEmpty() && !heard && !older_.contains(stream)) silent.insert(stream);
  }
  return silent;
}

void AxbotLink::askAgainForOnceSaid() {
  // Data that is sent regularly needs no request.
  QStringList topics;
  const QStringList names = subscriptions_.names();
  for (const QString& topic : names) {
    const auto heard = heard_topics_.find(topic.toStdString());
    if (heard == heard_topics_.end() || heard->second < 2) topics << topic;
  }
  send(subscriptions_.anew(topics));
  // If this continues, the robot is asked less and less often.
  again_timer_.setInterval(std::min(again_timer_.intervalAsDuration() * 2, kLongestAskAgain));
}

void AxbotLink::send(const QStringList& requests) {
  for (const QString& request : requests) {
    qCDebug(lcAxbot, "sent %s", qUtf8Printable(request));
    socket_.sendText(request);
  }
}

void AxbotLink::deliver(std::shared_ptr<const std::string> bytes, const std::string& topic,
                        const char* encoding, std::optional<double> said_s) {
  wire::DeliveryTapSlot::Parcel parcel = parcelOf(topic, std::move(bytes), options_.wall_s());
  parcel.encoding = encoding;
  if (std::string_view(encoding) == "protobuf") parcel.schema = kBinaryType;
  // A topic may use both ways; an answer without topic belongs to the last request.
  if (!topic.empty()) parcel.slot = encoding + topic;
  parcel.said_s = said_s;
  outputs_->deliveries.pass(std::move(parcel));
}

void AxbotLink::deliverDefinition() {
  if (std::exchange(delivered_definition_, true)) return;
  wire::DeliveryTapSlot::Parcel parcel =
      parcelOf(kBinaryType, std::make_shared<const std::string>(binaryTypeDefinition()), options_.wall_s());
  parcel.kind = Delivery::Kind::Definition;
  parcel.encoding = "protobuf";
  parcel.slot = "definition";
  outputs_->deliveries.pass(std::move(parcel));
}

void AxbotLink::onText(const QByteArray& utf8) {
  TextFrame frame = topic_reader_.read(wire::view(utf8));
  if (frame.topic.empty()) {
    // An answer, which may repeat what it was asked with.
    QByteArray without = utf8;
    unsaid().hideIn(without);
    if (without != utf8) return onText(without);
  }
  outputs_->tap.pass({wire::view(utf8), false, options_.wall_s()});
  deliver(std::make_shared<const std::string>(wire::view(utf8)), frame.topic, "json", frame.stamp_s);
  if (passesRaw(utf8.size())) Q_EMIT rawReceived(rawText(frame.topic, wire::view(utf8)));
  // A message may be sent again long after it was stamped: the newest stamp counts.
  if (frame.stamp_s)
    robot_ahead_s_ = std::max(robot_ahead_s_.value_or(-HUGE_VAL), *frame.stamp_s - options_.wall_s());
  if (frame.message) {
    emitTopic(frame.topic, std::move(*frame.message));
    if (frame.left_out) emitTopic(frame.topic, std::move(*frame.left_out));
  } else if (frame.grid_to_fetch) {
    grids_.fetch(std::move(*frame.grid_to_fetch));
  } else if (frame.enabled_topics) {
    const QStringList asked = subscriptions_.names();
    qCDebug(lcAxbot, "enabled topics: %zu", frame.enabled_topics->size());
    topics_confirmed_ |=
        std::any_of(frame.enabled_topics->begin(), frame.enabled_topics->end(),
                    [&](const std::string& name) { return asked.contains(QString::fromStdString(name)); });
  } else if (!frame.error.empty()) {
    report(map::Severity::Warning, {robot::fault::ItAnswered, {frame.error.substr(0, 300)}});
  }
}

void AxbotLink::onBinary(const QByteArray& bytes) {
  outputs_->tap.pass({wire::view(bytes), true, options_.wall_s()});
  auto frame = unpackBinaryFrame(wire::view(bytes));
  const std::string topic = topicOfBinaryFrame(wire::view(bytes));
  if (passesRaw(bytes.size())) Q_EMIT rawReceived(rawBinary(wire::view(bytes)));
  std::optional<map::TopicMessage> message;
  if (frame) {
    message = parseBinaryBody(topic, frame->body);
  } else {
    message = frame.error();
  }
  if (frame) {
    deliverDefinition();
    deliver(std::make_shared<const std::string>(std::move(frame->body)), topic, "protobuf", std::nullopt);
  } else {
    deliver(std::make_shared<const std::string>(wire::view(bytes)), topic, "axbot", std::nullopt);
  }
  if (message) emitTopic(topic, std::move(*message));
}

void AxbotLink::emitTopic(const std::string& topic, map::TopicMessage message) {
  const auto recover = [this](const std::string& name) {
    if (unreadable_topics_.erase(name) > 0)
      Q_EMIT recovered({map::Subject(map::SubjectKind::Topic, name), map::ProblemCode::Unreadable});
  };
  if (const auto* unreadable = std::get_if<map::UnreadableMessage>(&message)) {
    if (unreadable_topics_.insert(unreadable->topic).second)
      qCInfo(lcAxbot, "%s cannot be read: %s", unreadable->topic.c_str(),
             inEnglish(unreadable->reason).c_str());
    if (unreadable->topic == kUnknownTopic && !again_timer_.isActive()) again_timer_.start();
    if (unreadable->topic == "/submap_list") list_timer_.stop();  // it has sent one
  } else {
    if (++heard_topics_[topic] == 1) qCDebug(lcAxbot, "first message of %s", topic.c_str());
    if (!unreadable_topics_.empty()) {
      recover(topic);
      recover(kUnknownTopic);  // messages can be read again
    }
  }
  poses_.hear(message);
  if (std::holds_alternative<map::SubmapList>(message)) {
    topics_confirmed_ = true;
    list_timer_.stop();
  }
  pass({std::move(message), options_.wall_s(), std::nullopt, topic});
}

void AxbotLink::fetchOverview(const wire::TaskPtr& task, double resolution_m,
                              OutcomeTo<map::WholeMap> reply) {
  maps_.fetchOverview(task, resolution_m, [this, reply = std::move(reply)](Outcome<map::WholeMap> overview) {
    const std::string code = overview ? std::string() : overview.error().robot_code;
    if (code == "404" || code == "405" || code == "501") Q_EMIT overviewUnknown(QString::fromStdString(code));
    reply(std::move(overview));
  });
}

void AxbotLink::discardSubmap(const map::SubmapKey& key, std::int32_t answered_version) {
  http_.discard(submapUrl(key, key.version));
  if (answered_version > 0 && answered_version != key.version) {
    http_.discard(submapUrl(key, answered_version));
  }
}

void AxbotLink::discardPicture(const std::string& fingerprint) {
  maps_.discardPicture(fingerprint);
  grids_.discardPicture(fingerprint);
}

void AxbotLink::submap(const wire::TaskPtr& task, const map::SubmapKey& key,
                       OutcomeTo<map::SubmapAnswer> reply) {
  net::HttpRequest request;
  request.url = submapUrl(key, key.version);
  request.accept = "application/x-protobuf";
  request.cacheable = true;
  request.content_addressed = key.version != map::kNoVersion;
  request.timeout = options_.fetch_timeout;
  request.most_at_once = kSubmapsAtOnce;
  wire::send(task, http_, request,
             [this, task, key, url = request.url, reply = std::move(reply)](const net::HttpAnswer& http) {
               map::SubmapAnswer answer = onSubmap(key, url, http);
               if (answer.outcome == map::SubmapAnswer::Outcome::Ok || !http.ok() || !http.from_cache)
                 return reply(std::move(answer));
               // What lies on the disk is none of the robot's business: it is asked itself.
               http_.discard(url);
               submap(task, key, reply);
             });
}

map::SubmapAnswer AxbotLink::onSubmap(const map::SubmapKey& key, const QUrl& url,
                                      const net::HttpAnswer& http) {
  using Outcome = map::SubmapAnswer::Outcome;
  map::SubmapAnswer answer;
  if (http.ok()) {
    answer = parseSubmapResponse(key, wire::view(http.body));
    answer.from_cache = http.from_cache;
    if (answer.outcome == Outcome::Ok) {
      wire::DeliveryTapSlot::Parcel parcel;
      parcel.kind = Delivery::Kind::Submap;
      parcel.encoding = "application/x-protobuf";
      parcel.submap = key;
      if (answer.version > 0) parcel.submap.version = answer.version;
      parcel.bytes = wire::view(http.body);
      parcel.received_s = options_.wall_s();
      outputs_->deliveries.pass(std::move(parcel));
    }
    if (cache_ && !http.from_cache) {
      // The address contains the requested version; the body is the robot's present version. Cache it only
      // under its own name, so that neither a failure nor an older picture is taken for that version after a
      // restart.
      const bool other_version = answer.version > 0 && answer.version != key.version;
      if (answer.outcome == Outcome::Ok && other_version) {
        cache_->copy(url, submapUrl(key, answer.version));
      }
      if (answer.outcome != Outcome::Ok || (other_version && answer.version < key.version))
        cache_->remove(url);
    }
  } else {
    answer.key = key;
    answer.bytes = std::size_t(http.body.size());
    answer.reason = http.reason;
    answer.failure = wire::failureOf(http);
    answer.outcome = http.kind == net::HttpAnswer::Kind::Cancelled ? Outcome::Cancelled
                     : http.status == 404                          ? Outcome::NotFound
                                                                   : Outcome::Failed;
  }
  return answer;
}

Fault AxbotLink::unavailableReason() const {
  if (socket_.failure() != net::WebSocketLink::Failure::NotAWebSocket) return socket_.reason();
  return {fault::NoAutoxingRobotThere, {wire::hostOf(options_.base)}, {socket_.reason()}};
}

void AxbotLink::trust(const QByteArray& pinned_sha256) {
  options_.trust.pinned_sha256 = pinned_sha256;
  http_.setTrust(options_.trust);
  socket_.setTrust(options_.trust);
  open();
}

void AxbotLink::publishState() {
  ConnectionState state = wire::stateOf(socket_, wanted_);
  if (state.reason.any()) state.reason = unavailableReason();
  link_log_.record(state);
  Q_EMIT silenceChanged(socket_.silentSince().value_or(QDateTime()));
  Q_EMIT stateChanged(state);
}

}  // namespace mapwright::robot::axbot

#include "moc_axbot_link.cpp"
