// The dock "Overlays": what to draw, the list, the form, what is wrong, what has to be decided, saving.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QDockWidget>

#include "ui/overlays/overlay_flaws.h"
#include "ui/overlays/overlay_text.h"
#include "ui/overlays/overlay_tool.h"

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QMenu;
class QPushButton;
class QTableView;
class QTabWidget;
class QToolButton;

namespace mapwright::ui {

class OverlayFilter;
class OverlayForm;
class OverlayPoints;
class OverlaysModel;

class OverlaysDock : public QDockWidget {
  Q_OBJECT
 public:
  /// Both must outlive this.
  OverlaysDock(edit::OverlayEditing* editing, OverlayTool* tool, QWidget* parent = nullptr);
  ~OverlaysDock() override;

  /// Why nothing is shown; empty = something is. `may_retry`: reading failed.
  void setUnavailableReason(const QString& sentence, bool may_retry);
  /// The progress or problem of saving; empty = none.
  void setSaving(bool saving, bool may_save, const QString& trouble);
  /// An earlier draft; empty = none.
  void setOffer(const QString& sentence);
  void setFlaws(std::vector<ShownFlaw> flaws);
  /// Of what would be saved.
  bool hasUnsavedFlaws() const;

  QToolButton* modeButton(OverlayMode mode) const { return modes_[std::size_t(mode)]; }
  QToolButton* duplicateButton() const { return duplicate_; }
  QToolButton* removeButton() const { return remove_; }
  QComboBox* newTypePicker() const { return new_type_; }
  QLineEdit* filterEdit() const { return filter_; }
  QComboBox* stateChoice() const { return bits_; }
  QTableView* table() const { return table_; }
  OverlaysModel* model() const { return model_; }
  OverlayForm* form() const { return form_; }
  OverlayPoints* points() const { return points_; }
  OverlayFlaws* flaws() const { return flaws_; }
  QListWidget* flawList() const { return flaws_->list(); }
  QPushButton* mineButton() const { return mine_; }
  QPushButton* theirsButton() const { return theirs_; }
  QPushButton* discardButton() const { return discard_; }
  QPushButton* reviewButton() const { return review_; }
  QPushButton* restoreButton() const { return restore_; }
  QPushButton* forgetButton() const { return forget_; }
  QToolButton* historyButton() const { return history_; }
  QPushButton* retryButton() const { return retry_; }
  QString statusShown() const;
  QString emptyShown() const;
  QString conflictShown() const;
  /// Buttons with menus of what others do with the selection.
  void setMenus(QMenu* from_robot, QMenu* arrange, QAction* snap, QMenu* snap_to, QAction* defaults);
  QDoubleSpinBox* radiusBox() const { return radius_; }
  /// Shows the first conflict.
  void showConflicts();

 Q_SIGNALS:
  void modeWanted(mapwright::ui::OverlayMode mode);
  void reviewWanted();
  void retryWanted();
  void draftWanted();
  void draftNotWanted();
  void copyWanted();
  void cutWanted();
  void pasteWanted();
  void historyWanted();
  void locateWanted(mapwright::overlays::FeatureKey key);
  void placeWanted(const Eigen::Vector2d& at_m);
  /// The way to a point that cannot be reached.
  void wayWanted(mapwright::overlays::FeatureKey key);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildModes();
  void buildTable();
  void buildConflict();
  void buildOffer();
  void refresh();
  void refreshMode();
  void refreshConflict();
  void showSelection();
  void onSelection();
  void showMenu(const QPoint& at);
  std::set<FeatureKey> rowsSelected(bool deleted) const;
  QString statusText() const;
  QString emptyText() const;

  edit::OverlayEditing* editing_;
  OverlayTool* tool_;
  QString unavailable_reason_, trouble_;
  bool saving_ = false, may_save_ = false, may_retry_ = false, showing_selection_ = false;
  OverlaysModel* model_;
  OverlayFilter* sorted_;
  std::array<QToolButton*, kOverlayModes> modes_{};
  QWidget *mode_row_, *tool_row_, *radius_row_, *body_, *conflict_box_, *offer_box_;
  QToolButton *duplicate_, *remove_, *robot_, *arrange_, *snap_, *defaults_;
  QDoubleSpinBox* radius_;
  QComboBox *new_type_, *bits_;
  QLineEdit* filter_;
  QTableView* table_;
  QTabWidget* tabs_;
  OverlayForm* form_;
  OverlayPoints* points_;
  OverlayFlaws* flaws_;
  QLabel *empty_, *status_, *conflict_, *offer_;
  QPushButton *mine_, *theirs_, *next_, *discard_, *review_, *restore_, *forget_, *retry_;
  QToolButton* history_;
  std::optional<overlays::EditingDocument::Conflict> deciding_;
};

}  // namespace mapwright::ui
