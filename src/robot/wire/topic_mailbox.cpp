#include "robot/wire/topic_mailbox.h"

namespace mapwright::robot::wire {
namespace {

std::string slotOf(const map::TopicMessage& message) {
  if (const auto* grid = std::get_if<map::GridMessage>(&message)) return grid->topic;
  if (const auto* cloud = std::get_if<map::PointCloudMessage>(&message)) return cloud->topic;
  if (std::holds_alternative<map::TrajectoryMessage>(message)) return "/trajectory";
  if (std::holds_alternative<map::ConstraintsMessage>(message)) return "/constraint_list";
  return {};
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

}  // namespace mapwright::robot::wire
