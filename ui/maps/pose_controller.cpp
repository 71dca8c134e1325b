#include "ui/maps/pose_controller.h"

#include <utility>

#include <QAction>

#include "jobs/set_pose.h"
#include "map/live_state.h"
#include "robot/localization.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/panels.h"
#include "ui/maps/pose_dock.h"
#include "ui/maps/pose_tool.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"

namespace mapwright::ui {

namespace {

QString saidOf(map::Failure failure) {
  failure.asked_for = map::AskedFor::Change;
  return QString::fromStdString(sentences::sentenceOf(failure));
}

}  // namespace

PoseController::PoseController(WindowContext& context, QObject* parent)
    : Controller(parent),
      context_(context),
      dock_(new PoseDock(&context.window)),
      tool_(new PoseTool(&context.scene, this)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right,
                              .tab = 72,
                              .menu_rank = 37,
                              .open = false,
                              .idle = lacksForGood(context_.current, {robot::Capability::Localization})});
  open_ = context_.actions.add({.id = "robotPose",
                                .text = tr("Set the robot's &pose…"),
                                .icon = "locate",
                                .tip = tr("Tell the robot where it is on its map"),
                                .needs_of_robot = robot::Capability::Localization,
                                .menu = {MenuGroup::Mapping, 5}},
                               this, [this] {
                                 context_.panels.open(dock_);
                                 if (unavailableReason().isEmpty()) useTool(true);
                               });
  tool_action_ = context_.actions.add({.id = "setPose",
                                       .text = tr("Place the robo&t"),
                                       .tip = tr("Click where the robot is; drag towards where it looks"),
                                       .toggle = true,
                                       .menu = {MenuGroup::Mapping, 6}});
  context_.tools.add(tool_, tool_action_);
  connect(tool_action_, &QAction::toggled, this, [this](bool on) {
    dock_->setPlacing(on);
    if (on) context_.panels.open(dock_);
  });
  connect(tool_, &MapTool::finished, this, [this] { useTool(false); });
  connect(tool_, &PoseTool::placed, this, &PoseController::setPose);
  connect(tool_, &PoseTool::takenBack, this, &PoseController::setPose);
  connect(dock_, &PoseDock::placeWanted, this, &PoseController::useTool);
  connect(dock_, &PoseDock::typed, this, [this](const geometry::Pose2& pose) {
    pose_ = pose;
    tool_->setPose(pose);
  });
  connect(dock_, &PoseDock::setWanted, this, [this] {
    if (pose_) set(*pose_, dock_->adjusts());
  });
  connect(dock_, &PoseDock::findWanted, this, &PoseController::find);
  connect(dock_, &PoseDock::confirmWanted, this, [this] {
    if (const auto pose = std::exchange(proposed_, std::nullopt)) set(*pose, dock_->adjusts());
  });
  connect(dock_, &PoseDock::cancelWanted, this, [this] { call_.cancel(); });
  connect(&context_.current, &CurrentSession::stateChanged, this, &PoseController::refresh);
  connect(&context_.scene, &scene::MapScene::robotPlaceChanged, this, &PoseController::refresh);
  refresh();
}

robot::Localization* PoseController::localization() const {
  session::Session* const session = context_.current.session();
  return session ? session->robot().localization() : nullptr;
}

void PoseController::setSession(session::Session* session) {
  call_ = {};
  proposed_.reset();
  setPose(std::nullopt);
  dock_->forgetOutcome();
  if (session) {
    connect(session, &session::Session::liveChanged, this, [this](int what) {
      if (what == map::topicIndex<map::TrackedPose>()) refresh();
    });
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &PoseController::refresh);
  }
  refresh();
}

QString PoseController::unavailableReason() const {
  session::Session* const session = context_.current.session();
  if (!session) return tr("There is no robot.");
  if (!localization())
    return sentences::absenceReason(robot::Capability::Localization,
                                    session->robot().unavailableReason(robot::Capability::Localization));
  if (session->connection().phase != robot::ConnectionPhase::Online) return tr("The robot is not connected.");
  if (context_.scene.robotPlace().where == map::Whereabouts::Elsewhere)
    return tr("The map on screen is not the one that the robot uses: show that one first.");
  return {};
}

void PoseController::refresh() {
  session::Session* const session = context_.current.session();
  const QString why = unavailableReason();
  open_->setVisible(!session || localization());
  dock_->setObstacle(why);
  allow(tool_action_, why.isEmpty(), why);
  if (!why.isEmpty() && context_.tools.chosen() == tool_) context_.tools.putAway();
  dock_->setPresent(session ? session->live().robot_pose : std::nullopt);
}

void PoseController::setPose(const std::optional<geometry::Pose2>& pose) {
  pose_ = pose;
  tool_->setPose(pose);
  dock_->setPose(pose);
}

void PoseController::useTool(bool on) {
  dock_->setPlacing(on);
  if (on) {
    context_.tools.choose(tool_);
  } else if (context_.tools.chosen() == tool_) {
    context_.tools.putAway();
  }
}

void PoseController::set(const geometry::Pose2& pose, bool adjust) {
  robot::Localization* const robots = localization();
  if (!robots || !call_.over()) return;
  if (const QString why = jobs::noPoseReason(pose); !why.isEmpty())
    return dock_->setOutcome(why, PoseDock::Outcome::Bad);
  proposed_.reset();
  dock_->setWaiting(true, tr("Waiting for the robot to say where it is…"));
  const robot::PoseOrder order{pose, adjust};
  call_ = robots->setPose(order, [this, order](const robot::Outcome<geometry::Pose2>& now) {
    if (!now) return dock_->setOutcome(saidOf(now.error()), PoseDock::Outcome::Bad);
    const bool as_asked = jobs::deviation(order, *now).as_asked;
    const QString said = jobs::poseReport(order, *now);
    dock_->setOutcome(said, as_asked ? PoseDock::Outcome::Well : PoseDock::Outcome::Odd);
    if (!as_asked) return;
    context_.overlay.toasts()->add(Mark::Good, said);
    setPose(std::nullopt);
    useTool(false);
  });
}

void PoseController::find() {
  robot::Localization* const robots = localization();
  if (!robots || !call_.over()) return;
  proposed_.reset();
  dock_->setWaiting(true, tr("The robot is searching its map for its position…"));
  call_ = robots->findItself([this](const robot::Outcome<map::GlobalPositioning>& found) {
    if (!found) return dock_->setOutcome(saidOf(found.error()), PoseDock::Outcome::Bad);
    const bool itself = jobs::foundItself(*found);
    const bool asks = !itself && found->pose && found->needs_confirmation.value_or(false);
    dock_->setOutcome(jobs::searchReport(*found), itself ? PoseDock::Outcome::Well : PoseDock::Outcome::Odd,
                      asks);
    if (!asks) return;
    proposed_ = found->pose;
    setPose(found->pose);
    useTool(true);  // draws it
  });
}

}  // namespace mapwright::ui

#include "moc_pose_controller.cpp"
