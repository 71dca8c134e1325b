// Disagreement and coverage of the submaps in the window: computed while the dock or a layer shows them.
#pragma once

#include <memory>
#include <optional>
#include <set>

#include <QElapsedTimer>
#include <QPointer>
#include <QString>
#include <QTimer>

#include "ui/kit/controller.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/window_context.h"
#include "ui/slam/submap_stepper.h"
#include "ui/slam/work_pace.h"

namespace mapwright::agreement {
struct Place;
}
namespace mapwright::ui::scene {
class AgreementRun;
}

namespace mapwright::ui {

class DisagreementDock;
class PlaceSquare;

class DisagreementController : public Controller {
  Q_OBJECT
 public:
  explicit DisagreementController(WindowContext& context, QObject* parent = nullptr);
  ~DisagreementController() override;

  DisagreementDock* dock() const { return dock_; }
  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  void reset() override;
  bool escape() override;
  /// All submaps as before; false: no step was shown.
  bool endSteps();
  /// Its frames and its square go: another thing is looked at.
  void leavePlace();

 Q_SIGNALS:
  /// What else is marked on the map would lie over it.
  void wentToPlace();

 private:
  bool isSeen() const;
  void setTolerance(int cells);
  void lookSoon();
  void look();
  void showFindings();
  void showWork();
  QString sentence() const;
  QString absence() const;
  void goTo(agreement::Place place);
  void step();
  void stopStepping();
  void showSteps();
  /// The submap in hand.
  void hideOrShow();
  bool isHidden(map::SubmapId id) const;
  void showHidden();
  void frame(const agreement::Place& place);
  void highlight(std::set<map::SubmapId> ids);

  WindowContext& context_;
  DisagreementDock* dock_;
  scene::AgreementRun* run_;
  PlaceSquare* square_;  // owned by the scene
  QPointer<session::Session> session_;
  QTimer soon_, blink_, later_;
  QElapsedTimer clock_;
  WorkPace pace_;
  bool dock_seen_ = false, cancelled_ = false, outdated_ = true;
  QString trouble_;
  SubmapStepper stepper_;
  bool stepping_ = false;                    // what is shown and hidden just now changes no findings
  std::unique_ptr<agreement::Place> place_;  // that the user went to; null = none
  std::optional<std::size_t> in_hand_;       // of its submaps: shown while stepping, or hidden then
  std::set<map::SubmapId> highlighted_;      // by this
};

}  // namespace mapwright::ui
