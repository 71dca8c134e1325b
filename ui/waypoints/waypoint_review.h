// Review and send: the calls that saving takes, in their order, before they are sent; then what becomes of
// each, and at the end how what is kept compares with what was wanted. Stays open beside the map. GUI thread.
#pragma once

#include <map>

#include <QDialog>
#include <QPointer>

#include "edit/open_waypoints.h"
#include "ui/waypoints/review_model.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;

namespace mapwright::window {

class WaypointReview : public QDialog {
  Q_OBJECT
 public:
  explicit WaypointReview(QWidget* parent = nullptr);

  /// Saving this list is something to look at first: a robot is called, and not just a file written.
  static bool isWorthIt(const edit::OpenWaypoints& list);
  /// Shows what saving takes now. `map`: what people call it.
  void review(edit::OpenWaypoints* list, const QString& map);
  /// The list goes.
  void forget();

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
  void takePlan();
  void refresh();
  QString statusText() const;
  QString refusedText() const;  // what is not sent
  QString madeUpText() const;   // what is sent that nobody has chosen
  QString comparedText() const;

  QPointer<edit::OpenWaypoints> list_;
  QString map_;
  ReviewModel* model_;
  QLabel *heading_, *status_, *compared_;
  QTableView* table_;
  QCheckBox* go_on_;
  QProgressBar* progress_;
  QPushButton *send_, *cancel_, *close_;
  std::map<edit::Key, edit::Change> wanted_;  // all that was sent since it was shown
  bool sent_ = false, overtaken_ = false, waiting_ = false;
  bool unreached_ = false;  // nothing was sent, for how they are kept could not be read
};

}  // namespace mapwright::window
