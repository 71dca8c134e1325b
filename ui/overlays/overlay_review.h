// What saving would change, before anything is sent.
#pragma once

#include <vector>

#include <QDialog>
#include <QStringList>

#include "overlays/overlay_merge.h"

class QPushButton;

namespace mapwright::ui {

class OverlayReview : public QDialog {
  Q_OBJECT
 public:
  /// `robot`: empty for a file. `changes`: from `before` to `after`. `note`: what else is to be known; may be
  /// empty.
  OverlayReview(const QString& map, const QString& robot, const overlays::OverlayDocument& before,
                const overlays::OverlayDocument& after, std::vector<overlays::OverlayChange> changes,
                const QString& note, QWidget* parent = nullptr);

  QPushButton* saveButton() const { return save_; }
  QPushButton* cancelButton() const { return cancel_; }
  /// As sentences.
  QStringList changesShown() const;
  /// Whether saving would still change just what is shown.
  bool shows(const overlays::OverlayDocument& before, const overlays::OverlayDocument& after) const;

 private:
  class Changes;
  Changes* changes_;
  QPushButton *save_, *cancel_;
};

}  // namespace mapwright::ui
