#include "ui/clouds/projections_controller.h"

#include <algorithm>

#include <QPushButton>

#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/plural.h"
#include "session/session.h"
#include "ui/clouds/projection_tool.h"
#include "ui/clouds/projections_dock.h"
#include "ui/clouds/section_view.h"
#include "ui/kit/actions.h"
#include "ui/kit/panels.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/view/map_view.h"
#include "ui/view/tool_choice.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

using robot::DispatchService;

namespace {

/// Within the precision of grid cells.
bool isAbout(const map::Projection& told, const robot::ProjectedPart& part) {
  constexpr double kNearM = 0.5;
  const geometry::WorldRect bounds = part.part.grid.bounds();
  const Eigen::Vector4d said(told.corner_m.x(), told.corner_m.y(), told.min_z_m, told.max_z_m),
      shown(bounds.min_x, bounds.min_y, part.min_z_m, part.max_z_m);
  return (said - shown).cwiseAbs().maxCoeff() <= kNearM;
}

}  // namespace

ProjectionsController::ProjectionsController(WindowContext& context, QObject* parent)
    : Controller(parent),
      context_(context),
      dock_(new ProjectionsDock(&draft_, &context.window)),
      tool_(new ProjectionTool(&context.scene, &draft_, this)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right,
                              .tab = 56,
                              .menu_rank = 44,
                              .open = false,
                              .idle = lacksForGood(context_.current, {robot::Capability::Dispatch})});
  QAction* const action =
      context_.actions.add({.id = "projections",
                            .text = tr("Edit pro&jections"),
                            .icon = "rectangle",
                            .tip = tr("Draw the regions that the robot projects to 2D maps"),
                            .toggle = true,
                            .needs_of_robot = robot::Capability::Dispatch,
                            .menu = {MenuGroup::Tools, 80}});
  context_.tools.add(tool_, action);
  connect(action, &QAction::toggled, this, [this](bool on) {
    dock_->setDrawing(on);
    if (on) context_.panels.open(dock_);
  });
  connect(dock_->drawButton(), &QPushButton::clicked, this, [this](bool draw) {
    if (draw) {
      context_.tools.choose(tool_);
    } else {
      context_.tools.putAway();
    }
  });
  connect(dock_, &QDockWidget::visibilityChanged, this, &ProjectionsController::askWhenSeen);
  connect(dock_->askButton(), &QPushButton::clicked, this, &ProjectionsController::ask);
  connect(dock_, &ProjectionsDock::sendWanted, this, &ProjectionsController::send);
  connect(dock_->addButton(), &QPushButton::clicked, this, [this] {
    const geometry::WorldRect seen = context_.view.destination().visibleWorld();
    // The middle half of the visible area: its edges can be seen and dragged.
    add(seen.grown(-std::min(seen.width(), seen.height()) / 4));
  });
  const auto take_out = [this] {
    draft_.removeSelected();
    refresh();
  };
  connect(dock_->removeButton(), &QPushButton::clicked, this, take_out);
  connect(tool_, &ProjectionTool::removeWanted, this, take_out);
  connect(dock_->revertButton(), &QPushButton::clicked, this, [this] {
    draft_.revert();
    dock_->setOutcome({}, false);
    refresh();
  });
  const auto choose = [this](std::optional<int> index) {
    draft_.select(index);
    refresh();
  };
  connect(dock_, &ProjectionsDock::chosen, this, choose);
  connect(tool_, &ProjectionTool::chosen, this, choose);
  const auto change = [this](int index, const map::Projection& projection) {
    draft_.set(index, projection);
    refresh();
  };
  connect(dock_->model(), &ProjectionsModel::edited, this, change);
  connect(tool_, &ProjectionTool::changedTo, this, change);
  connect(tool_, &ProjectionTool::drawn, this, &ProjectionsController::add);
  connect(&context_.current, &CurrentSession::stateChanged, this, &ProjectionsController::follow);
  refresh();
}

robot::MapDispatch* ProjectionsController::dispatch() const {
  session::Session* const session = context_.current.session();
  return session ? session->robot().mapDispatch() : nullptr;
}

void ProjectionsController::setSession(session::Session* session) {
  // The next robot may have none.
  if (!session && context_.tools.chosen() == tool_) context_.tools.putAway();
  ++asked_;
  call_ = {};
  tried_ = false;
  draft_.forget();
  dock_->setBusy(false);
  dock_->setOutcome({}, false);
  if (session) {
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &ProjectionsController::follow);
  }
  follow();
}

void ProjectionsController::beforeLeavingRobot(std::function<void()> then) {
  if (!unsaved()) return then();
  if (question_) return;
  question_ = new QMessageBox(QMessageBox::Question, tr("Projections"),
                              tr("The edited projections have not been set on the robot. Discard them?"),
                              QMessageBox::Cancel, &context_.window);
  question_->setTextFormat(Qt::PlainText);
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setDefaultButton(QMessageBox::Cancel);
  QPushButton* const leave = question_->addButton(tr("Leave"), QMessageBox::DestructiveRole);
  leave->setObjectName(QStringLiteral("leaveProjections"));
  connect(leave, &QPushButton::clicked, this, [this, then = std::move(then)] {
    draft_.revert();
    refresh();
    then();
  });
  question_->open();
}

void ProjectionsController::follow() {
  session::Session* const session = context_.current.session();
  robot::MapDispatch* const offered = dispatch();
  if (followed_ != offered) {
    if (followed_) followed_->disconnect(this);
    followed_ = offered;
    if (offered) {
      connect(offered, &robot::MapDispatch::offersChanged, this, [this] {
        tried_ = false;
        follow();
      });
      connect(offered, &robot::MapDispatch::projectedChanged, this, &ProjectionsController::followProjected);
    }
  }
  // After a reconnect it may be another robot, or the same one with another list.
  if (session && session->connection().phase != robot::ConnectionPhase::Online) tried_ = false;
  QString absence;
  if (!session) {
    absence = tr("Connect to a robot with a map dispatcher to see its projections.");
  } else if (!offered) {
    absence = sentences::absenceReason(robot::Capability::Dispatch,
                                       session->robot().unavailableReason(robot::Capability::Dispatch));
  } else if (!offered->offered(DispatchService::ReadProjections) &&
             !offered->offered(DispatchService::ChangeProjections)) {
    absence = tr("This robot has no service for projections (set_map_projections).");
  }
  dock_->setAbsence(absence);
  dock_->setOffer({session && session->connection().phase == robot::ConnectionPhase::Online,
                   offered && offered->offered(DispatchService::ReadProjections),
                   offered && offered->offered(DispatchService::ChangeProjections)});
  askWhenSeen();
  refresh();
}

/// A projected map was added or removed. Ignored if the list already says so.
void ProjectionsController::followProjected(int index) {
  const robot::MapDispatch* const offered = dispatch();
  if (!offered || !draft_.told() || !call_.over()) return;
  const std::vector<robot::ProjectedPart> parts = offered->projected();
  const auto part = std::find_if(parts.begin(), parts.end(),
                                 [index](const robot::ProjectedPart& one) { return one.index == index; });
  const ProjectionDraft::List& told = *draft_.told();
  const bool listed = std::size_t(index) < told.size();
  if (part == parts.end() ? !listed : listed && isAbout(told[std::size_t(index)], *part)) return;
  tried_ = false;
  askWhenSeen();
}

bool ProjectionsController::editable() const {
  const robot::MapDispatch* const offered = dispatch();
  return offered && offered->offered(DispatchService::ChangeProjections) && call_.over();
}

void ProjectionsController::refresh() {
  const robot::MapDispatch* const offered = dispatch();
  tool_->setEditable(editable(), offered && offered->offered(DispatchService::ChangeProjections));
  dock_->refresh();
  tool_->refresh();
  std::vector<SectionBand> bands;
  for (int i = 0; i < int(draft_.wanted().size()); ++i) {
    const map::Projection& one = draft_.wanted()[std::size_t(i)];
    bands.push_back({i, one.min_z_m, one.max_z_m, draft_.selected() == i, editable()});
  }
  Q_EMIT bandsChanged(bands);
  Q_EMIT unsavedChanged();
}

void ProjectionsController::setHeights(int index, double low_m, double high_m) {
  if (!editable() || index < 0 || index >= int(draft_.wanted().size())) return;
  map::Projection one = draft_.wanted()[std::size_t(index)];
  one.min_z_m = low_m;
  one.max_z_m = high_m;
  draft_.set(index, one);
  refresh();
}

void ProjectionsController::askWhenSeen() {
  const robot::MapDispatch* const offered = dispatch();
  const session::Session* const session = context_.current.session();
  if (tried_ || !call_.over() || !dock_->isVisible() || !offered ||
      !offered->offered(DispatchService::ReadProjections))
    return;
  if (session->connection().phase != robot::ConnectionPhase::Online) return;
  tried_ = true;
  ask();
}

void ProjectionsController::ask() {
  robot::MapDispatch* const offered = dispatch();
  if (!offered || !call_.over()) return;
  dock_->setOutcome({}, false);
  dock_->setBusy(true);
  call_ =
      offered->projections([this, asked = ++asked_](const robot::Outcome<ProjectionDraft::List>& outcome) {
        if (asked == asked_) onAnswer(outcome);
      });
  refresh();
}

void ProjectionsController::onAnswer(const robot::Outcome<ProjectionDraft::List>& outcome) {
  call_ = {};
  dock_->setBusy(false);
  if (!outcome) {
    dock_->setOutcome(QString::fromStdString(sentences::sentenceOf(outcome.error())), true);
  } else if (!draft_.setAnswer(*outcome)) {
    dock_->setOutcome(tr("The robot has answered. Your edits are kept; Revert shows the robot's answer."),
                      false);
  } else if (const robot::MapDispatch* const offered = dispatch(); offered && !offered->silent().empty()) {
    QStringList names;
    for (const std::string& topic : offered->silent()) names << words::plainName(topic);
    dock_->setOutcome(
        tr("The robot has more projections, but nothing has arrived for them: %1.").arg(words::listed(names)),
        true);
  }
  refresh();
  askWhenSeen();  // there may be news since
}

void ProjectionsController::send() {
  robot::MapDispatch* const offered = dispatch();
  if (!offered || !editable() || draft_.firstFlawed()) return;
  dock_->setOutcome({}, false);
  dock_->setBusy(true);
  const ProjectionDraft::List wanted = draft_.wanted();
  call_ = offered->project(
      wanted, [this, wanted, asked = ++asked_](const robot::Outcome<ProjectionDraft::List>& outcome) {
        if (asked == asked_) onSet(wanted, outcome);
      });
  refresh();
}

void ProjectionsController::onSet(const ProjectionDraft::List& wanted,
                                  const robot::Outcome<ProjectionDraft::List>& outcome) {
  call_ = {};
  tried_ = true;  // it has just been reported
  dock_->setBusy(false);
  if (!outcome) {
    dock_->setOutcome(QString::fromStdString(sentences::sentenceOf(outcome.error())), true);
    return refresh();
  }
  draft_.settle(*outcome);
  const qint64 others = map::differing(wanted, *outcome);
  if (others == 0) {
    dock_->setOutcome(tr("The robot accepted the projections."), false);
  } else {
    dock_->setOutcome(sentences::counted(tr("The robot has answered, but %1 projections differ from what was "
                                            "sent. The table shows its answer.",
                                            nullptr, sentences::formOf(others)),
                                         others),
                      true);
  }
  refresh();
}

void ProjectionsController::add(const geometry::WorldRect& rect) {
  if (!editable() || rect.empty()) return;
  map::Projection one;
  if (const map::Projection* const like = draft_.selectedOne()) {
    one = *like;  // its heights and its frame
  } else {
    one.min_z_m = 0;
    one.max_z_m = 2;
  }
  one.corner_m = {rect.min_x, rect.min_y};
  one.size_m = {rect.width(), rect.height()};
  draft_.add(one);
  refresh();
}

}  // namespace mapwright::ui

#include "moc_projections_controller.cpp"
