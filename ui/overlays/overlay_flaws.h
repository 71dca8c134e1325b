// What is wrong with the overlays: the list, the rules that are looked at, and the robot's radius.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include <QSettings>
#include <QWidget>

#include "edit/overlays/overlay_editing.h"
#include "overlays/overlay_check.h"
#include "ui/overlays/overlay_text.h"

class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QMenu;
class QToolButton;

namespace mapwright::ui {

/// A flaw of a feature, as a sentence.
struct ShownFlaw {
  FeatureKey key = 0;
  QString sentence;
  std::optional<Eigen::Vector2d> at_m;
  overlays::Rule rule = overlays::Rule::DuplicateId;
};

class OverlayFlaws : public QWidget {
  Q_OBJECT
 public:
  explicit OverlayFlaws(QWidget* parent = nullptr);

  void setFlaws(std::vector<ShownFlaw> flaws);
  const std::vector<ShownFlaw>& flaws() const { return flaws_; }
  /// Those that are switched off.
  const std::set<overlays::Rule>& off() const { return off_; }
  /// Of the robot, if one was set; otherwise its own counts, which is `told_m`.
  std::optional<double> radius() const;
  void setToldRadius(double told_m);
  /// Why what lies on the map is not checked; empty: it is.
  void setNotChecked(const QString& sentence);
  void recall(const QSettings& settings);
  void remember(QSettings& settings) const;

  QListWidget* list() const { return list_; }
  QToolButton* rulesButton() const { return rules_; }
  QDoubleSpinBox* radiusBox() const { return radius_; }

 Q_SIGNALS:
  void optionsChanged();
  void chosen(const mapwright::ui::ShownFlaw& flaw);

 private:
  void fillMenu();

  std::vector<ShownFlaw> flaws_;
  std::set<overlays::Rule> off_;
  QListWidget* list_;
  QToolButton* rules_;
  QMenu* menu_;
  QDoubleSpinBox* radius_;
  QLabel *more_, *not_checked_;
};

}  // namespace mapwright::ui
