// Exports what is on screen to files, or copies it as a picture.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QImage>
#include <QPointer>

#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::window {

class ExportDialog;

class ExportController : public Controller {
  Q_OBJECT
 public:
  /// `yamls_naming`: see PicturePlacing; null = none.
  ExportController(WindowContext& context, std::function<QStringList(const QString& picture)> yamls_naming,
                   QObject* parent = nullptr);

  void exportMap();
  ExportDialog* dialog() const;  // null: not open

  /// The map as on screen, without buttons and notices.
  QImage mapPicture() const;
  /// The error is a sentence.
  std::optional<QString> saveMapPicture(const QString& path);

 Q_SIGNALS:
  /// The whole map on screen has been written to a file.
  void wholeExported();

 private:
  void askAndSavePicture();
  void copyPicture();
  /// The local files from which the map on screen was read.
  std::vector<std::string> sourceFiles() const;

  WindowContext& context_;
  std::function<QStringList(const QString& picture)> yamls_naming_;
  QPointer<ExportDialog> dialog_;
};

}  // namespace mapwright::window
