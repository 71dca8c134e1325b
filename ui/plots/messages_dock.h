// The messages of the robot: how often they arrive, and their content.
#pragma once

#include <functional>

#include <QDockWidget>
#include <QPointer>
#include <QSortFilterProxyModel>
#include <QTimer>

#include "session/session.h"
#include "ui/plots/plot_selection.h"
#include "ui/plots/topics_model.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QSplitter;
class QStringListModel;
class QTableView;

namespace mapwright::ui {

class MessageView;
class PlainLabel;

/// Collects messages only while it is visible and not paused.
class MessagesDock : public QDockWidget {
  Q_OBJECT
 public:
  /// `monotonic`: milliseconds of a monotonic clock.
  explicit MessagesDock(std::function<qint64()> monotonic = {}, QWidget* parent = nullptr);
  ~MessagesDock() override;
  void setSession(session::Session* session);

  const TopicLog& log() const { return log_; }
  QTableView* table() const { return table_; }
  QSortFilterProxyModel* rows() const { return sorted_; }
  QLineEdit* filterEdit() const { return filter_; }
  QLineEdit* topicEdit() const { return topic_; }
  QPushButton* pauseButton() const { return pause_; }
  QPushButton* clearButton() const { return clear_; }
  QPushButton* copyButton() const { return copy_; }
  MessageView* messageView() const { return message_; }
  QString chosenTopic() const { return chosen_; }
  QString moreShown() const;
  /// All that can be looked at: those that have come, and those that the robot offers.
  QStringList knownTopics() const;
  bool watching() const { return watching_; }
  /// Listens to it if nothing else does.
  void chooseTopic(const QString& topic);
  /// Somebody else needs the raw messages, so they are subscribed even if this is not visible.
  void setWantedElsewhere(bool wanted);
  /// Shows now what has come.
  void refresh();

 Q_SIGNALS:
  void copyWanted(const QString& text, const QString& what);
  void plotWanted(const mapwright::ui::PlotSelection& selection);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* buildControls();
  void buildTable();
  void addTopic();
  void listenTo(const QString& topic);
  void dropTopic(const QString& topic);
  void updateWatching();
  void showMessage(bool force);
  /// The clock for rates: for a replay the recorded time, which stops with it.
  qint64 now() const;
  /// A replay sends the last messages before its present time at once.
  void expectAgain();
  void showMenu(const QPoint& at);

  std::function<qint64()> monotonic_;
  QPointer<session::Session> session_;
  TopicLog log_;
  QStringList asked_;
  QString chosen_;
  qint64 shown_ms_ = 0;     // now() at the last update
  bool retelling_ = false;  // the last messages before are being sent
  bool watching_ = false, on_screen_ = false, dirty_ = false, wanted_elsewhere_ = false, asks_ = false;
  quint64 shown_count_ = 0;
  QTimer refresh_timer_;
  TopicsModel* model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  QSplitter* split_;
  MessageView* message_;
  PlainLabel* caption_;
  QLabel* more_;
  QLineEdit *filter_, *topic_;
  QStringListModel* known_;
  QPushButton *add_, *pause_, *clear_, *copy_;
};

}  // namespace mapwright::ui
