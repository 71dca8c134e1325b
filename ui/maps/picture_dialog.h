// Asks for the position of a picture without a map.yaml.
#pragma once

#include <optional>

#include <QDialog>

#include "ui/maps/map_files.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace mapwright::window {

class PictureDialog : public QDialog {
  Q_OBJECT
 public:
  /// `named_by`: the map.yaml files that name it as their image, none or several. `accept_text`: the text of
  /// the button, "Open".
  PictureDialog(const QString& path, const QStringList& named_by, const QString& accept_text,
                QWidget* parent = nullptr);
  /// nullopt while a field is invalid.
  std::optional<PicturePlacement> placement() const;
  QString errorText() const;
  QString introText() const;

 private:
  void check();
  QLineEdit *resolution_, *x_, *y_, *yaw_;
  QLabel *intro_, *error_;
  QPushButton* open_;
};

/// Why the input is invalid; empty if it is valid.
QString whyNoPlacement(const QString& resolution, const QString& x, const QString& y, const QString& yaw_deg);

}  // namespace mapwright::window
