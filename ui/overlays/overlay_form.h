// The overlay that is selected, as a form: name, type, heading, its other properties as JSON, its points.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QWidget>

#include "edit/overlays/overlay_editing.h"
#include "ui/overlays/overlay_text.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace mapwright::ui {

/// Fills a picker with the types of a shape, "Virtual wall (2)", and chooses `type`, known or not.
void showTypes(QComboBox& picker, overlays::Shape shape, int type);

class OverlayForm : public QWidget {
  Q_OBJECT
 public:
  /// `editing` must outlive this.
  explicit OverlayForm(edit::OverlayEditing* editing, QWidget* parent = nullptr);

  QLineEdit* nameEdit() const { return name_; }
  QComboBox* typePicker() const { return type_; }
  QDoubleSpinBox* yawBox() const { return yaw_; }
  QTableWidget* properties() const { return properties_; }
  QLineEdit* newKeyEdit() const { return new_key_; }
  QPushButton* addButton() const { return add_; }
  QPushButton* removeButton() const { return remove_; }
  QString moreShown() const;
  QString problemShown() const;

 private:
  void refresh();
  void refreshUsable();
  void showType();
  void showProperties(const Feature& feature);
  /// Those that all of several selected ones have.
  void showCommon();
  void showRows(const std::vector<std::pair<QString, QString>>& rows);
  void sayMore(const QString& sentence);
  void applyName();
  void applyValue(int row);
  void addProperty();
  void removeProperty();
  void say(const QString& problem);
  const Feature* feature() const;

  edit::OverlayEditing* editing_;
  QLabel *about_, *more_, *problem_, *yaw_label_;
  QLineEdit *name_, *new_key_;
  QComboBox* type_;
  QDoubleSpinBox* yaw_;
  QTableWidget* properties_;
  QPushButton *add_, *remove_;
  std::optional<FeatureKey> shown_;
  std::optional<Feature> shown_feature_;
  bool refreshing_ = false;
};

/// The points of the overlay that is selected; those of rings one after the other.
class OverlayPoints : public QWidget {
  Q_OBJECT
 public:
  explicit OverlayPoints(edit::OverlayEditing* editing, QWidget* parent = nullptr);
  QTableWidget* table() const { return table_; }
  QString aboutShown() const;

 private:
  void refresh();
  void onCellChanged(int row, int column);

  edit::OverlayEditing* editing_;
  QLabel* about_;
  QTableWidget* table_;
  std::optional<FeatureKey> shown_;
  std::optional<Feature> shown_feature_;
  std::vector<overlays::Vertex> vertices_;  // of the rows
  bool refreshing_ = false;
};

}  // namespace mapwright::ui
