// The list of problems, at the bottom of the window.
#pragma once

#include <QDockWidget>
#include <QPointer>

#include "session/session.h"
#include "ui/robot/problems_model.h"

class QPushButton;
class QTableView;

namespace mapwright::ui {

class PlainLabel;

class ProblemsDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit ProblemsDock(QWidget* parent = nullptr);
  ~ProblemsDock() override;
  void setSession(session::Session* session);
  ProblemsModel* model() const { return model_; }
  QTableView* table() const { return table_; }

 Q_SIGNALS:
  void retryWanted();
  void copyWanted(const QString& text, const QString& what);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  void copySelected();

  QPointer<session::Session> session_;
  ProblemsModel* model_;
  QTableView* table_;
  PlainLabel* summary_;
  QPushButton *copy_selected_, *copy_all_, *clear_, *retry_;
};

}  // namespace mapwright::ui
