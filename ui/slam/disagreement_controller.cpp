#include "ui/slam/disagreement_controller.h"

#include <algorithm>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QPushButton>
#include <QScopedValueRollback>

#include "sentences/absence_sentence.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "submap/submap_store.h"
#include "ui/kit/panels.h"
#include "ui/kit/status_text.h"
#include "ui/scene/agreement_run.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "ui/slam/disagreement_dock.h"
#include "ui/slam/place_square.h"
#include "ui/view/map_view.h"
#include "words/fixed.h"
#include "words/listed.h"

namespace mapwright::ui {
namespace {

using scene::Layer;

constexpr int kBlinkMs = 700, kSoonMs = 300;
// Looking at what has changed takes time for each submap: at most this part of the GUI thread's.
constexpr int kShareOfTime = 10;
// How much of the map is in view around a square of 1 m: a shift by a few cells is seen.
constexpr double kMostViewM = 5, kLeastViewM = 1.25;
const QString kToleranceKey = QStringLiteral("disagreement/tolerance_cells");

}  // namespace

DisagreementController::DisagreementController(WindowContext& context, QObject* parent)
    : Controller(parent),
      context_(context),
      dock_(new DisagreementDock(&context.window)),
      run_(new scene::AgreementRun(context.workers, this)),
      square_(new PlaceSquare(context.scene)) {
  context_.panels.add(dock_, {.side = PanelPosition::Side::Right,
                              .tab = 22,
                              .menu_rank = 32,
                              .idle = lacksForGood(context.current, {robot::Capability::Submaps})});
  soon_.setSingleShot(true);
  connect(&soon_, &QTimer::timeout, this, &DisagreementController::look);
  clock_.start();
  later_.setSingleShot(true);
  connect(&later_, &QTimer::timeout, this, &DisagreementController::showWork);
  blink_.setInterval(kBlinkMs);
  connect(&blink_, &QTimer::timeout, this, &DisagreementController::step);
  connect(run_, &scene::AgreementRun::progressed, this, &DisagreementController::showFindings);
  connect(dock_, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    dock_seen_ = visible;
    if (!visible) stopStepping();
    if (dock_->isHidden()) leavePlace();
    look();
  });
  connect(&context_.scene, &scene::MapScene::layersChanged, this, [this] {
    dock_->layerBox()->setChecked(context_.scene.layerVisible(Layer::Disagreement));
    // Only layers that begin to be seen need anything.
    const bool waits = !run_->running() && !run_->survey().complete();
    if (outdated_ || waits || !isSeen()) look();
  });
  connect(dock_->layerBox(), &QCheckBox::clicked, this,
          [this](bool on) { context_.scene.setLayerVisible(Layer::Disagreement, on); });
  connect(dock_->toleranceBox(), &QComboBox::activated, this, [this] {
    leavePlace();
    setTolerance(dock_->tolerance());
  });
  connect(dock_->workButton(), &QPushButton::clicked, this, [this] {
    cancelled_ = run_->running();
    look();
  });
  connect(dock_, &DisagreementDock::placeWanted, this, [this](int row) { goTo(dock_->model()->place(row)); });
  connect(dock_->nextButton(), &QPushButton::clicked, this, [this] {
    dock_->blinkButton()->setChecked(false);
    step();
  });
  connect(dock_->blinkButton(), &QPushButton::toggled, this, [this](bool on) {
    if (on) step();
    if (on) {
      blink_.start();
    } else {
      blink_.stop();
    }
  });
  connect(dock_->allButton(), &QPushButton::clicked, this, &DisagreementController::stopStepping);
  connect(dock_->hideButton(), &QPushButton::clicked, this, &DisagreementController::hideOrShow);
  connect(dock_->showHiddenButton(), &QPushButton::clicked, this, &DisagreementController::showHidden);
  connect(&context_.current, &CurrentSession::stateChanged, this, [this] {
    if (dock_seen_) showWork();
  });
}

DisagreementController::~DisagreementController() {
  dock_->disconnect(this);
  stepper_.giveBack();
}

bool DisagreementController::isSeen() const {
  return session_ && (dock_seen_ || context_.scene.layerVisible(Layer::Disagreement) ||
                      context_.scene.layerVisible(Layer::Coverage));
}

void DisagreementController::setSession(session::Session* session) {
  if (session_) session_->disconnect(this);
  leavePlace();
  dock_->clearSelection();
  pace_ = {};
  stepper_.setSession(session);
  session_ = session;
  run_->forget();
  context_.scene.setAgreement(nullptr, 0);
  cancelled_ = false;
  if (session) {
    using session::Session;
    for (const auto changed : {&Session::submapsPlaced, &Session::submapsRemoved})
      connect(session, changed, this, &DisagreementController::lookSoon);
    connect(session, &Session::sliceChanged, this, &DisagreementController::lookSoon);
    connect(session, &Session::sessionRestarted, this, [this] {
      stepper_.forget();
      leavePlace();
      lookSoon();
    });
  }
  outdated_ = true;
  look();
}

void DisagreementController::recall(const QSettings& settings) {
  setTolerance(settings.value(kToleranceKey, agreement::Rules().tolerance_cells).toInt());
}

void DisagreementController::remember(QSettings& settings) {
  settings.setValue(kToleranceKey, dock_->tolerance());
}

void DisagreementController::reset() { setTolerance(agreement::Rules().tolerance_cells); }

void DisagreementController::setTolerance(int cells) {
  dock_->setTolerance(cells, run_->survey().rules().cell_m);
  pace_ = {};
  cancelled_ = false;
  outdated_ = true;
  look();
}

bool DisagreementController::escape() {
  if (endSteps()) return true;
  if (!place_) return false;
  leavePlace();
  return true;
}

bool DisagreementController::endSteps() {
  if (!stepper_.steps()) return false;
  stopStepping();
  return true;
}

void DisagreementController::lookSoon() {
  if (stepping_) return;
  if (!std::exchange(outdated_, true) && isSeen()) showWork();
  if (!soon_.isActive() && isSeen()) soon_.start(std::max(kSoonMs, soon_.interval()));
}

void DisagreementController::look() {
  if (!isSeen()) {
    run_->stop();
    if (!session_) showFindings();
    return;
  }
  if (outdated_) {
    QElapsedTimer clock;
    clock.start();
    std::vector<render::PlacedTexture> shown;
    for (render::PlacedTexture& placed : context_.scene.placedTextures()) {
      const submap::SubmapRow* const row = session_->submaps().find(placed.id);
      if (row && stepper_.wanted(placed.id, row->visible)) shown.push_back(std::move(placed));
    }
    const auto fault = run_->setSubmaps(shown, dock_->tolerance());
    trouble_ = fault ? sentences::sentenceOf(*fault) : QString();
    outdated_ = false;
    soon_.setInterval(int(std::min<qint64>(clock.elapsed() * kShareOfTime, 60'000)));
  }
  if (cancelled_) {
    run_->stop();
  } else if (!run_->survey().complete()) {
    run_->go();
  }
  showFindings();
}

QString DisagreementController::absence() const {
  if (!session_) return tr("Connect to a robot or open a file to see where submaps contradict each other.");
  if (!session_->robot().submapSource())
    return sentences::absenceReason(robot::Capability::Submaps,
                                    session_->robot().unavailableReason(robot::Capability::Submaps));
  if (!trouble_.isEmpty()) return trouble_;
  return run_->survey().tiles() == 0 ? tr("No submaps are on the map so far.") : QString();
}

QString DisagreementController::sentence() const {
  const agreement::Disagreement& found = *run_->found();
  const agreement::Survey& survey = run_->survey();
  const bool progress = !survey.complete() && survey.tiles() > 0 && (cancelled_ || pace_.isLong());
  QStringList parts;
  if (const QString why = absence(); !why.isEmpty()) {
    parts << why;
  } else if (found.contradicted_cells > 0) {
    parts << tr("%1 % of the occupied cells are contradicted by another submap: %2 of %3, each %4 cm wide.")
                 .arg(words::fixed(100 * found.share(), found.share() < 0.01 ? 2 : 1),
                      countText(qint64(found.contradicted_cells)), countText(qint64(found.occupied_cells)),
                      words::fixed(100 * found.cell_m, 0));
    if (!pace_.isSettled() && !progress) parts << tr("The map is still being looked at.");
    if (found.all_places > found.places.size())
      parts << tr("The worst %1 of %2 places are listed.")
                   .arg(countText(qint64(found.places.size())), countText(qint64(found.all_places)));
  } else if (pace_.isSettled()) {
    parts << tr("No submaps contradict each other here.");
  } else if (!progress) {
    parts << tr("No contradiction was found so far.");
  }
  if (progress) {
    parts << tr("%1 of %2 squares of the map are looked at so far.")
                 .arg(countText(qint64(survey.tiles() - survey.stale())), countText(qint64(survey.tiles())));
  }
  const auto add = [&](qint64 count, const QString& text) {
    if (count > 0) parts << sentences::counted(text, count);
  };
  if (session_) {
    const session::SubmapCounts counts = session_->counts();
    const int lacking = counts.listed - counts.held;
    add(lacking, tr("%1 submaps are still missing.", nullptr, lacking));
    if (!stepper_.steps()) add(counts.hidden, tr("%1 hidden submaps do not count.", nullptr, counts.hidden));
    const auto nowhere = qint64(survey.unplaceable().size());
    add(nowhere, tr("%1 submaps are too far away to count.", nullptr, sentences::formOf(nowhere)));
  }
  return words::paragraph(parts);
}

void DisagreementController::showFindings() {
  const std::shared_ptr<const agreement::Disagreement> found = run_->found();
  // The layers would cover what the steps show.
  const bool covers = stepper_.steps() || !session_;
  context_.scene.setAgreement(
      covers ? nullptr : std::shared_ptr<const agreement::Tiles>(found, &found->tiles), found->cell_m);
  dock_->setTolerance(dock_->tolerance(), run_->survey().rules().cell_m);
  dock_->setPlaces({found, &found->places});
  showSteps();
  showWork();
}

void DisagreementController::showWork() {
  const agreement::Survey& survey = run_->survey();
  const bool all = run_->foundAll(), stopped = session_ && cancelled_ && !survey.complete();
  pace_.update(WorkPace::Ms(clock_.elapsed()), isSeen() && !all && !stopped, session_ && all && !outdated_);
  using Work = DisagreementDock::Work;
  dock_->setWork(stopped          ? Work::Stopped
                 : pace_.isLong() ? Work::Goes
                                  : Work::Done,
                 survey.tiles() == 0 ? 0 : 1 - double(survey.stale()) / double(survey.tiles()));
  dock_->setText(sentence());
  dock_->setHidden(session_ && !stepper_.steps() && session_->counts().hidden > 0);
  if (const auto wait = pace_.changesIn()) {
    later_.start(*wait);
  } else {
    later_.stop();
  }
}

void DisagreementController::goTo(agreement::Place place) {
  stopStepping();
  place_ = std::make_unique<agreement::Place>(place);
  Q_EMIT wentToPlace();
  geometry::ViewTransform to = context_.view.destination();
  const double smaller_px = std::max(1, std::min(to.width_px, to.height_px));
  to.center_m = {place.x, place.y};
  to.scale_m_per_px = std::clamp(to.scale_m_per_px, kLeastViewM / smaller_px, kMostViewM / smaller_px);
  context_.view.setFollowing(false);
  context_.viewpoint.choose();
  context_.view.moveTo(to, true);
  square_->show({place.x - 0.5, place.y - 0.5, place.x + 0.5, place.y + 0.5});
  frame(place);
  showSteps();
}

void DisagreementController::frame(const agreement::Place& place) {
  const std::vector<map::SubmapId> ids = agreement::idsOf(place.submaps);
  highlight({ids.begin(), ids.end()});
}

void DisagreementController::leavePlace() {
  stopStepping();
  if (!place_) return;
  place_.reset();
  square_->hide();
  highlight({});
  dock_->clearSelection();
  showSteps();
}

void DisagreementController::highlight(std::set<map::SubmapId> ids) {
  // The inspector may have chosen others since.
  const bool mine = context_.scene.highlighted() == highlighted_;
  highlighted_ = std::move(ids);
  if (mine || !highlighted_.empty()) context_.scene.setHighlighted(highlighted_);
}

void DisagreementController::step() {
  if (!place_ || !session_) return stopStepping();
  const std::vector<map::SubmapId> ids = agreement::idsOf(place_->submaps);
  in_hand_ = in_hand_ ? (*in_hand_ + 1) % ids.size() : 0;
  if (!stepper_.steps()) context_.scene.setAgreement(nullptr, 0);
  {
    const QScopedValueRollback quiet(stepping_, true);
    stepper_.showOnly(ids, *in_hand_);
  }
  context_.scene.setOutlined(std::set<map::SubmapId>(ids.begin(), ids.end()));
  // The frame of one would tint what is to be seen.
  highlight({});
  showSteps();
}

void DisagreementController::stopStepping() {
  blink_.stop();
  dock_->blinkButton()->setChecked(false);
  in_hand_.reset();
  context_.scene.setOutlined(std::nullopt);
  if (!stepper_.steps()) return showSteps();
  {
    const QScopedValueRollback quiet(stepping_, true);
    stepper_.giveBack();
  }
  if (place_) frame(*place_);
  showSteps();
  showFindings();
}

void DisagreementController::showSteps() {
  QString text;
  auto in_hand = DisagreementDock::InHand::None;
  if (place_ && in_hand_) {
    const agreement::Part& part = place_->submaps[*in_hand_];
    const QString name = QString::fromStdString(map::toText(part.id));
    const bool hidden = isHidden(part.id);
    in_hand = hidden ? DisagreementDock::InHand::Show : DisagreementDock::InHand::Hide;
    if (!stepper_.steps()) {
      text = hidden ? tr("Submap %1 is hidden.").arg(name) : tr("Submap %1 is shown.").arg(name);
    } else {
      const QString number = QString::number(*in_hand_ + 1), all = QString::number(place_->submaps.size());
      text = (hidden ? tr("Submap %1, %2 of %3, otherwise hidden: %4") : tr("Submap %1, %2 of %3: %4"))
                 .arg(name, number, all, claimText(part));
    }
  }
  dock_->setSteps(place_ != nullptr, stepper_.steps(), text, in_hand);
}

bool DisagreementController::isHidden(map::SubmapId id) const {
  const submap::SubmapRow* const row = session_ ? session_->submaps().find(id) : nullptr;
  return row && !stepper_.wanted(id, row->visible);
}

void DisagreementController::hideOrShow() {
  if (!place_ || !in_hand_ || !session_) return;
  const std::size_t at = *in_hand_;
  const map::SubmapId id = place_->submaps[at].id;
  const bool hidden = isHidden(id);
  stopStepping();
  in_hand_ = at;
  session_->setVisible({id}, hidden);
  showSteps();
}

void DisagreementController::showHidden() {
  if (!session_) return;
  std::vector<map::SubmapId> ids;
  for (const auto& [id, row] : session_->submaps().rows()) {
    if (!row.visible) ids.push_back(id);
  }
  if (!ids.empty()) session_->setVisible(ids, true);
}

}  // namespace mapwright::ui

#include "moc_disagreement_controller.cpp"
