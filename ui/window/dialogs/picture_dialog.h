// Asks how a picture without a map.yaml lies in the world.
#pragma once

#include <optional>

#include <QDialog>

#include "window/files/map_files.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::window {

class PictureDialog : public QDialog {
  Q_OBJECT
 public:
  /// `named_by`: the map.yaml files that name it as theirs, none or several. `accept_text`: what the button
  /// says, "Open".
  PictureDialog(const QString& path, const QStringList& named_by, const QString& accept_text,
                QWidget* parent = nullptr);
  /// nullopt while a field holds nothing usable.
  std::optional<PicturePlacement> placement() const;
  QString errorText() const;
  QString introText() const;

 private:
  void check();
  QLineEdit *resolution_, *x_, *y_, *yaw_;
  QLabel *intro_, *error_;
  QPushButton* open_;
};

/// The sentence that refuses what was typed; empty when it is fine.
QString whyNoPlacement(const QString& resolution, const QString& x, const QString& y, const QString& yaw_deg);

}  // namespace mapwright::window
