// Map files and recordings on this computer: chosen in a dialog, or dropped on the window.
#pragma once

#include "ui/kit/controller.h"
#include "ui/maps/map_files.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class FilesController : public Controller {
  Q_OBJECT
 public:
  FilesController(WindowContext& context, PicturePlacing& placing, QObject* parent = nullptr);

  /// Dialogs start in the folder of what is open, however it was opened.
  void setSession(session::Session* session) override;
  void choose();
  /// A map.yaml, a recording, a picture (asks for its position) or a folder. Errors are shown as a toast.
  void open(const QString& path);

 Q_SIGNALS:
  void addressWanted(const QString& address);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  WindowContext& context_;
  PicturePlacing& placing_;
};

}  // namespace mapwright::ui
