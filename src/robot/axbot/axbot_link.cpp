#include "robot/axbot/axbot_link.h"

#include <algorithm>

#include <QJsonDocument>
#include <QJsonObject>
#include <QUrlQuery>

#include "robot/axbot/parse_submap.h"
#include "robot/axbot/raw_messages.h"
#include "robot/axbot/robot_urls.h"
#include "robot/wire/http_failure.h"

namespace mapwright::robot::axbot {
namespace {

constexpr int kSubscribeAnswerMs = 3'000;

std::string_view view(const QByteArray& bytes) { return {bytes.constData(), std::size_t(bytes.size())}; }

/// A member by any of its names, looked for here and one level down: firmware versions nest them differently.
QJsonValue findMember(const QJsonObject& object, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const auto value = object.value(QLatin1String(name)); !value.isUndefined() && !value.isNull())
      return value;
  }
  for (const QJsonValue& child : object) {
    if (!child.isObject()) continue;
    const QJsonObject inner = child.toObject();
    for (const char* name : names) {
      if (const auto value = inner.value(QLatin1String(name)); !value.isUndefined() && !value.isNull())
        return value;
    }
  }
  return QJsonValue::Undefined;
}

QString memberText(const QJsonObject& object, std::initializer_list<const char*> names) {
  const QJsonValue value = findMember(object, names);
  return value.isString()   ? value.toString().left(200)
         : value.isDouble() ? value.toVariant().toString()
                            : QString();
}

map::FailureKind failureOf(net::WebSocketLink::Fault fault) {
  using Fault = net::WebSocketLink::Fault;
  switch (fault) {
    case Fault::None:
      break;
    case Fault::Unreachable:
      return map::FailureKind::Unreachable;
    case Fault::TimedOut:
      return map::FailureKind::TimedOut;
    case Fault::Refused:
      return map::FailureKind::Refused;
    case Fault::NotAWebSocket:
      return map::FailureKind::NotARobot;
    case Fault::Certificate:
      return map::FailureKind::Certificate;
  }
  return map::FailureKind::None;
}

QUrl socketUrl(const QUrl& base, bool binary) {
  QUrl url = base;
  url.setScheme(base.scheme() == QLatin1String("https") ? QStringLiteral("wss") : QStringLiteral("ws"));
  url.setPath(base.path() + QStringLiteral("/ws/v2/topics"));
  if (binary) url.setQuery(QStringLiteral("pb=1"));
  return url;
}

}  // namespace

AxbotLink::AxbotLink(LinkOptions options, std::shared_ptr<TopicMailbox> mailbox)
    : options_(std::move(options)), mailbox_(std::move(mailbox)) {}

AxbotLink::~AxbotLink() {
  // Replies of what is under way must not reach a half-destroyed object.
  if (http_) http_->disconnect(this);
  socket_.reset();
  http_.reset();  // calls nobody any more, so those who ask it may go after it
}

void AxbotLink::start() {
  if (http_) return;
  if (!options_.cache_folder.isEmpty()) {
    cache_ = std::make_unique<net::HttpCache>(options_.cache_folder, options_.cache_budget_bytes);
    cache_->setTrouble([this](const QString& sentence) {
      Q_EMIT problemFound({map::Severity::Warning, "Disk cache", sentence.toStdString()});
    });
  }
  http_ = std::make_unique<net::HttpClient>(options_.base, options_.secret, cache_.get());
  maps_ = std::make_unique<MapRequests>(
      *http_, options_.base, [this](const map::Problem& found) { Q_EMIT problemFound(found); },
      [this](const map::Recovery& well) { Q_EMIT recovered(well); });
  grids_ = std::make_unique<GridFetcher>(*http_, options_.base, [this](map::TopicMessage message) {
    const auto* grid = std::get_if<map::GridMessage>(&message);
    const std::string topic = grid ? grid->topic : std::string();
    emitTopic(topic, std::move(message));
  });
  clock_.start();
  // The query is unknown to old firmware; where the handshake is refused for it, it goes without.
  socket_ = std::make_unique<net::WebSocketLink>(
      QList<QUrl>{socketUrl(options_.base, true), socketUrl(options_.base, false)}, options_.secret,
      options_.socket);
  http_->setTrust(options_.trust);
  socket_->setTrust(options_.trust);
  list_timer_ = std::make_unique<QTimer>();
  subscribe_timer_ = std::make_unique<QTimer>();
  for (QTimer* timer : {list_timer_.get(), subscribe_timer_.get()}) timer->setSingleShot(true);
  connect(list_timer_.get(), &QTimer::timeout, this, [this] {
    Q_EMIT problemFound({map::Severity::Warning, map::Subject(map::SubjectKind::SubmapList, {}),
                         tr("The robot has not sent one yet. It may have no SLAM session, or its firmware "
                            "may not know the topic /submap_list. Still listening.")
                             .toStdString(),
                         map::ProblemCode::Unavailable});
  });
  connect(subscribe_timer_.get(), &QTimer::timeout, this, [this] {
    if (topics_confirmed_) return;
    subscriptions_.setTakesLists(false);
    send(subscriptions_.all());
  });
  connect(socket_.get(), &net::WebSocketLink::changed, this, &AxbotLink::publishState);
  connect(socket_.get(), &net::WebSocketLink::opened, this, [this] {
    topics_confirmed_ = false;
    subscribed_ = false;
    if (device_info_answered_)
      subscribe();
    else
      askDeviceInfo();
  });
  connect(socket_.get(), &net::WebSocketLink::textReceived, this, &AxbotLink::takeText);
  connect(socket_.get(), &net::WebSocketLink::binaryReceived, this, &AxbotLink::takeBinary);
}

void AxbotLink::open() {
  start();
  wanted_ = true;
  socket_->open();
}

void AxbotLink::close() {
  wanted_ = false;
  if (!http_) return;
  list_timer_->stop();
  subscribe_timer_->stop();
  http_->cancelAll();
  grids_->cancelAll();
  socket_->close();
  publishState();
}

QUrl AxbotLink::submapUrl(const map::SubmapKey& key, std::int32_t version) const {
  QUrl url = options_.base;
  const QString uuid = QString::fromLatin1(QUrl::toPercentEncoding(QString::fromStdString(key.uuid)));
  url.setPath(
      QString::fromLatin1(QUrl::toPercentEncoding(options_.base.path(), "/")) +
          QStringLiteral("/ros/slam/submaps/%1/%2/%3").arg(uuid).arg(key.id.trajectory).arg(key.id.index),
      QUrl::TolerantMode);
  QUrlQuery query;
  query.addQueryItem(QStringLiteral("ver"), QString::number(version));
  url.setQuery(query);
  return url;
}

map::Problem AxbotLink::problem(map::Severity severity, const QString& sentence) const {
  const QString host = QStringLiteral("%1:%2").arg(options_.base.host()).arg(options_.base.port());
  return {severity, map::Subject(map::SubjectKind::Robot, host.toStdString()), sentence.toStdString()};
}

void AxbotLink::askDeviceInfo() {
  if (device_info_asked_) return;
  device_info_asked_ = true;
  net::HttpRequest request;
  request.url = urlOnRobot(options_.base, QStringLiteral("/device/info"));
  request.timeout = std::chrono::milliseconds(5'000);
  request.max_bytes = qint64(4) << 20;
  http_->get(request, [this](const net::HttpAnswer& answer) { takeDeviceInfo(answer); });
}

void AxbotLink::takeDeviceInfo(const net::HttpAnswer& answer) {
  device_info_asked_ = false;
  if (answer.ok()) {
    const QJsonObject info = QJsonDocument::fromJson(answer.body).object();
    RobotIdentity identity;
    identity.model = memberText(info, {"model"});
    identity.serial = memberText(info, {"sn", "serial", "serial_number"});
    identity.name = memberText(info, {"nickname", "name"});
    identity.version = memberText(info, {"axbot_version", "version", "software_version"});
    subscriptions_.setTakesLists(findMember(info, {"supportsEnableTopicList"}).toBool(false));
    Q_EMIT identityChanged(identity);
  } else if (answer.kind != net::HttpAnswer::Kind::Cancelled) {
    // Not fatal: the robot is then taken for the oldest kind.
    Q_EMIT problemFound(
        problem(map::Severity::Info, tr("It does not say what it is: %1").arg(answer.sentence)));
  }
  device_info_answered_ = answer.kind == net::HttpAnswer::Kind::Answered;
  if (socket_->state() == net::WebSocketLink::State::Open) subscribe();
}

void AxbotLink::subscribe() {
  subscribed_ = true;
  const QStringList names = subscriptions_.names();
  if (names.contains(QLatin1String("/submap_list"))) list_timer_->start(options_.list_expected_within);
  send(subscriptions_.all());
  // Some firmware claims lists and ignores them.
  if (subscriptions_.takesLists() && !names.isEmpty()) subscribe_timer_->start(kSubscribeAnswerMs);
}

void AxbotLink::setBasics(const LiveTopics::Basics& basics) { subscriptions_.setBasics(basics); }

void AxbotLink::setWantedTopics(const QStringList& topics) {
  start();
  const QStringList requests = subscriptions_.setWanted(topics);
  // Before the first subscription everything is asked for with it, at once.
  if (subscribed_) send(requests);
}

void AxbotLink::send(const QStringList& requests) {
  for (const QString& request : requests) socket_->sendText(request);
}

void AxbotLink::takeText(const QByteArray& utf8) {
  TextFrame frame = topic_reader_.read(view(utf8));
  if (watching_ && raw_limit_.allow(clock_.elapsed(), utf8.size())) {
    Q_EMIT rawReceived(rawText(frame.topic, view(utf8)));
  }
  if (frame.message) {
    emitTopic(frame.topic, std::move(*frame.message));
  } else if (frame.grid_to_fetch) {
    grids_->fetch(std::move(*frame.grid_to_fetch));
  } else if (frame.enabled_topics) {
    const QStringList asked = subscriptions_.names();
    topics_confirmed_ |=
        std::any_of(frame.enabled_topics->begin(), frame.enabled_topics->end(),
                    [&](const std::string& name) { return asked.contains(QString::fromStdString(name)); });
  } else if (!frame.error.empty()) {
    Q_EMIT problemFound(
        problem(map::Severity::Warning,
                tr("It answered: %1").arg(QString::fromStdString(frame.error.substr(0, 300)))));
  }
}

void AxbotLink::takeBinary(const QByteArray& bytes) {
  if (watching_ && raw_limit_.allow(clock_.elapsed(), bytes.size()))
    Q_EMIT rawReceived(rawBinary(view(bytes)));
  if (auto message = parseBinaryFrame(view(bytes))) {
    emitTopic(topicOfBinaryFrame(view(bytes)), std::move(*message));
  }
}

void AxbotLink::emitTopic(const std::string& topic, map::TopicMessage message) {
  const auto recover = [this](const std::string& name) {
    if (unreadable_topics_.erase(name) > 0)
      Q_EMIT recovered({map::Subject(map::SubjectKind::Topic, name), map::ProblemCode::Unreadable});
  };
  if (const auto* unreadable = std::get_if<map::UnreadableMessage>(&message)) {
    unreadable_topics_.insert(unreadable->topic);
  } else if (!unreadable_topics_.empty()) {
    recover(topic);
    recover(kUnknownTopic);  // whatever it was, messages can be read again
  }
  if (std::holds_alternative<map::SubmapList>(message)) {
    topics_confirmed_ = true;
    list_timer_->stop();
  }
  if (!TopicMailbox::takes(message)) {
    Q_EMIT topicReceived(message);
  } else if (mailbox_->put(std::move(message))) {
    Q_EMIT mailArrived();
  }
}

MapRequests& AxbotLink::maps() {
  start();
  return *maps_;
}

void AxbotLink::fetch(quint64 ticket, const map::SubmapKey& key) {
  start();
  ask(ticket, key);
}

void AxbotLink::discard(const map::SubmapKey& key, std::int32_t answered_version) {
  start();
  http_->discard(submapUrl(key, key.version));
  if (answered_version > 0 && answered_version != key.version) {
    http_->discard(submapUrl(key, answered_version));
  }
}

void AxbotLink::discardPicture(const std::string& fingerprint) {
  start();
  maps_->discardPicture(fingerprint);
  grids_->discardPicture(fingerprint);
}

void AxbotLink::ask(quint64 ticket, const map::SubmapKey& key) {
  net::HttpRequest request;
  request.url = submapUrl(key, key.version);
  request.accept = "application/x-protobuf";
  request.cacheable = true;
  request.content_addressed = true;
  request.timeout = options_.fetch_timeout;
  under_way_[key] =
      http_->get(request, [this, key, ticket, url = request.url](const net::HttpAnswer& answer) {
        takeSubmap(key, url, answer, ticket);
      });
}

void AxbotLink::takeSubmap(const map::SubmapKey& key, const QUrl& url, const net::HttpAnswer& http,
                           quint64 ticket) {
  using Outcome = map::SubmapAnswer::Outcome;
  under_way_.erase(key);
  map::SubmapAnswer answer;
  if (http.ok()) {
    answer = parseSubmapResponse(key, view(http.body));
    if (http.from_cache && answer.outcome != Outcome::Ok) {
      // What lies on the disk is none of the robot's business: it is asked itself.
      http_->discard(url);
      ask(ticket, key);
      return;
    }
    answer.from_cache = http.from_cache;
    if (cache_ && !http.from_cache) {
      // The address names the version asked for; the body is the version that the robot has. Keep it under
      // its own name only, so that neither a failure nor an older picture is taken for that version after a
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
    answer.reason = http.sentence.toStdString();
    answer.failure = wire::failureOf(http);
    answer.outcome = http.kind == net::HttpAnswer::Kind::Cancelled ? Outcome::Cancelled
                     : http.status == 404                          ? Outcome::NotFound
                                                                   : Outcome::Failed;
  }
  Q_EMIT answered(ticket, answer);
}

void AxbotLink::cancel(const map::SubmapKey& key) {
  if (const auto it = under_way_.find(key); it != under_way_.end()) http_->cancel(it->second);
}

void AxbotLink::cancelAll() {
  const auto requests = under_way_;
  for (const auto& [key, id] : requests) http_->cancel(id);
}

QString AxbotLink::whyNot() const {
  if (socket_->fault() != net::WebSocketLink::Fault::NotAWebSocket) return socket_->reason();
  return tr("something answers at %1:%2, but not as an Autoxing robot: %3. Check the address and the port.")
      .arg(options_.base.host())
      .arg(options_.base.port())
      .arg(socket_->reason());
}

void AxbotLink::trust(const QByteArray& pinned_sha256) {
  start();
  options_.trust.pinned_sha256 = pinned_sha256;
  http_->setTrust(options_.trust);
  socket_->setTrust(options_.trust);
  open();
}

void AxbotLink::publishState() {
  using State = net::WebSocketLink::State;
  ConnectionState state;
  state.reason = whyNot();
  state.failure = failureOf(socket_->fault());
  if (const auto fault = socket_->certificate()) state.certificate = wire::untrusted(*fault);
  state.attempt = socket_->attempt();
  state.retry_in_ms = socket_->retryInMs();
  state.round_trip_ms = socket_->roundTripMs();
  switch (socket_->state()) {
    case State::Open:
      state.phase = ConnectionPhase::Online;
      state.reason.clear();
      state.failure = map::FailureKind::None;
      break;
    case State::Connecting:
      state.phase = state.attempt <= 1 ? ConnectionPhase::Connecting : ConnectionPhase::Interrupted;
      break;
    case State::Waiting:
      state.phase = ConnectionPhase::Interrupted;
      break;
    case State::Closed:
      state.phase = wanted_ ? ConnectionPhase::Refused : ConnectionPhase::Offline;
      if (!wanted_) state.reason.clear();
      if (wanted_ && (socket_->handshakeStatus() == 401 || socket_->handshakeStatus() == 403))
        state.failure = map::FailureKind::Refused;
      break;
  }
  Q_EMIT stateChanged(state);
}

}  // namespace mapwright::robot::axbot
