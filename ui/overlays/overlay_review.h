// What saving would change, before anything is sent.
#pragma once

#include <QDialog>
#include <QStringList>

class QLabel;
class QListWidget;
class QPushButton;

namespace mapwright::ui {

class OverlayReview : public QDialog {
  Q_OBJECT
 public:
  /// `robot`: empty for a file. `changes`: as sentences. `note`: what else is to be known; may be empty.
  OverlayReview(const QString& map, const QString& robot, const QStringList& changes, const QString& note,
                QWidget* parent = nullptr);

  QPushButton* saveButton() const { return save_; }
  QPushButton* cancelButton() const { return cancel_; }
  QStringList changesShown() const;

 private:
  QListWidget* list_;
  QPushButton *save_, *cancel_;
};

}  // namespace mapwright::ui
