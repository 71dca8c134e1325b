#include "robot/aimdk/aimdk_link.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "net/plain_sentences.h"
#include "robot/aimdk/faults.h"
#include "robot/wire/failures.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::aimdk {
namespace {

Q_LOGGING_CATEGORY(lcAimdk, "mapwright.aimdk", QtWarningMsg)

constexpr const char* kMapNames = "aimdk.protocol.MappingService/GetStoredMapNames";
constexpr const char* kCurrentMap = "aimdk.protocol.MappingService/GetCurrentWorkingMap";
constexpr const char* kWholeMap = "aimdk.protocol.MappingService/Get2DWholeMap";
constexpr const char* kTopology = "aimdk.protocol.LocalizationService/GetTopoMsgs";
constexpr const char* kRealtimeMap = "aimdk.protocol.MappingService/GetRealtimeMapData";
constexpr qint64 kMaxAnswerBytes = qint64(384) << 20;  // 256 MB of picture as base64

bool knowsNoSuchCall(int status) { return status == 404 || status == 405 || status == 501; }

/// An answer from which nothing follows but that it may be asked again.
bool isLost(const net::HttpAnswer& answer) {
  const int status = answer.status;
  return answer.kind != net::HttpAnswer::Kind::Answered || status == 408 || status == 429 ||
         (status >= 500 && status != 501);
}

map::Subject catalogueSubject(const char* part) { return {map::SubjectKind::Catalogue, part}; }

/// The result, or why there is none.
template <typename T>
Outcome<T> outcomeOf(const net::HttpAnswer& answer, map::Subject subject, Read<T> read) {
  if (!answer.ok()) return fail(wire::failed(answer, std::move(subject)));
  if (!read) return fail(said(answer, std::move(subject), read.error()));
  return std::move(*read);
}

/// Why there is no list of maps, for the state of the connection.
Fault notListedReason(const RpcError& error) {
  if (!error.refused) return error.cause;
  std::vector<Fault> why;
  if (error.cause.any()) {
    why.push_back(error.cause);
  } else if (!error.detail.empty()) {
    why.push_back(fault::said(error.detail));
  }
  if (error.code.empty())
    return {faultText("aimdk", "The list cannot be loaded: the robot refused."), {}, std::move(why)};
  const int status = error.code.size() == 3 ? std::atoi(error.code.c_str()) : 0;
  if (status >= 300)
    return {faultText("aimdk", "The list cannot be loaded: the robot answered %1."),
            {HttpStatus{status}},
            std::move(why)};
  return {faultText("aimdk", "The list cannot be loaded: the robot refused (code %1)."),
          {error.code},
          std::move(why)};
}

map::Failure unasked(map::Subject subject, const char* ids) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = std::move(subject),
          .arguments = {ids},
          .reason = map::FailureReason::NoSuchId};
}

}  // namespace

map::Failure said(const net::HttpAnswer& answer, map::Subject subject, const RpcError& error) {
  qCInfo(lcAimdk, "%s %s: %s %s", error.refused ? "refused" : "unreadable answer", subject.id.c_str(),
         error.code.c_str(), inEnglish(error.cause).c_str());
  if (!error.refused)
    return wire::misread(answer, std::move(subject), error.cause, map::FailureReason::Unfit);
  return {.kind = map::FailureKind::RejectedByRobot,
          .subject = std::move(subject),
          .robot_code = error.code,
          .detail = error.detail,
          .cause = error.cause};
}

std::optional<map::Failure> notAccepted(const net::HttpAnswer& answer, map::Subject subject) {
  if (answer.kind == net::HttpAnswer::Kind::Answered && knowsNoSuchCall(answer.status)) {
    return map::Failure{
        .kind = map::FailureKind::Unsupported,
        .subject = std::move(subject),
        .asked_for = map::AskedFor::Change,
        .reason = map::FailureReason::Unfit,
        .cause = {
            faultText("aimdk", "Its firmware does not support this request (%1)."), {}, {answer.reason}}};
  }
  if (!answer.ok()) return wire::failed(answer, std::move(subject), map::AskedFor::Change);
  const auto accepted = parseAcceptance(wire::view(answer.body));
  if (accepted) return std::nullopt;
  map::Failure failure = said(answer, std::move(subject), accepted.error());
  failure.asked_for = map::AskedFor::Change;
  if (!accepted.error().refused) failure.applied = map::Applied::Maybe;
  return failure;
}

bool isFinal(const map::Failure& of_change) {
  return of_change.applied == map::Applied::No || of_change.kind == map::FailureKind::Cancelled;
}

AimdkLink::AimdkLink(LinkOptions options)
    : RobotLink(lcAimdk(), options.base),
      options_(std::move(options)),
      http_(options_.base, QByteArray(), nullptr),  // the interface knows no secret
      backoff_(options_.backoff_first, options_.backoff_limit, options_.jitter_seed),
      map_changes_(*this, options_.changes),
      point_changes_(*this, options_.changes) {
  http_.setTrust(options_.trust);
  for (QTimer* timer : {&timer_, &healthy_, &quiet_}) timer->setSingleShot(true);
  connect(&quiet_, &QTimer::timeout, this, &AimdkLink::onSilence);
  connect(&healthy_, &QTimer::timeout, this, [this] { backoff_.reset(); });
  connect(&timer_, &QTimer::timeout, this, [this] {
    if (phase_ == ConnectionPhase::Online) {
      poll();
    } else if (probing_ != 0) {
      goOnline();
    } else {
      attempt();
    }
  });
}

net::HttpRequest AimdkLink::request(const char* method, const QByteArray& body,
                                    std::chrono::milliseconds timeout) const {
  net::HttpRequest request;
  request.method = net::HttpMethod::Post;
  request.url = options_.base;
  request.url.setPath(options_.base.path() + QStringLiteral("/rpc/") + QLatin1String(method));
  request.body = body;
  request.timeout = timeout;
  request.max_bytes = kMaxAnswerBytes;
  return request;
}

void AimdkLink::ask(const char* method, const QByteArray& body, Reply reply) {
  asking_ = http_.send(request(method, body, options_.timeout), std::move(reply));
}

void AimdkLink::deliver(const char* method, const net::HttpAnswer& answer) {
  if (!answer.ok()) return;
  const std::string_view call = method;
  wire::DeliveryTapSlot::Parcel parcel =
      parcelOf("/aimdk/" + std::string(call.substr(call.rfind('/') + 1)),
               std::make_shared<const std::string>(answer.body.toStdString()), options_.wall_s());
  parcel.encoding = "json";
  parcel.slot = parcel.name;
  outputs_->deliveries.pass(std::move(parcel));
}

void AimdkLink::open() {
  wanted_ = true;
  if (phase_ == ConnectionPhase::Online || asking_ != 0 || probing_ != 0) return;
  attempt();
}

void AimdkLink::trust(const QByteArray& pinned_sha256) {
  options_.trust.pinned_sha256 = pinned_sha256;
  http_.setTrust(options_.trust);
  open();
}

void AimdkLink::close() {
  wanted_ = false;
  timer_.stop();
  healthy_.stop();
  quiet_.stop();
  http_.cancelAll();
  asking_ = probing_ = 0;
  attempt_ = 0;
  backoff_.reset();
  silent_since_.reset();
  heard_at_ = {};
  enter(ConnectionPhase::Offline);
}

void AimdkLink::hear() {
  heard_at_ = QDateTime::currentDateTime();
  silent_since_.reset();
}

void AimdkLink::onSilence() {
  if (phase_ != ConnectionPhase::Online || asking_ == 0 || !heard_at_.isValid()) return;
  silent_since_ = heard_at_;
  enter(phase_);
}

void AimdkLink::attempt() {
  timer_.stop();
  ++attempt_;
  enter(attempt_ == 1 ? ConnectionPhase::Connecting : ConnectionPhase::Interrupted);
  ask(kMapNames, mapNamesRequest(), [this](const net::HttpAnswer& answer) {
    if (answer.kind == net::HttpAnswer::Kind::Cancelled) return;
    asking_ = 0;
    deliver(kMapNames, answer);
    const auto maps = parseMapNames(wire::view(answer.body));
    if (answer.ok() && maps) {
      hear();
      probe();
    } else if (answer.ok()) {
      // The server answers every request with success. JSON may come from a robot with a problem of its own.
      const bool json = answer.body.trimmed().startsWith('{');
      const auto kind = said(answer, catalogueSubject(map::kMapsPart), maps.error()).kind;
      interrupt(notListedReason(maps.error()), json ? kind : map::FailureKind::NotARobot);
    } else if (answer.kind == net::HttpAnswer::Kind::Answered && knowsNoSuchCall(answer.status)) {
      interrupt({fault::NoAgibotRobotThere, {}, {answer.reason}}, map::FailureKind::NotARobot);
    } else {
      interrupt(answer);
    }
  });
}

void AimdkLink::probe() {
  if (phase_ != ConnectionPhase::Online) timer_.start(options_.quiet_after);
  probing_ = http_.send(request(kRealtimeMap, realtimeMapRequest(), options_.map_timeout),
                        [this](const net::HttpAnswer& answer) {
                          if (answer.kind == net::HttpAnswer::Kind::Cancelled) return;
                          probing_ = 0;
                          onProbe(answer);
                          if (phase_ != ConnectionPhase::Online) goOnline();
                        });
}

void AimdkLink::onProbe(const net::HttpAnswer& answer) {
  const bool online = phase_ == ConnectionPhase::Online;
  if (isLost(answer)) return online ? probed_.start() : leaveUntold();
  const std::string_view body = wire::view(answer.body);
  NewerServices newer = newer_;
  // Who has them does not lose them while it is online.
  if (!online || newer.there != true) newer = {knowsService(answer.status, body)};
  if (const auto mapping = parseRealtimeMap(body); newer.there == true && answer.ok() && mapping)
    newer.mapping = *mapping;
  onNewerFirmware(newer);
}

void AimdkLink::leaveUntold() { onNewerFirmware({newer_.there == true ? newer_.there : std::nullopt}); }

void AimdkLink::onNewerFirmware(const NewerServices& newer) {
  probed_.start();
  if (newer_ == newer) return;
  newer_ = newer;
  qCInfo(lcAimdk, "newer services: %s", !newer.there ? "not told" : *newer.there ? "yes" : "no");
  Q_EMIT newerKnown(newer_);
}

void AimdkLink::goOnline() {
  if (probing_ != 0) leaveUntold();
  attempt_ = 0;
  // One answer is not health: a robot that answers and then fails must not be asked ever so often.
  healthy_.start(options_.healthy_after);
  enter(ConnectionPhase::Online);
  poll();
}

void AimdkLink::poll() {
  polled_.start();
  // One that needs long for its answers gets as long again.
  quiet_.start(std::max(options_.quiet_after, 2 * slowest_));
  ask(kCurrentMap, currentMapRequest(), [this](const net::HttpAnswer& answer) {
    if (answer.kind == net::HttpAnswer::Kind::Cancelled) return;
    asking_ = 0;
    quiet_.stop();
    deliver(kCurrentMap, answer);
    // Even an error shows that the robot is there: it may have no map in use.
    if (answer.kind != net::HttpAnswer::Kind::Answered) {
      interrupt(answer);
      return;
    }
    slowest_ = std::max(std::chrono::milliseconds(polled_.elapsed()), slowest_ * 7 / 8);
    const bool was_silent = silent_since_.has_value();
    hear();
    if (was_silent) enter(phase_);
    if (answer.ok()) updateCurrent(parseCurrentMap(wire::view(answer.body)).value_or(std::string()));
    const bool told = newer_.there && (newer_.mapping || !*newer_.there);
    const auto again = told ? options_.mapping_every : options_.probe_again;
    if (newer_.there != false && probing_ == 0 && probed_.hasExpired(again.count())) probe();
    timer_.start(options_.poll_every);
  });
}

void AimdkLink::post(const wire::TaskPtr& task, const char* method, const QByteArray& body, Reply reply) {
  wire::send(task, http_, request(method, body, options_.timeout), std::move(reply));
}

void AimdkLink::lookAtMapping(const wire::TaskPtr& task, OutcomeTo<bool> reply) {
  post(task, kRealtimeMap, realtimeMapRequest(),
       [this, reply = std::move(reply)](const net::HttpAnswer& answer) {
         auto mapping = outcomeOf(answer, wire::kMapList, parseRealtimeMap(wire::view(answer.body)));
         if (mapping) onNewerFirmware({newer_.there, *mapping});
         reply(std::move(mapping));
       });
}

void AimdkLink::updateCurrent(const std::string& id) {
  const bool changed = current_ && *current_ != id;
  if (current_ != id) qCDebug(lcAimdk, "map in use: %s", id.empty() ? "none" : id.c_str());
  current_ = id;
  if (changed) Q_EMIT currentMapChanged();
}

void AimdkLink::interrupt(const net::HttpAnswer& answer) {
  if (answer.certificate) certificate_ = wire::untrusted(*answer.certificate);
  interrupt(answer.reason, wire::failureOf(answer));
}

void AimdkLink::interrupt(const Fault& reason, map::FailureKind failure) {
  if (!wanted_) return;
  healthy_.stop();
  quiet_.stop();
  http_.cancel(std::exchange(probing_, 0));
  if (heard_at_.isValid()) silent_since_ = heard_at_;
  if (failure != map::FailureKind::Certificate) certificate_.reset();
  reason_ = reason;
  failure_ = failure;
  // A refusal does not go away by retrying.
  if (failure == map::FailureKind::Refused || failure == map::FailureKind::Certificate) {
    timer_.stop();
    enter(ConnectionPhase::Refused);
    return;
  }
  const auto wait = backoff_.next();
  timer_.start(wait);
  enter(ConnectionPhase::Interrupted, int(wait.count()));
}

void AimdkLink::enter(ConnectionPhase phase, std::optional<int> retry_in_ms) {
  phase_ = phase;
  if (phase == ConnectionPhase::Online || phase == ConnectionPhase::Offline) {
    reason_ = {};
    failure_ = map::FailureKind::None;
    certificate_.reset();
  }
  ConnectionState state;
  state.phase = phase;
  state.reason = reason_;  // while retrying: why the last attempt failed
  state.failure = failure_;
  state.certificate = certificate_;
  state.attempt = attempt_;
  state.retry_in_ms = retry_in_ms;
  link_log_.record(state);
  Q_EMIT silenceChanged(silent_since_.value_or(QDateTime()));
  Q_EMIT stateChanged(state);
}

void AimdkLink::list(wire::TaskPtr task, OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  wire::send(task, http_, request(kMapNames, mapNamesRequest(), options_.timeout),
             [this, task, reply](const net::HttpAnswer& answer) {
               deliver(kMapNames, answer);
               std::int64_t left_out = 0;
               auto maps = outcomeOf(answer, catalogueSubject(map::kMapsPart),
                                     parseMapNames(wire::view(answer.body), &left_out));
               if (!maps) {
                 reply(fail(maps.error()));
                 return;
               }
               const map::ProblemCode code = map::ProblemCode::Odd;
               const bool were_left_out = std::exchange(maps_left_out_, left_out > 0);
               if (left_out > 0) {
                 Q_EMIT problemFound({map::Severity::Warning, catalogueSubject(map::kMapsPart),
                                      Fault(fault::MapsWithoutId, {left_out}), code});
               } else if (were_left_out) {
                 Q_EMIT recovered({catalogueSubject(map::kMapsPart), code});
               }
               wire::send(task, http_, request(kCurrentMap, currentMapRequest(), options_.timeout),
                          [this, reply, entries = std::move(*maps)](const net::HttpAnswer& current) mutable {
                            deliver(kCurrentMap, current);
                            const auto id = outcomeOf(current, catalogueSubject(map::kCurrentMapPart),
                                                      parseCurrentMap(wire::view(current.body)));
                            if (!id && id.error().kind == map::FailureKind::Cancelled) {
                              reply(fail(id.error()));
                              return;
                            }
                            if (!id) {
                              Q_EMIT problemFound(map::problemOf(id.error(), map::Severity::Warning));
                            } else {
                              Q_EMIT recovered({catalogueSubject(map::kCurrentMapPart)});
                              for (map::CatalogueEntry& entry : entries)
                                entry.is_current = !id->empty() && entry.key.id == *id;
                              updateCurrent(*id);
                            }
                            reply(std::move(entries));
                          });
             });
}

// There is no question for one map alone that does not send its picture.
void AimdkLink::describe(wire::TaskPtr task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  list(std::move(task), [key, reply = std::move(reply)](Outcome<std::vector<map::CatalogueEntry>> entries) {
    reply(wire::entryOf(key, std::move(entries)));
  });
}

void AimdkLink::fetchParsed(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<ParsedMap> reply) {
  if (key.kind != map::MapKind::Stored || key.id.empty()) {
    reply(fail(unasked(map::subjectOf(key), "1764059676131")));
    return;
  }
  std::shared_ptr<SharedFetch>& entry = fetching_[key];
  const bool first = !entry;
  if (first) entry = std::make_shared<SharedFetch>(SharedFetch{std::make_shared<wire::Task>(), {}});
  const std::shared_ptr<SharedFetch> shared = entry;
  const int number = task->begun([this, key, held = std::weak_ptr(shared), who = task.get()] {
    const std::shared_ptr<SharedFetch> fetch = held.lock();
    if (!fetch) return;
    // It has already been answered.
    std::erase_if(fetch->waiting, [&](const auto& one) { return one.first.get() == who; });
    if (!fetch->waiting.empty()) return;
    leave(key, fetch);
    fetch->task->cancel();
  });
  shared->waiting.emplace_back(task, [task, number, reply = std::move(reply)](Outcome<ParsedMap> parsed) {
    task->ended(number);
    reply(std::move(parsed));
  });
  if (!first) return;
  wire::send(shared->task, http_, request(kWholeMap, wholeMapRequest(key.id), options_.map_timeout),
             [this, key, shared](const net::HttpAnswer& answer) {
               auto parsed =
                   outcomeOf(answer, map::subjectOf(key), parseWholeMap(wire::view(answer.body), key));
               if (parsed) {
                 parsed->map.body_bytes = std::size_t(answer.body.size());
                 return placeFetched(key, shared, std::move(*parsed));
               }
               endFetch(key, shared, parsed);
             });
}

/// Its points tell how its resolution is meant. Without them it is shown all the same.
void AimdkLink::placeFetched(const map::MapKey& key, const std::shared_ptr<SharedFetch>& shared,
                             ParsedMap parsed) {
  wire::send(shared->task, http_, request(kTopology, topologyRequest(key.id), options_.timeout),
             [this, key, shared, parsed = std::move(parsed)](const net::HttpAnswer& answer) mutable {
               deliver(kTopology, answer);
               fetched_topology_.reset();
               if (answer.ok()) {
                 fetched_topology_ = FetchedTopology{key, answer, {}, {}};
                 fetched_topology_->since.start();
               }
               const auto topology = parseTopology(wire::view(answer.body), &parsed);
               place(parsed, answer.ok() && topology ? topology->scale : untoldScale(parsed));
               endFetch(key, shared, parsed);
             });
}

void AimdkLink::leave(const map::MapKey& key, const std::shared_ptr<SharedFetch>& shared) {
  if (const auto found = fetching_.find(key); found != fetching_.end() && found->second == shared)
    fetching_.erase(found);
}

void AimdkLink::endFetch(const map::MapKey& key, const std::shared_ptr<SharedFetch>& shared,
                         const Outcome<ParsedMap>& parsed) {
  leave(key, shared);
  if (parsed) {
    frame_ = *parsed;
    frame_->map.bytes.reset();
  }
  for (const auto& [who, waiting_reply] : std::exchange(shared->waiting, {})) waiting_reply(parsed);
}

void AimdkLink::fetch(wire::TaskPtr task, const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
  fetchParsed(task, key, [reply = std::move(reply)](Outcome<ParsedMap> parsed) {
    if (parsed) {
      reply(std::move(parsed->map));
    } else {
      reply(fail(parsed.error()));
    }
  });
}

void AimdkLink::waypoints(wire::TaskPtr task, const map::MapKey& key, OutcomeTo<map::WaypointList> reply) {
  topology(task, key, TopologyUse::Showing,
           [reply = std::move(reply)](Outcome<Topology> points, const ParsedMap*) {
             if (!points) return reply(fail(std::move(points.error())));
             reply(std::move(points->list));
           });
}

std::optional<net::HttpAnswer> AimdkLink::topologyAtHand(const map::MapKey& key, TopologyUse use) {
  constexpr qint64 kServesMs = 10'000;
  const bool serves = fetched_topology_ && use != TopologyUse::Changing && fetched_topology_->key == key &&
                      !fetched_topology_->since.hasExpired(kServesMs) &&
                      fetched_topology_->served.insert(use).second;
  return serves ? std::optional(fetched_topology_->answer) : std::nullopt;
}

void AimdkLink::topology(const wire::TaskPtr& task, const map::MapKey& key, TopologyUse use,
                         TopologyReply reply) {
  if (key.id.empty() || key.kind != map::MapKind::Stored) {
    reply(fail(unasked(map::placesOf(key), "1764059676131")), nullptr);
    return;
  }
  if (use == TopologyUse::Changing) fetched_topology_.reset();  // it becomes another one
  const auto ask = [this, task, key, use, reply = std::move(reply)] {
    const auto onAnswer = [this, key, reply](const net::HttpAnswer& answer) {
      const ParsedMap* frame = frame_ && frame_->map.key == key ? &*frame_ : nullptr;
      reply(outcomeOf(answer, map::placesOf(key), parseTopology(wire::view(answer.body), frame)), frame);
    };
    if (const auto at_hand = topologyAtHand(key, use)) return onAnswer(*at_hand);
    post(task, kTopology, topologyRequest(key.id), [this, onAnswer](const net::HttpAnswer& answer) {
      deliver(kTopology, answer);
      onAnswer(answer);
    });
  };
  if (frame_ && frame_->map.key == key) return ask();
  // Their pixels can be checked only once the map is known.
  fetchParsed(task, key, [ask](const Outcome<ParsedMap>&) { ask(); });
}

}  // namespace mapwright::robot::aimdk

#include "moc_aimdk_link.cpp"
