#include "ui/robot/robot_controller.h"

#include <algorithm>

#include "map/whereabouts.h"
#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "session/lacks_picture.h"
#include "session/makes_new_map.h"
#include "session/session.h"
#include "ui/kit/panels.h"
#include "ui/kit/status_text.h"
#include "ui/robot/robot_dock.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/window_status_bar.h"
#include "ui/view/map_overlay.h"
#include "ui/view/notice_bar.h"
#include "ui/view/on_screen.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

RobotController::RobotController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), dock_(new RobotDock(&context.window)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right, .tab = 10, .menu_rank = 40});
  connect(&context_.panels, &Panels::arranged, this, [this] {
    if (comesFirst(context_.current.session())) context_.panels.suggest(dock_);
  });
  const auto open = [this] { context_.panels.open(dock_); };
  connect(context_.overlay.safetyNotice(), &NoticeBar::offerTaken, this, open);
  NoticeBar* const place = context_.overlay.placeNotice();
  connect(place, &NoticeBar::offerTaken, this, &RobotController::changePlace);
  connect(place, &NoticeBar::closed, this, [this, place] {
    dismissed_.insert(place->sentence());
    refreshPlace();
  });
  connect(&context_.scene, &scene::MapScene::robotPlaceChanged, this, &RobotController::refreshPlace);
  connect(&context_.current, &CurrentSession::stateChanged, this, &RobotController::refreshSafety);
  connect(&context_.current, &CurrentSession::stateChanged, this, &RobotController::refreshPlace);
}

bool RobotController::comesFirst(session::Session* session) const {
  // The inspector has nothing to list, and files have no live data.
  return session && !session->robot().submapSource() && !session->robot().isLocal();
}

void RobotController::setSession(session::Session* session) {
  dock_->setSession(session);
  if (comesFirst(session)) context_.panels.suggest(dock_);
  if (!session) return;
  connect(&session->safety(), &session::SafetyWatch::changed, this, &RobotController::refreshSafety);
  connect(session, &session::Session::problemsChanged, this, &RobotController::refreshPlace);
  connect(session, &session::Session::liveChanged, this, [this](int what) {
    const bool says = !context_.overlay.placeNotice()->sentence().isEmpty();
    if (says && what == map::topicIndex<map::TrackedPose>()) refreshPlace();
  });
}

void RobotController::refreshSafety() {
  SafetyState state;
  if (session::Session* const session = context_.current.session())
    state = {session->safety().conditions(), valuesAsOf(*session)};
  const SafetyText text = safetyText(state, QDateTime::currentDateTime());
  const std::size_t count = state.conditions.size();
  const QString offer = count > 1 ? tr("Show all %1").arg(countText(qint64(count))) : tr("Show");
  context_.overlay.safetyNotice()->setNotice(text.mark, text.sentence, offer, false, text.greyed);
  Q_EMIT safetyChanged(text);
}

void RobotController::sayPlace(const QString& sentence, const QString& offer, bool closable, Mark mark) {
  const bool dismissed = dismissed_.contains(sentence);
  context_.overlay.placeNotice()->setNotice(mark, dismissed ? QString() : sentence, offer, closable);
}

void RobotController::refreshPlace() {
  session::Session* const session = context_.current.session();
  const bool robot = session && (session->robot().liveTopics() || session->robot().submapSource());
  if (!robot) return sayPlace({}, {}, false);
  const scene::RobotPlace& place = context_.scene.robotPlace();
  const auto& live = session->live();
  const bool afresh = session::makesNewMap(session->robot(), live, session->submaps());
  const QString its = plainWords(map::currentMapName(live, session->catalogue().entries()), 40);
  const bool drawn = place.drawn != scene::ScreenPart::None;
  const QString show = tr("Show it anyway"), hide = tr("Hide it");
  using map::Whereabouts;
  // One strip says it all (MapsController).
  if (place.where == Whereabouts::Elsewhere && mapsInView(context_.scene).whole &&
      session::lacksPicture(session->wholeMap()))
    return sayPlace({}, {}, false);
  if (place.where == Whereabouts::Elsewhere && !drawn) {
    return sayPlace(
        afresh ? tr("The robot is making a new map, not this one. The robot and its sensor data are hidden.")
        : its.isEmpty()
            ? tr("The robot is not in this map. The robot and its sensor data are hidden.")
            : tr("The robot is in %1, not in this map. The robot and its sensor data are hidden.").arg(its),
        show, false);
  }
  if (place.where == Whereabouts::Elsewhere && place.by_choice) {
    return sayPlace(afresh          ? tr("The robot is making a new map, not this one. It is shown anyway.")
                    : its.isEmpty() ? tr("The robot is not in this map. It is shown anyway.")
                                    : tr("The robot is in %1, not in this map. It is shown anyway.").arg(its),
                    hide, false, Mark::Warning);
  }
  if (place.where == Whereabouts::Unknown && live.robot_pose) {
    return drawn ? sayPlace(tr("The robot does not report which map it is in. It may not be this one."), hide,
                            true)
                 : sayPlace(tr("The robot does not report which map it is in. It is hidden."), show, false);
  }
  const bool overlays = live.map_info && !live.map_info->overlays.empty();
  if (!place.overlays_fit && overlays && context_.scene.layerVisible(scene::Layer::Overlays)) {
    return sayPlace(
        tr("The robot is making a new map. The overlays of %1 do not belong to it and are hidden.")
            .arg(its.isEmpty() ? tr("its last map") : its),
        tr("Show them anyway"), false);
  }
  sayPlace(lackOfPlace(*session), {}, true, Mark::Warning);
}

QString RobotController::lackOfPlace(const session::Session& session) {
  const auto& rows = session.problems().rows();
  const bool robot_is_drawn = session.live().robot_pose.has_value();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const session::LoggedProblem& row) {
    const map::ProblemCode code = row.problem.code;
    return !row.resolved && row.problem.subject.kind == map::SubjectKind::Topic &&
           row.problem.severity >= map::Severity::Warning &&
           (code == map::ProblemCode::Unplaced || (code == map::ProblemCode::Odd && !robot_is_drawn));
  });
  if (found == rows.end()) return {};
  return words::about(words::plainName(sentences::nameOf(found->problem.subject)),
                      sentences::sentenceOf(found->problem));
}

void RobotController::changePlace() {
  const scene::RobotPlace& place = context_.scene.robotPlace();
  const bool hidden = place.drawn == scene::ScreenPart::None || !place.overlays_fit;
  context_.scene.setRobotWanted(hidden);
}

}  // namespace mapwright::ui

#include "moc_robot_controller.cpp"
