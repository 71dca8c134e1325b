// The projections of a robot's 3D map: a table to read and edit.
#pragma once

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

#include "ui/clouds/projections_model.h"

namespace mapwright::ui {

/// The actions possible now.
struct ProjectionsOffer {
  bool online = false, reads = false, changes = false;
};

class ProjectionsDock : public QDockWidget {
  Q_OBJECT
 public:
  /// The draft must outlive this; call refresh() after changing it.
  explicit ProjectionsDock(const ProjectionDraft* draft, QWidget* parent = nullptr);

  /// Not empty: why there is nothing to read or edit.
  void setAbsence(const QString& sentence);
  void setOffer(const ProjectionsOffer& offer);
  void setBusy(bool busy);
  /// The result of the last request; empty = none.
  void setOutcome(const QString& sentence, bool bad);
  void setDrawing(bool drawing);
  void refresh();

  QTableView* table() const { return table_; }
  ProjectionsModel* model() const { return model_; }
  QPushButton* askButton() const { return ask_; }
  QPushButton* addButton() const { return add_; }
  QPushButton* drawButton() const { return draw_; }
  QPushButton* removeButton() const { return remove_; }
  QPushButton* revertButton() const { return revert_; }
  QPushButton* sendButton() const { return send_; }
  QString outcome() const { return outcome_->text(); }
  QString absence() const { return absence_->text(); }
  QString state() const { return state_->text(); }

 Q_SIGNALS:
  void sendWanted();
  void chosen(std::optional<int> index);

 private:
  const ProjectionDraft* draft_;
  ProjectionsModel* model_;
  QLabel *absence_, *state_, *outcome_;
  QWidget* body_;
  QTableView* table_;
  QPushButton *ask_, *add_, *draw_, *remove_, *revert_, *send_;
  ProjectionsOffer offer_;
  bool busy_ = false;
  bool selecting_ = false;  // by refresh(), not by the user
};

}  // namespace mapwright::ui
