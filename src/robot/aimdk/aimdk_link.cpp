#include "robot/aimdk/aimdk_link.h"

#include <utility>

#include "robot/wire/http_failure.h"
#include "words/sentences.h"

namespace mapwright::robot::aimdk {
namespace {

constexpr const char* kMapNames = "aimdk.protocol.MappingService/GetStoredMapNames";
constexpr const char* kCurrentMap = "aimdk.protocol.MappingService/GetCurrentWorkingMap";
constexpr const char* kWholeMap = "aimdk.protocol.MappingService/Get2DWholeMap";
constexpr const char* kTopology = "aimdk.protocol.LocalizationService/GetTopoMsgs";
constexpr qint64 kMaxAnswerBytes = qint64(384) << 20;  // 256 MB of picture as base64

std::string_view view(const QByteArray& bytes) { return {bytes.constData(), std::size_t(bytes.size())}; }

std::string because(const char* what, const net::HttpAnswer& answer) {
  return words::because(what, answer.sentence.toStdString());
}

bool knowsNoSuchCall(int status) { return status == 404 || status == 405 || status == 501; }

map::Subject catalogueSubject(const char* part) { return {map::SubjectKind::Catalogue, part}; }

map::Problem problem(map::Subject subject, std::string sentence, map::FailureKind failure) {
  return {map::Severity::Error, std::move(subject), std::move(sentence), map::ProblemCode::Unavailable,
          failure};
}

}  // namespace

AimdkLink::AimdkLink(LinkOptions options)
    : options_(std::move(options)),
      backoff_(options_.backoff_first, options_.backoff_limit, options_.jitter_seed) {}

AimdkLink::~AimdkLink() = default;

void AimdkLink::start() {
  if (http_) return;
  // The interface knows no secret.
  http_ = std::make_unique<net::HttpClient>(options_.base, QByteArray(), nullptr);
  http_->setTrust(options_.trust);
  timer_ = std::make_unique<QTimer>();
  healthy_ = std::make_unique<QTimer>();
  for (QTimer* timer : {timer_.get(), healthy_.get()}) timer->setSingleShot(true);
  connect(healthy_.get(), &QTimer::timeout, this, [this] { backoff_.reset(); });
  connect(timer_.get(), &QTimer::timeout, this, [this] {
    if (phase_ == ConnectionPhase::Online) {
      poll();
    } else {
      attempt();
    }
  });
}

net::HttpClient::RequestId AimdkLink::call(const char* method, const QByteArray& body,
                                           std::chrono::milliseconds patience, Taken taken) {
  start();
  net::HttpRequest request;
  request.url = options_.base;
  request.url.setPath(options_.base.path() + QStringLiteral("/rpc/") + QLatin1String(method));
  request.body = body;
  request.timeout = patience;
  request.max_bytes = kMaxAnswerBytes;
  return http_->post(request, std::move(taken));
}

void AimdkLink::open() {
  start();
  wanted_ = true;
  if (phase_ == ConnectionPhase::Online || asking_ != 0) return;
  attempt();
}

void AimdkLink::trust(const QByteArray& pinned_sha256) {
  start();
  options_.trust.pinned_sha256 = pinned_sha256;
  http_->setTrust(options_.trust);
  open();
}

void AimdkLink::close() {
  wanted_ = false;
  if (http_) {
    timer_->stop();
    healthy_->stop();
    http_->cancelAll();
  }
  asking_ = 0;
  attempt_ = 0;
  backoff_.reset();
  enter(ConnectionPhase::Offline);
}

void AimdkLink::attempt() {
  timer_->stop();
  ++attempt_;
  enter(attempt_ == 1 ? ConnectionPhase::Connecting : ConnectionPhase::Interrupted);
  asking_ = call(kMapNames, mapNamesRequest(), options_.patience, [this](const net::HttpAnswer& answer) {
    if (answer.kind == net::HttpAnswer::Kind::Cancelled) return;
    asking_ = 0;
    const auto maps = parseMapNames(view(answer.body));
    if (answer.ok() && maps) {
      goOnline();
    } else if (answer.ok()) {
      // Something answers every question with success. JSON may come from a robot that has a trouble of its
      // own.
      const bool json = answer.body.trimmed().startsWith('{');
      interrupt(QString::fromStdString(maps.error()),
                json ? map::FailureKind::MalformedAnswer : map::FailureKind::NotARobot);
    } else if (answer.kind == net::HttpAnswer::Kind::Answered && knowsNoSuchCall(answer.status)) {
      interrupt(
          tr("a web server answers there, but it knows no calls of Agibot robots (%1): check the address "
             "and the port")
              .arg(answer.sentence),
          map::FailureKind::NotARobot);
    } else {
      interrupt(answer);
    }
  });
}

void AimdkLink::goOnline() {
  attempt_ = 0;
  // One answer is not health: a robot that answers and then fails must not be asked ever so often.
  healthy_->start(options_.healthy_after);
  enter(ConnectionPhase::Online);
  poll();
}

void AimdkLink::poll() {
  asking_ = call(kCurrentMap, currentMapRequest(), options_.patience, [this](const net::HttpAnswer& answer) {
    if (answer.kind == net::HttpAnswer::Kind::Cancelled) return;
    asking_ = 0;
    // An answer with an error is a sign of life: the robot may have no map in use.
    if (answer.kind != net::HttpAnswer::Kind::Answered) {
      interrupt(answer);
      return;
    }
    if (answer.ok()) noteCurrent(parseCurrentMap(view(answer.body)).value_or(std::string()));
    timer_->start(options_.poll_every);
  });
}

void AimdkLink::noteCurrent(const std::string& id) {
  const bool changed = current_ && *current_ != id;
  current_ = id;
  if (changed) Q_EMIT currentMapChanged();
}

void AimdkLink::interrupt(const net::HttpAnswer& answer) {
  if (answer.certificate) certificate_ = wire::untrusted(*answer.certificate);
  interrupt(answer.sentence, wire::failureOf(answer));
}

void AimdkLink::interrupt(const QString& reason, map::FailureKind failure) {
  if (!wanted_) return;
  healthy_->stop();
  if (failure != map::FailureKind::Certificate) certificate_.reset();
  reason_ = reason;
  failure_ = failure;
  // A refusal does not go away by asking again.
  if (failure == map::FailureKind::Refused || failure == map::FailureKind::Certificate) {
    timer_->stop();
    enter(ConnectionPhase::Refused);
    return;
  }
  const auto wait = backoff_.next();
  timer_->start(wait);
  enter(ConnectionPhase::Interrupted, int(wait.count()));
}

void AimdkLink::enter(ConnectionPhase phase, std::optional<int> retry_in_ms) {
  phase_ = phase;
  if (phase == ConnectionPhase::Online || phase == ConnectionPhase::Offline) {
    reason_.clear();
    failure_ = map::FailureKind::None;
    certificate_.reset();
  }
  ConnectionState state;
  state.phase = phase;
  state.reason = reason_;  // while trying again: why the try before failed
  state.failure = failure_;
  state.certificate = certificate_;
  state.attempt = attempt_;
  state.retry_in_ms = retry_in_ms;
  Q_EMIT stateChanged(state);
}

void AimdkLink::list(AnswerTo<std::vector<map::CatalogueEntry>> reply) {
  call(kMapNames, mapNamesRequest(), options_.patience, [this, reply](const net::HttpAnswer& answer) {
    if (!answer.ok()) {
      reply(tl::make_unexpected(problem(catalogueSubject("Maps"), because("The list cannot be had: ", answer),
                                        wire::failureOf(answer))));
      return;
    }
    auto maps = parseMapNames(view(answer.body));
    if (!maps) {
      reply(tl::make_unexpected(problem(catalogueSubject("Maps"), maps.error(), wire::unreadable(answer))));
      return;
    }
    call(kCurrentMap, currentMapRequest(), options_.patience,
         [this, reply, entries = std::move(*maps)](const net::HttpAnswer& current) mutable {
           const auto id = parseCurrentMap(view(current.body));
           if (!current.ok() || !id) {
             map::Problem found =
                 problem(catalogueSubject("Current map"),
                         current.ok() ? id.error() : because("Which map is in use cannot be told: ", current),
                         current.ok() ? wire::unreadable(current) : wire::failureOf(current));
             found.severity = map::Severity::Warning;
             Q_EMIT problemFound(found);
           } else {
             Q_EMIT recovered({catalogueSubject("Current map")});
             for (map::CatalogueEntry& entry : entries)
               entry.is_current = !id->empty() && entry.key.id == *id;
             noteCurrent(*id);
           }
           reply(std::move(entries));
         });
  });
}

void AimdkLink::fetchParsed(const map::MapKey& key, AnswerTo<ParsedMap> reply) {
  if (key.kind != map::MapKind::Stored || key.id.empty()) {
    reply(tl::make_unexpected(problem(map::subjectOf(key), "Only stored maps can be asked for, by their id.",
                                      map::FailureKind::None)));
    return;
  }
  auto& waiting = fetching_[key];
  waiting.push_back(std::move(reply));
  if (waiting.size() > 1) return;
  call(kWholeMap, wholeMapRequest(key.id), options_.map_patience, [this, key](const net::HttpAnswer& answer) {
    Answer<ParsedMap> result = tl::make_unexpected(map::Problem{});
    if (!answer.ok()) {
      result = tl::make_unexpected(
          problem(map::subjectOf(key), because("It cannot be had: ", answer), wire::failureOf(answer)));
    } else if (auto parsed = parseWholeMap(view(answer.body), key)) {
      parsed->map.body_bytes = std::size_t(answer.body.size());
      result = std::move(*parsed);
      frame_ = *result;
      frame_->map.bytes.reset();
    } else {
      result = tl::make_unexpected(problem(map::subjectOf(key), parsed.error(), wire::unreadable(answer)));
    }
    const auto replies = std::move(fetching_.extract(key).mapped());
    for (const auto& waiting_reply : replies) waiting_reply(result);
  });
}

void AimdkLink::fetch(const map::MapKey& key, AnswerTo<map::WholeMap> reply) {
  fetchParsed(key, [reply = std::move(reply)](Answer<ParsedMap> parsed) {
    if (parsed) {
      reply(std::move(parsed->map));
    } else {
      reply(tl::make_unexpected(parsed.error()));
    }
  });
}

void AimdkLink::waypoints(const map::MapKey& key, AnswerTo<map::WaypointList> reply) {
  const auto body = topologyRequest(key.id);
  if (!body || key.kind != map::MapKind::Stored) {
    reply(tl::make_unexpected(problem(map::placesOf(key),
                                      "Its points cannot be asked for: its id is not a whole number.",
                                      map::FailureKind::None)));
    return;
  }
  if (frame_ && frame_->map.key == key) {
    askPoints(key, *body, std::move(reply));
    return;
  }
  // Their pixels can be checked only once the map that they are counted on is known.
  fetchParsed(key, [this, key, body = *body, reply = std::move(reply)](const Answer<ParsedMap>&) {
    askPoints(key, body, reply);
  });
}

void AimdkLink::askPoints(const map::MapKey& key, const QByteArray& body, AnswerTo<map::WaypointList> reply) {
  call(kTopology, body, options_.patience,
       [this, key, reply = std::move(reply)](const net::HttpAnswer& answer) {
         if (!answer.ok()) {
           reply(tl::make_unexpected(problem(
               map::placesOf(key), because("Its points cannot be had: ", answer), wire::failureOf(answer))));
           return;
         }
         const ParsedMap* frame = frame_ && frame_->map.key == key ? &*frame_ : nullptr;
         auto points = parseTopology(view(answer.body), frame);
         if (points) {
           reply(std::move(*points));
         } else {
           reply(tl::make_unexpected(problem(map::placesOf(key), points.error(), wire::unreadable(answer))));
         }
       });
}

}  // namespace mapwright::robot::aimdk
