#include "robot/axbot/topic_subscriptions.h"

#include <utility>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace mapwright::robot::axbot {
namespace {

constexpr qsizetype kLongestName = 256;

}  // namespace

QStringList TopicSubscriptions::always() const {
  QStringList topics;
  if (basics_.submaps) topics << QStringLiteral("/submap_list");
  if (basics_.pose) topics << QStringLiteral("/tracked_pose") << QStringLiteral("/robot_model");
  if (basics_.state) topics << QStringLiteral("/slam/state");
  return topics;
}

QStringList TopicSubscriptions::setWanted(const QStringList& topics) {
  QStringList wanted;
  for (const QString& topic : topics) {
    const bool usable = !topic.isEmpty() && topic.size() <= kLongestName;
    if (usable && !always().contains(topic) && !wanted.contains(topic)) wanted << topic;
  }
  const auto without = [](QStringList some, const QStringList& others) {
    some.removeIf([&](const QString& topic) { return others.contains(topic); });
    return some;
  };
  const QStringList before = std::exchange(wanted_, wanted);
  return requests("disable_topic", without(before, wanted)) +
         requests("enable_topic", without(wanted, before));
}

QStringList TopicSubscriptions::all() const { return requests("enable_topic", names()); }

QStringList TopicSubscriptions::anew(const QStringList& topics) const {
  return requests("disable_topic", topics) + requests("enable_topic", topics);
}

QStringList TopicSubscriptions::requests(const char* verb, const QStringList& topics) const {
  QStringList texts;
  const auto add = [&](const QJsonValue& value) {
    const QJsonObject request{{QLatin1String(verb), value}};
    texts << QString::fromUtf8(QJsonDocument(request).toJson(QJsonDocument::Compact));
  };
  if (topics.isEmpty()) return texts;
  if (takes_lists_) {
    add(QJsonArray::fromStringList(topics));
  } else {
    for (const QString& topic : topics) add(topic);
  }
  return texts;
}

}  // namespace mapwright::robot::axbot
