// Comparing two maps: which, how, and the divider between them.
#pragma once

#include <optional>

#include <QObject>
#include <QPointer>

#include "scene/map_scene.h"
#include "ui/view/compare_bar.h"

namespace mapwright::window {

class MapView;
class SwipeHandle;

class CompareControl : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this.
  CompareControl(scene::MapScene* scene, MapView* view, CompareBar* bar, QObject* parent = nullptr);

  void setSession(session::Session* session);
  bool active() const { return scene_->compareMode() != scene::CompareMode::Off; }
  /// Starts, or switches to another second map; nullopt: the user chooses it in the bar.
  void start(const std::optional<SecondMap>& second = {});
  /// Compares with a map from elsewhere.
  void startWith(map::WholeMap map);
  void end();
  const std::optional<SecondMap>& second() const { return second_; }
  CompareBar* bar() const { return bar_; }
  SwipeHandle* handle() const { return handle_; }

 Q_SIGNALS:
  void fileWanted();
  void ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void choose(const SecondMap& second);
  void setMode(scene::CompareMode mode);
  void sync();

  scene::MapScene* scene_;
  MapView* view_;
  CompareBar* bar_;
  SwipeHandle* handle_;
  QPointer<session::Session> session_;
  std::optional<SecondMap> second_;
};

}  // namespace mapwright::window
