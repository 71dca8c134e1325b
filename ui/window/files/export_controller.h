// What is on screen, written into files or copied as a picture.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QImage>
#include <QPointer>

#include "window/controller.h"
#include "window/window_context.h"

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
  /// The whole map on screen is in a file now.
  void wholeExported();

 private:
  void askAndSavePicture();
  void copyPicture();
  /// The local files that the map on screen was read from.
  std::vector<std::string> sourceFiles() const;

  WindowContext& context_;
  std::function<QStringList(const QString& picture)> yamls_naming_;
  QPointer<ExportDialog> dialog_;
};

}  // namespace mapwright::window
