// MainWindow: what nobody may overlook: dangers, and where the robot is.
#include "map/whereabouts.h"
#include "window/docks/robot_dock.h"
#include "window/main_window.h"
#include "window/map/compare_control.h"
#include "window/map/map_overlay.h"
#include "window/map/notice_bar.h"
#include "window/status/connection_chip.h"
#include "window/status/safety_badge.h"
#include "window/status/window_status_bar.h"

namespace mapwright::window {

void MainWindow::wireSafety() {
  const auto show_robot = [this] {
    robot_panel_->show();
    robot_panel_->raise();
  };
  connect(bar_, &WindowStatusBar::safetyWanted, this, show_robot);
  connect(overlay_->safetyNotice(), &NoticeBar::offerTaken, this, show_robot);
  connect(overlay_->placeNotice(), &NoticeBar::offerTaken, this, &MainWindow::changeRobotPlace);
  connect(overlay_->placeNotice(), &NoticeBar::closed, this, [this] {
    dismissed_.insert(overlay_->placeNotice()->sentence());
    refreshPlace();
  });
  connect(scene_.get(), &scene::MapScene::robotPlaceChanged, this, &MainWindow::refreshPlace);
}

void MainWindow::refreshSafety() {
  SafetyState state;
  if (session_) state = {session_->safety().conditions(), session_->staleSince()};
  const SafetyText text = safetyText(state, QDateTime::currentDateTime());
  chip_->setSafety(text);
  bar_->safety()->setSafety(text);
  const std::size_t count = state.conditions.size();
  const QString offer = count > 1 ? tr("Show all %1").arg(countText(qint64(count))) : tr("Show");
  overlay_->safetyNotice()->setNotice(text.mark, text.sentence, offer, false, text.greyed);
}

void MainWindow::refreshPlace() {
  NoticeBar* const notice = overlay_->placeNotice();
  const auto say = [&](const QString& sentence, const QString& offer, bool closable,
                       Mark mark = Mark::Neutral) {
    const bool dismissed = dismissed_.contains(sentence);
    notice->setNotice(mark, dismissed ? QString() : sentence, offer, closable);
  };
  const bool robot = session_ && (session_->robot().liveTopics() || session_->robot().submapSource());
  if (!robot) return say({}, {}, false);
  const scene::RobotPlace& place = scene_->robotPlace();
  const auto& live = session_->live();
  const QString its = plainWords(map::currentMapName(live, session_->catalogue().entries()), 40);
  const bool drawn = place.drawn != scene::ScreenPart::None;
  const QString show = tr("Show it all the same"), hide = tr("Hide it");
  using map::Whereabouts;
  if (place.where == Whereabouts::Elsewhere && !drawn) {
    return say(its.isEmpty()
                   ? tr("The robot is not in this map. It and what it sees are hidden.")
                   : tr("The robot is in %1, not in this map. It and what it sees are hidden.").arg(its),
               show, false);
  }
  if (place.where == Whereabouts::Elsewhere && place.by_choice) {
    return say(its.isEmpty() ? tr("The robot is not in this map. It is drawn all the same.")
                             : tr("The robot is in %1, not in this map. It is drawn all the same.").arg(its),
               hide, false, Mark::Warning);
  }
  if (place.where == Whereabouts::Unknown && live.robot_pose) {
    return drawn ? say(tr("The robot does not say which map it is in. It may not be this one."), hide, true)
                 : say(tr("The robot does not say which map it is in. It is hidden."), show, false);
  }
  const bool overlays = live.map_info && !live.map_info->overlays.empty();
  if (!place.overlays_fit && overlays && scene_->layerVisible(scene::Layer::Overlays)) {
    return say(tr("The robot makes a new map. The overlays of %1 do not belong there and are hidden.")
                   .arg(its.isEmpty() ? tr("its last map") : its),
               tr("Show them all the same"), false);
  }
  say({}, {}, false);
}

QString MainWindow::submapsOf() const {
  // While it makes a new map its submaps are of none yet.
  if (!session_ || !scene_->robotPlace().overlays_fit) return {};
  return plainWords(map::currentMapName(session_->live(), session_->catalogue().entries()), 60);
}

QString MainWindow::titleOf(const QString& robot) const {
  const QString name = robot.left(80);
  QString map;
  if (scene_->layerVisible(scene::Layer::WholeMap) || comparison_->active()) {
    const session::MapSlot& slot = session_->wholeMap();
    if (slot.phase() != session::MapSlot::Phase::Empty) map = mapOnScreen(slot);
    const session::MapSlot& second = session_->comparedMap();
    if (comparison_->active() && second.cells()) map = tr("%1 | %2").arg(map, mapOnScreen(second));
  } else if (scene_->layerVisible(scene::Layer::Submaps) && session_->robot().submapSource()) {
    const QString its = submapsOf();
    map = its.isEmpty() ? tr("Submaps") : tr("Submaps of %1").arg(its);
  }
  return map.isEmpty() ? QStringLiteral("%1 – mapwright").arg(name)
                       : QStringLiteral("%1 – %2 – mapwright").arg(map, name);
}

void MainWindow::changeRobotPlace() {
  const scene::RobotPlace& place = scene_->robotPlace();
  const bool hidden = place.drawn == scene::ScreenPart::None || !place.overlays_fit;
  scene_->setRobotWanted(hidden);
}

}  // namespace mapwright::window
