#include "robot/wire/robot_link.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace mapwright::robot::wire {
namespace {

std::string slotOf(const map::TopicMessage& message) {
  if (const auto* grid = std::get_if<map::GridMessage>(&message)) return grid->topic;
  if (const auto* cloud = std::get_if<map::PointCloudMessage>(&message)) return cloud->topic;
  if (std::holds_alternative<map::TrajectoryMessage>(message)) return "/trajectory";
  if (std::holds_alternative<map::ConstraintsMessage>(message)) return "/constraint_list";
  return {};
}

const char* nameOf(ConnectionPhase phase) {
  switch (phase) {
    case ConnectionPhase::Offline:
      return "offline";
    case ConnectionPhase::Connecting:
      return "connecting";
    case ConnectionPhase::Online:
      return "online";
    case ConnectionPhase::Interrupted:
      return "interrupted";
    case ConnectionPhase::Refused:
      break;
  }
  return "refused";
}

}  // namespace

bool TopicMailbox::takes(const map::TopicMessage& message) { return !slotOf(message).empty(); }

bool TopicMailbox::put(map::StampedMessage message) {
  std::string slot = slotOf(message.message);
  const std::lock_guard lock(mutex_);
  if (latest_.size() >= kTopics && !latest_.contains(slot)) return false;
  const bool was_empty = latest_.empty();
  if (!latest_.insert_or_assign(std::move(slot), std::move(message)).second) ++replaced_;
  return was_empty;
}

std::size_t TopicMailbox::replaced() const {
  const std::lock_guard lock(mutex_);
  return replaced_;
}

std::vector<map::StampedMessage> TopicMailbox::take() {
  std::map<std::string, map::StampedMessage> taken;
  {
    const std::lock_guard lock(mutex_);
    taken.swap(latest_);
  }
  std::vector<map::StampedMessage> messages;
  messages.reserve(taken.size());
  for (auto& [slot, message] : taken) messages.push_back(std::move(message));
  return messages;
}

void DeliveryTapSlot::set(DeliveryTap tap) {
  const std::lock_guard lock(mutex_);
  tap_ = std::move(tap);
  if (!tap_) return;
  std::vector<const Parcel*> parcels;
  for (const auto& [slot, held] : held_) parcels.push_back(&held.parcel);
  std::stable_sort(parcels.begin(), parcels.end(),
                   [](const Parcel* a, const Parcel* b) { return a->received_s < b->received_s; });
  for (const Parcel* parcel : parcels) hand(tap_, *parcel, true);
}

void DeliveryTapSlot::pass(Parcel parcel) {
  const std::lock_guard lock(mutex_);
  if (tap_) hand(tap_, parcel, false);
  if (!parcel.slot.empty()) hold(std::move(parcel));
}

bool DeliveryTapSlot::taken() const {
  const std::lock_guard lock(mutex_);
  return bool(tap_);
}

void DeliveryTapSlot::forget() {
  const std::lock_guard lock(mutex_);
  held_.clear();
  held_bytes_ = 0;
}

void DeliveryTapSlot::hand(const DeliveryTap& tap, const Parcel& parcel, bool before) {
  const std::optional<std::string_view> bytes = parcel.find ? parcel.find() : parcel.bytes;
  if (!bytes) return;
  Delivery delivery;
  delivery.kind = parcel.kind;
  delivery.name = parcel.name;
  delivery.encoding = parcel.encoding;
  delivery.schema = parcel.schema;
  delivery.submap = parcel.submap;
  delivery.bytes = *bytes;
  delivery.received_s = parcel.received_s;
  delivery.said_s = parcel.said_s;
  delivery.before = before;
  tap(delivery);
}

void DeliveryTapSlot::hold(Parcel parcel) {
  Held& held = held_[parcel.slot];
  held_bytes_ -= held.parcel.held_bytes;
  held_bytes_ += parcel.held_bytes;
  held.parcel = std::move(parcel);
  ++held.times;
  while (held_bytes_ > kMostHeldBytes || held_.size() > kMostSlots) {
    const auto first = std::max_element(held_.begin(), held_.end(), [](const auto& a, const auto& b) {
      return std::tie(a.second.times, a.second.parcel.held_bytes) <
             std::tie(b.second.times, b.second.parcel.held_bytes);
    });
    held_bytes_ -= first->second.parcel.held_bytes;
    held_.erase(first);
  }
}

void LinkLog::record(const ConnectionState& state) {
  const bool same = state.phase == last_.phase && state.reason == last_.reason;
  last_ = state;
  if (same) return;
  const std::string why = inEnglish(state.reason);
  const std::string next =
      state.retry_in_ms ? "; retry in " + std::to_string(*state.retry_in_ms) + " ms" : std::string();
  qCInfo(category_, "%s: %s%s%s%s", who_.c_str(), nameOf(state.phase), why.empty() ? "" : ": ", why.c_str(),
         next.c_str());
}

void LinkLog::record(const Fault& fault) {
  qCInfo(category_, "%s: %s", who_.c_str(), inEnglish(fault).c_str());
}

double secondsOfDay() { return double(QDateTime::currentMSecsSinceEpoch()) / 1000; }

std::string hostOf(const QUrl& url) {
  return QStringLiteral("%1:%2").arg(url.host()).arg(url.port()).toStdString();
}

RobotLink::RobotLink(const QLoggingCategory& log, const QUrl& server, const QByteArray& secret)
    : server_(hostOf(server)), unsaid_(secret), link_log_(log, server_) {
  clock_.start();
}

void RobotLink::report(map::Severity severity, Fault reason) {
  link_log_.record(reason);
  Q_EMIT problemFound({severity, map::Subject(map::SubjectKind::Robot, server_), std::move(reason)});
}

bool RobotLink::passesRaw(qint64 bytes) { return watching_ && raw_limit_.allow(clock_.elapsed(), bytes); }

void RobotLink::pass(map::StampedMessage message) {
  if (!TopicMailbox::takes(message.message)) {
    Q_EMIT topicReceived(message);
  } else if (outputs_->mailbox.put(std::move(message))) {
    Q_EMIT mailArrived();
  }
}

DeliveryTapSlot::Parcel RobotLink::parcelOf(std::string name, std::shared_ptr<const std::string> body,
                                            double received_s) {
  DeliveryTapSlot::Parcel parcel;
  parcel.name = std::move(name);
  parcel.bytes = *body;
  parcel.held_bytes = body->size();
  parcel.keeps = std::move(body);
  parcel.received_s = received_s;
  return parcel;
}

}  // namespace mapwright::robot::wire

#include "moc_robot_link.cpp"
