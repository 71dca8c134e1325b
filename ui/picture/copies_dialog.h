// The copies of overwritten maps that are kept on this computer: which there are, and what to do with one.
// GUI thread.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QDialog>

#include "edit/picture/picture_copies.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace mapwright::ui {

class CopiesDialog : public QDialog {
  Q_OBJECT
 public:
  /// `folder`: of all of them. `unavailable_reason`: why a copy cannot be put back now; empty = it can.
  CopiesDialog(const QString& folder, std::function<QString(const edit::PictureCopy&)> unavailable_reason,
               QWidget* parent = nullptr);
  /// The newest first.
  void list(std::vector<edit::PictureCopy> copies);
  /// What can be put back may have changed.
  void refresh();

  QTableWidget* table() const { return table_; }
  QPushButton* putBackButton() const { return put_back_; }
  QPushButton* openButton() const { return open_; }
  QPushButton* folderButton() const { return show_; }
  QString statusShown() const;

 Q_SIGNALS:
  void putBackWanted(const mapwright::edit::PictureCopy& copy);
  void openWanted(const QString& path);
  void folderWanted(const QString& folder);

 private:
  const edit::PictureCopy* chosen() const;  // null = none

  QString folder_;
  std::function<QString(const edit::PictureCopy&)> unavailable_reason_;
  std::optional<std::vector<edit::PictureCopy>> copies_;
  QLabel *about_, *status_;
  QTableWidget* table_;
  QPushButton *put_back_, *open_, *show_;
};

}  // namespace mapwright::ui
