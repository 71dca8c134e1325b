// Compares the open map with another one: which, how, and the divider between them.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QPointer>
#include <tl/expected.hpp>

#include "robot/robot.h"
#include "ui/kit/controller.h"
#include "ui/maps/map_files.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/window_context.h"
#include "ui/view/compare_bar.h"

namespace mapwright::ui {

class SwipeHandle;

class CompareController : public Controller {
  Q_OBJECT
 public:
  /// `read`: returns a reader for the map at an address; the error is a sentence.
  using Read = std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>(const QString& address)>;

  CompareController(WindowContext& context, PicturePlacing& placing, Read read, QObject* parent = nullptr);
  ~CompareController() override;

  bool active() const { return context_.scene.compareMode() != scene::CompareMode::Off; }
  /// Starts, or switches to another second map; nullopt: the user chooses it in the bar.
  void start(const std::optional<SecondMap>& second = {});
  /// Compares with a map from elsewhere.
  void startWith(map::WholeMap map);
  void end();
  const std::optional<SecondMap>& second() const { return second_; }
  CompareBar* bar() const { return bar_; }
  SwipeHandle* handle() const { return handle_; }

  void compareWith(const map::MapKey& key) { start(key); }
  /// Compares the edited map with the saved one; if that comparison is on, ends it.
  void compareWithSaved();
  void setSession(session::Session* session) override;
  bool escape() override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void choose(const SecondMap& second);
  void setMode(scene::CompareMode mode);
  void sync();
  void chooseFile();
  void compareWithAddress(const QString& address);

  WindowContext& context_;
  PicturePlacing& placing_;
  Read read_;
  CompareBar* bar_;
  SwipeHandle* handle_;
  QPointer<session::Session> session_;
  std::optional<SecondMap> second_;
  std::unique_ptr<robot::Robot> source_;  // reads a file
};

}  // namespace mapwright::ui
