// The topics as a table.
#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "ui/plots/topic_log.h"

namespace mapwright::window {

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

}  // namespace mapwright::window
