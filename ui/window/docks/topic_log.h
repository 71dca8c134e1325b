// What came on which topic: counts, rates, the last message. Bounded, whatever a robot sends.
#pragma once

#include <deque>
#include <map>

#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <QStringList>

#include "robot/robot.h"

namespace mapwright::window {

struct TopicTally {
  QString topic;
  bool binary = false;
  quint64 count = 0;
  qint64 last_bytes = 0;
  QDateTime last;   // invalid: nothing came yet
  QByteArray text;  // of the last message, at most TopicLog::kMaxText
  bool cut = false;
  bool asked_for = false;  // enabled by the user
};

class TopicLog {
 public:
  static constexpr int kMaxTopics = 500;
  static constexpr qsizetype kMaxText = 256 * 1024;
  static constexpr qint64 kRateSpanMs = 5'000;

  enum class Telling {
    New,
    Again,  // it holds still; one that was the last before, too, counts once
  };
  /// `now_ms` runs monotonously. Of a recording it is the time of the message there; where it jumps to,
  /// beginRatesAnew().
  void note(const robot::RawMessage& message, qint64 now_ms, Telling telling = Telling::New);
  /// The messages are those of a recording, and so are their rates.
  void setRecorded(bool recorded) { recorded_ = recorded; }
  /// What was told until then counts in no rate of a recording.
  void beginRatesAnew(qint64 now_ms) { rates_from_ms_ = now_ms; }
  /// These have rows even before anything came.
  void setAskedFor(const QStringList& topics);
  /// Counts and messages go; what was asked for keeps its row.
  void clear();

  /// By name.
  const std::map<QString, TopicTally>& topics() const { return topics_; }
  const TopicTally* find(const QString& topic) const;
  /// Of a recording not as long as less than a second of it has been played.
  bool ratesKnown(const QString& topic, qint64 now_ms) const;
  /// Over the last five seconds, or since the first message when that is less long ago.
  double messagesPerSecond(const QString& topic, qint64 now_ms) const;
  double bytesPerSecond(const QString& topic, qint64 now_ms) const;
  /// Messages of topics beyond kMaxTopics.
  quint64 dropped() const { return dropped_; }

 private:
  struct Arrivals {
    std::deque<std::pair<qint64, qint64>> recent;  // when, bytes; at most kMaxRecent
    qint64 first_ms = 0;
  };
  static constexpr std::size_t kMaxRecent = 5'000;
  template <typename Sum>
  double perSecond(const QString& topic, qint64 now_ms, Sum sum) const;

  bool recorded_ = false;
  qint64 rates_from_ms_ = 0;  // of a recording
  std::map<QString, TopicTally> topics_;
  std::map<QString, Arrivals> arrivals_;
  quint64 dropped_ = 0;
};

}  // namespace mapwright::window
