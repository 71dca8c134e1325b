// A whole window on the screen, for tests.
#pragma once

#include <memory>
#include <utility>

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "app/robot_factory.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/window/main_window.h"

namespace mapwright::test {

/// 1366 x 768, with settings and drafts of its own; nothing in it glides.
class ShownWindow {
 public:
  explicit ShownWindow(decltype(ui::MainWindow::Dependencies::connect) connect)
      : settings_(filePath(QStringLiteral("s.ini")), QSettings::IniFormat) {
    ui::MainWindow::Dependencies wanted{std::move(connect), settings_};
    wanted.addresses = app::knownAddresses();
    wanted.edit.drafts_folder = filePath(QStringLiteral("drafts"));
    window_ = std::make_unique<ui::MainWindow>(std::move(wanted));
    window_->resize(1366, 768);
    window_->show();
    window_->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window_.get());
  }
  ~ShownWindow() { window_.reset(); }

  ui::MainWindow& window() const { return *window_; }
  session::Session* session() const { return window_->session(); }
  bool connectTo(const QString& address) { return !window_->connectTo(address); }
  /// In a folder that goes with this.
  QString filePath(const QString& name) const { return folder_.filePath(name); }
  /// Every listed submap and the whole map are there, or failed.
  bool mapsSettled() const { return session()->counts().pending == 0 && session()->wholeMap().settled(); }
  /// They go by themselves.
  bool hasToasts() const { return !window_->findChild<ui::MapOverlay*>()->toasts()->texts().isEmpty(); }

 private:
  QTemporaryDir folder_;
  QSettings settings_;
  std::unique_ptr<ui::MainWindow> window_;
};

}  // namespace mapwright::test
