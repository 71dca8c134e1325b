// A bag of messages with their texts, as a robot answers ranges of it.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <QObject>

#include "robot/bag_library.h"

namespace mapwright::test {

struct Recorded {
  double stamp_s = 0;
  std::string topic, json;
  map::TopicMessage message = map::UnreadableMessage{};
  bool known = false;
};

class TextBag : public QObject, public robot::BagLibrary {
 public:
  std::vector<Recorded> recorded;  // by stamp
  int asked = 0;                   // ranges
  bool interrupted = false;        // says BagInfo

  void add(double stamp_s, const std::string& topic, const std::string& json) {
    recorded.push_back({stamp_s, topic, json, map::UnreadableMessage{}, false});
  }
  void add(double stamp_s, map::TopicMessage message) {
    recorded.push_back({stamp_s, "/known", "{}", std::move(message), true});
  }

  robot::Call list(robot::OutcomeTo<std::vector<robot::BagEntry>>) override { return {}; }
  robot::Call info(const robot::BagKey&, robot::OutcomeTo<robot::BagInfo> reply) override {
    QMetaObject::invokeMethod(
        this,
        [this, reply] {
          reply(robot::BagInfo{std::int64_t(recorded.size()), recorded.front().stamp_s,
                               recorded.back().stamp_s, interrupted});
        },
        Qt::QueuedConnection);
    return {};
  }
  robot::Call messages(const robot::BagKey&, const robot::BagRange& range,
                       robot::OutcomeTo<robot::BagChunkPtr> reply) override {
    ++asked;
    auto chunk = std::make_shared<robot::BagChunk>();
    chunk->from_s = range.from_s;
    chunk->until_s = range.until_s;
    std::string text;
    for (const Recorded& each : recorded) {
      if (each.stamp_s < range.from_s || each.stamp_s >= range.until_s) continue;
      robot::BagMessage message;
      message.message = {each.message, each.stamp_s, {}, each.topic};
      message.known = each.known;
      message.at = text.size();
      message.size = each.json.size();
      text += each.json;
      chunk->messages.push_back(std::move(message));
    }
    chunk->text = std::make_shared<const std::string>(std::move(text));
    QMetaObject::invokeMethod(
        this, [chunk, reply] { reply(robot::BagChunkPtr(chunk)); }, Qt::QueuedConnection);
    return {};
  }
  robot::Call picture(const std::string&, const std::string&,
                      robot::OutcomeTo<std::shared_ptr<const std::string>>) override {
    return {};
  }
  robot::Call record(const robot::BagOrder&, robot::OutcomeTo<robot::BagEntry>) override { return {}; }
  robot::Call remove(const robot::BagKey&, robot::OutcomeTo<robot::BagKey>) override { return {}; }
  robot::Call download(const robot::BagKey&, const QString&, robot::OutcomeTo<robot::BagDownload>) override {
    return {};
  }
};

}  // namespace mapwright::test
