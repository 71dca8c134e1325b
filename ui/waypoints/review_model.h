// The requests of a review: each with its changes and its result. GUI thread.
#pragma once

#include <vector>

#include <QAbstractTableModel>
#include <QPointer>

#include "edit/open_waypoints.h"
#include "exchange/waypoint_steps.h"
#include "ui/kit/status_text.h"

namespace mapwright::window {

class ReviewModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { NumberColumn, CallColumn, WaypointColumn, ChangeColumn, OutcomeColumn, kColumns };

  using QAbstractTableModel::QAbstractTableModel;
  /// The requests to send.
  void showPlan(edit::OpenWaypoints* list, std::vector<edit::PlannedRequest> plan);
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
  Outcome outcome(int row) const;
  void follow();

  QPointer<edit::OpenWaypoints> list_;
  std::vector<edit::PlannedRequest> plan_;
  bool follows_ = false;
  int told_rows_ = 0;
};

}  // namespace mapwright::window
