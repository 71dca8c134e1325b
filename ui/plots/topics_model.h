// Statistics of messages by topic (counts, rates, the last message), bounded, and the topics as a table.
#pragma once

#include <deque>
#include <map>
#include <utility>
#include <vector>

#include <QAbstractTableModel>
#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <QStringList>

#include "robot/robot.h"

namespace mapwright::ui {

struct TopicTally {
  QString topic;
  bool binary = false;
  quint64 count = 0;
  qint64 last_bytes = 0;
  QDateTime last;   // invalid: nothing came yet
  QByteArray text;  // of the last message, at most TopicLog::kMaxText
  bool cut = false;
  bool asked_for = false;  // requested by the user
};

class TopicLog {
 public:
  static constexpr int kMaxTopics = 500;
  static constexpr qsizetype kMaxText = 256 * 1024;
  static constexpr qint64 kRateSpanMs = 5'000;

  enum class Telling {
    New,
    Again,  // a replay is paused; a message that was already the last one counts once
  };
  /// `now_ms` is monotonic. For a recording it is the time of the message; after a jump call
  /// beginRatesAnew().
  void record(const robot::RawMessage& message, qint64 now_ms, Telling telling = Telling::New);
  /// The messages and rates are those of a recording.
  void setRecorded(bool recorded) { recorded_ = recorded; }
  /// Messages before this do not count for the rates of a recording.
  void beginRatesAnew(qint64 now_ms) { rates_from_ms_ = now_ms; }
  /// These have rows even before a message arrives.
  void setAskedFor(const QStringList& topics);
  /// Clears counts and messages; requested topics keep their rows.
  void clear();

  /// By name.
  const std::map<QString, TopicTally>& topics() const { return topics_; }
  const TopicTally* find(const QString& topic) const;
  /// False for a recording until a second of it has been played.
  bool ratesKnown(const QString& topic, qint64 now_ms) const;
  /// Over the last five seconds, or since the first message if that is more recent.
  double messagesPerSecond(const QString& topic, qint64 now_ms) const;
  double bytesPerSecond(const QString& topic, qint64 now_ms) const;
  /// Messages of topics beyond kMaxTopics.
  quint64 dropped() const { return dropped_; }

 private:
  struct Arrivals {
    std::deque<std::pair<qint64, qint64>> recent;  // time, bytes; at most kMaxRecent
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

class TopicsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column {
    TopicColumn,
    TypeColumn,
    CountColumn,
    RateColumn,
    BytesRateColumn,
    SizeColumn,
    TimeColumn,
    Columns
  };
  static constexpr int kSortRole = Qt::UserRole;

  using QAbstractTableModel::QAbstractTableModel;
  /// Takes over what the log holds.
  void sync(const TopicLog& log, qint64 now_ms);
  QString topicAt(int row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    QString topic;
    bool binary = false, asked_for = false;
    quint64 count = 0;
    bool rate_known = false;
    double rate = 0, bytes_rate = 0;
    qint64 size = 0;
    QDateTime last;
    bool operator==(const Row&) const = default;
  };
  QString text(const Row& row, int column) const;
  std::vector<Row> rows_;
};

}  // namespace mapwright::ui
