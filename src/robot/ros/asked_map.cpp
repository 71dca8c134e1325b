#include "robot/ros/asked_map.h"

#include <utility>

#include <QPointer>

#include "robot/ros/faults.h"
#include "robot/wire/faults.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::CallAnswer;

Fault whyNot(const CallAnswer& answer) {
  if (answer.kind == CallAnswer::Kind::TimedOut) return fault::NoAnswerInTime;
  if (answer.kind == CallAnswer::Kind::LinkLost) return fault::LinkBrokeOff;
  if (!answer.words.empty()) return fault::said(answer.words.substr(0, 300));
  return robot::wire::fault::AnswerIsNoMap;
}

}  // namespace

AskedMap::AskedMap(net::rosbridge::Client& client, Patience patience) : client_(client), patience_(patience) {
  timer_.setParent(this);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] {
    next_ = 0;
    first_why_.reset();
    ask();
  });
}

void AskedMap::want(bool wanted, bool by_topic, Services services) {
  const bool same = wanted == wanted_ && by_topic == by_topic_ && services == services_;
  if (same) return;
  const bool others = services.names != services_.names;
  wanted_ = wanted;
  by_topic_ = by_topic;
  services_ = std::move(services);
  if (!wanted_ || services_.names.empty()) return stop();
  if (others) stop();
  begin();
}

void AskedMap::begin() {
  if (!wanted_ || had_ || call_ || timer_.isActive() || services_.names.empty()) return;
  timer_.start(by_topic_ ? patience_.silence : std::chrono::milliseconds(0));
}

void AskedMap::ask() {
  const std::string service = services_.names.at(next_);
  net::rosbridge::CallRequest request;
  request.service = service;
  request.timeout = patience_.answer;
  request.large = true;
  call_ =
      client_.call(std::move(request), [self = QPointer<AskedMap>(this), service](const CallAnswer& answer) {
        if (self && answer.kind != CallAnswer::Kind::Cancelled) self->take(service, answer);
      });
}

void AskedMap::take(const std::string& service, const CallAnswer& answer) {
  call_.reset();
  if (!wanted_ || had_) return;
  if (answer.kind == CallAnswer::Kind::Answered && answer.values["map"].isObject()) {
    had_ = true;
    Q_EMIT came(service, answer);
    return;
  }
  if (!first_why_) first_why_.emplace(service, whyNot(answer));
  if (++next_ < services_.names.size()) return ask();
  timer_.start(patience_.again);
  if (services_.known) Q_EMIT failed(first_why_->first, first_why_->second);
}

void AskedMap::heard() {
  had_ = true;
  stop();
}

void AskedMap::beginAnew() {
  had_ = false;
  wanted_ = false;
  stop();
}

void AskedMap::stop() {
  timer_.stop();
  if (const auto call = std::exchange(call_, std::nullopt)) client_.cancel(*call);
}

}  // namespace mapwright::robot::ros

#include "moc_asked_map.cpp"
