#include "robot/ros/live_map.h"

#include <utility>

#include <QPointer>

#include "robot/ros/faults.h"
#include "robot/ros/ros_calls.h"
#include "robot/wire/faults.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::CallAnswer;

map::WholeMap wholeMap(const map::GridMessage& grid, const map::MapKey& key, const std::string& name) {
  map::WholeMap map;
  map.key = key;
  map.name = name;
  map.grid = grid.grid;
  map.reading = grid.reading;
  map.bytes = grid.png;
  map.body_bytes = grid.png ? grid.png->size() : 0;
  map.fingerprint = grid.fingerprint;
  return map;
}

Fault unavailableReason(const CallAnswer& answer) {
  if (answer.kind == CallAnswer::Kind::TimedOut) return fault::NoAnswerInTime;
  if (answer.kind == CallAnswer::Kind::LinkLost) return fault::LinkBrokeOff;
  if (!answer.words.empty()) return fault::said(answer.words.substr(0, 300));
  return robot::wire::fault::AnswerIsNoMap;
}

}  // namespace

void LiveMap::onGrid(const map::GridMessage& grid) {
  last_ = grid;
  waits_.look();
  Q_EMIT came();
}

std::shared_ptr<void> LiveMap::listen() {
  if (std::shared_ptr<void> held = listeners_.lock()) return held;
  const std::shared_ptr<void> made(static_cast<void*>(this), [self = QPointer<LiveMap>(this)](void*) {
    if (self) Q_EMIT self->wantedChanged();
  });
  listeners_ = made;
  Q_EMIT wantedChanged();
  return made;
}

void LiveMap::fetch(const wire::TaskPtr& task, const map::MapKey& key, const std::string& name,
                    OutcomeTo<map::WholeMap> reply, std::chrono::milliseconds longer) {
  waits_.await(
      task, timeout_ + longer, [this] { return last_.has_value(); },
      [this, key, name, reply = std::move(reply)](wire::WaitList::End how) {
        if (how == wire::WaitList::End::Held) {
          reply(wholeMap(*last_, key, name));
        } else {
          reply(fail(failed(how, map::subjectOf(key), fault::NoAnswerInTime, fault::LinkBrokeOff)));
        }
        Q_EMIT wantedChanged();
      });
  Q_EMIT wantedChanged();
}

MapFromService::MapFromService(net::rosbridge::Client& client, Timeouts timeouts)
    : client_(client), timeouts_(timeouts) {
  timer_.setParent(this);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] {
    next_ = 0;
    first_why_.reset();
    ask();
  });
}

void MapFromService::want(bool wanted, bool by_topic, Services services) {
  const bool same = wanted == wanted_ && by_topic == by_topic_ && services == services_;
  if (same) return;
  const bool others = services.names != services_.names;
  wanted_ = wanted;
  by_topic_ = by_topic;
  services_ = std::move(services);
  if (!wanted_ || services_.names.empty()) return stop();
  if (others) stop();
  if (had_ || call_ || timer_.isActive()) return;
  timer_.start(by_topic_ ? timeouts_.silence : std::chrono::milliseconds(0));
}

void MapFromService::ask() {
  const std::string service = services_.names.at(next_);
  net::rosbridge::CallRequest request;
  request.service = service;
  request.timeout = timeouts_.answer;
  request.large = true;
  call_ = client_.call(std::move(request),
                       [self = QPointer<MapFromService>(this), service](const CallAnswer& answer) {
                         if (self && answer.kind != CallAnswer::Kind::Cancelled)
                           self->onAnswer(service, answer);
                       });
}

void MapFromService::onAnswer(const std::string& service, const CallAnswer& answer) {
  call_.reset();
  if (!wanted_ || had_) return;
  if (answer.kind == CallAnswer::Kind::Answered && answer.values["map"].isObject()) {
    had_ = true;
    Q_EMIT came(service, answer);
    return;
  }
  if (!first_why_) first_why_.emplace(service, unavailableReason(answer));
  if (++next_ < services_.names.size()) return ask();
  timer_.start(timeouts_.again);
  if (services_.known) Q_EMIT failed(first_why_->first, first_why_->second);
}

void MapFromService::heard() {
  had_ = true;
  stop();
}

void MapFromService::beginAnew() {
  had_ = false;
  wanted_ = false;
  stop();
}

void MapFromService::stop() {
  timer_.stop();
  if (const auto call = std::exchange(call_, std::nullopt)) client_.cancel(*call);
}

}  // namespace mapwright::robot::ros

#include "moc_live_map.cpp"
