// Review and send: the requests that saving takes, in their order, before they are sent; then the result of
// each, and at the end how the stored waypoints compare with what was intended. Stays open beside the map.
// GUI thread.
#pragma once

#include <map>
#include <vector>

#include <QAbstractTableModel>
#include <QDialog>
#include <QPointer>

#include "edit/open_waypoints.h"
#include "exchange/waypoint_steps.h"
#include "ui/kit/status_text.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace mapwright::ui {

/// The requests, each in words, with its changes and its result; below them the changes that the robot would
/// refuse, which are not sent. Rows keep their positions: neither focus nor selection moves when they change.
class ReviewModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { NumberColumn, DeedColumn, CallColumn, ChangeColumn, OutcomeColumn, kColumns };

  using QAbstractTableModel::QAbstractTableModel;
  /// The requests to send.
  void showPlan(edit::OpenWaypoints* list, std::vector<edit::PlannedRequest> plan);
  /// How many rows are requests; the others are refused.
  int requests() const;
  /// The requests sent or being sent: follows the list's submission.
  void showSubmission(edit::OpenWaypoints* list);
  /// Nothing.
  void clear();
  bool showsPlan() const { return list_ && !follows_; }
  const std::vector<edit::PlannedRequest>& plan() const { return plan_; }

  /// How many rows are in each state.
  exchange::SentCounts counts() const;
  /// The requests that were not carried out, as far as known.
  std::vector<robot::WaypointRequest> rest() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Outcome {
    Mark mark = Mark::None;
    QString text;
    QString sentence = {};  // with its result; empty = the text says it
  };
  using State = edit::SubmittedRequest::State;
  const robot::WaypointRequest& request(int row) const;
  robot::WaypointCall call(int row) const;
  const std::vector<robot::WaypointChange>& changes(int row) const;
  Outcome outcome(int row) const;
  Outcome plannedOutcome(int row) const;
  void follow();
  void onRefused();
  void updateRows();

  struct Refused {
    std::vector<robot::WaypointChange> changes;  // one
    QString why;
  };
  const QString* refusedReason(int row) const;
  QPointer<edit::OpenWaypoints> list_;
  std::vector<edit::PlannedRequest> plan_;
  std::vector<Refused> refused_;
  std::map<edit::Key, QString> refused_since_;  // why, of those that have a row because they were to be sent
  bool follows_ = false;
  int shown_rows_ = 0;
};

class WaypointReview : public QDialog {
  Q_OBJECT
 public:
  explicit WaypointReview(QWidget* parent = nullptr);

  /// Saving this list should be reviewed first: it calls a robot, it does not just write a file.
  static bool isWorthIt(const edit::OpenWaypoints& list);
  /// Shows what saving takes now. `map`: its name.
  void review(edit::OpenWaypoints* list, const QString& map);
  /// The list is being closed.
  void forget();
  /// Why nothing can be sent at present; empty: the robot is there.
  void setLinkTrouble(const QString& why);

  ReviewModel* model() const { return model_; }
  QPushButton* sendButton() const { return send_; }
  QPushButton* cancelButton() const { return cancel_; }
  QPushButton* closeButton() const { return close_; }
  QCheckBox* goOnBox() const { return go_on_; }
  QString statusShown() const;
  /// "Compared …"; empty before there is something to compare.
  QString comparedShown() const;

 Q_SIGNALS:
  void givenUp();  // closed, and not all is sent

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void send();
  void onPlan();
  void refresh();
  QString statusText() const;
  QString refusedText() const;  // what is not sent
  QString madeUpText() const;   // what is sent that nobody has chosen
  QString comparedText() const;

  QPointer<edit::OpenWaypoints> list_;
  QString map_, link_trouble_;
  ReviewModel* model_;
  QLabel *heading_, *status_, *compared_;
  QTableView* table_;
  QCheckBox* go_on_;
  QProgressBar* progress_;
  QPushButton *send_, *cancel_, *close_;
  std::map<edit::Key, edit::Change> wanted_;  // all that was sent since it was shown
  bool sent_ = false, overtaken_ = false, waiting_ = false;
  bool unreached_ = false;  // nothing was sent, because the stored waypoints could not be read
};

}  // namespace mapwright::ui
