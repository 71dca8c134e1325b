// The projections of a map dispatcher: read, edited on the map, in the section and in a table, and set.
#pragma once

#include <QMessageBox>
#include <QPointer>

#include "robot/call.h"
#include "robot/map_dispatch.h"
#include "ui/clouds/projection_draft.h"
#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class ProjectionsDock;
class ProjectionTool;
struct SectionBand;

class ProjectionsController : public Controller {
  Q_OBJECT
 public:
  explicit ProjectionsController(WindowContext& context, QObject* parent = nullptr);

  ProjectionsDock* dock() const { return dock_; }
  ProjectionTool* tool() const { return tool_; }
  const ProjectionDraft& draft() const { return draft_; }
  void setSession(session::Session* session) override;

  bool unsaved() const override { return draft_.changed(); }
  bool maySave() const override { return false; }
  void beforeLeavingRobot(std::function<void()> then) override;

  void ask();
  void send();
  void setHeights(int index, double low_m, double high_m);

 Q_SIGNALS:
  /// The heights of the projections, for the section.
  void bandsChanged(const std::vector<mapwright::ui::SectionBand>& bands);

 private:
  robot::MapDispatch* dispatch() const;
  void follow();
  void followProjected(int index);
  void refresh();
  void askWhenSeen();
  void onAnswer(const robot::Outcome<ProjectionDraft::List>& outcome);
  void onSet(const ProjectionDraft::List& wanted, const robot::Outcome<ProjectionDraft::List>& outcome);
  void add(const geometry::WorldRect& rect);
  bool editable() const;

  WindowContext& context_;
  ProjectionDraft draft_;
  ProjectionsDock* dock_;
  ProjectionTool* tool_;
  QPointer<QMessageBox> question_;
  QPointer<robot::MapDispatch> followed_;
  robot::Call call_;
  std::uint64_t asked_ = 0;  // counts the requests: answers to older ones are ignored
  bool tried_ = false;       // it was requested automatically, and nothing new is known since
};

}  // namespace mapwright::ui
