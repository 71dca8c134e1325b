#include "ui/carry/carrying.h"

#include <algorithm>
#include <utility>

#include <QCheckBox>

#include "session/session.h"
#include "ui/carry/carry_dock.h"
#include "ui/kit/panels.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/viewpoint.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

constexpr double kAroundM = 3;  // of a place that is looked at: as far as walls count for it

}  // namespace

Carrying::Carrying(WindowContext& context, const CarryWords& words, const QString& dock_name, int menu_rank,
                   QObject* parent)
    : QObject(parent),
      context_(context),
      words_(words),
      dock_(new CarryDock(words, dock_name, &context.window)),
      run_(context.workers) {
  context_.panels.add(dock_,
                      {.side = PanelPosition::Side::Right, .tab = 71, .menu_rank = menu_rank, .open = false});
  connect(dock_, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    if (!visible) mark(std::nullopt);
  });
  connect(dock_, &CarryDock::lookWanted, this, &Carrying::look);
  connect(dock_, &CarryDock::placeWanted, this, &Carrying::goTo);
  connect(dock_, &CarryDock::soundWanted, this, [this] {
    std::vector<int> sound;
    for (std::size_t i = 0; i < rows().size(); ++i) {
      if (rows()[i].sound()) sound.push_back(int(i));
    }
    carryOver(sound);
  });
  connect(dock_, &CarryDock::carryWanted, this, &Carrying::carryOver);
  connect(dock_, &CarryDock::leaveOutWanted, this, &Carrying::leaveOut);
}

Carrying::~Carrying() { delete dock_; }

const std::vector<CarryRow>& Carrying::rows() const { return dock_->model()->rows(); }

bool Carrying::adjusts() const { return dock_->adjustBox()->isChecked(); }

void Carrying::setLaid(const std::optional<LaidMap>& laid) {
  if (!laid || !laid_ || laid->reader != laid_->reader || laid->key != laid_->key) {
    left_out_.clear();
    forgetCarried();
  }
  laid_ = laid;
  refresh();
}

QString Carrying::whyNot() const {
  const session::Session* const session = context_.current.session();
  if (!laid_ || !laid_->reader) return tr("There is no reference map.");
  if (!session || !session->wholeMap().cells()) return tr("There is no whole map on screen.");
  if (!session->wholeMap().settled()) return tr("The map on screen is still being read.");
  if (!session->wholeMap().isWhole()) return tr("Parts of the map on screen could not be read.");
  return whyNotBetween(*laid_->reader);
}

std::optional<Carrying::Subject> Carrying::subject() const {
  const session::Session* const session = context_.current.session();
  if (!laid_ || !session || !session->wholeMap().cells()) return std::nullopt;
  const session::MapSlot& whole = session->wholeMap();
  return Subject{*laid_, {whole.cells(), whole.reference()}, whole.shown().key, whole.shown().fingerprint};
}

void Carrying::open() {
  context_.panels.open(dock_);
  look();
}

void Carrying::look() {
  const QString why = whyNot();
  forget(why);
  if (why.isEmpty()) {
    looked_at_ = subject();
    read(*looked_at_->laid.reader, looked_at_->laid.key);
  }
  show();
}

void Carrying::start(Job job) {
  run_.start([old_map = looked_at_->laid.map, new_map = looked_at_->map, transform = looked_at_->laid.pose,
              job = std::move(job)](const BackgroundRun::Running& run) {
    const carry::Site site(old_map, new_map, transform);
    return run.cancelled ? BackgroundRun::Then() : job(site);
  });
}

void Carrying::setRows(std::vector<CarryRow> rows, const QString& besides) {
  besides_ = besides;
  // Those without an id are named by their place in the list.
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].id.empty()) rows[i].id = "#" + std::to_string(i);
  }
  dock_->model()->setRows(std::move(rows));
  refresh();
}

void Carrying::giveUp(const QString& said) {
  forget(said);
  show();
}

void Carrying::forget(const QString& said) {
  run_.forget();
  ++turn_;
  looked_at_.reset();
  mark(std::nullopt);
  dock_->model()->setRows({});
  said_ = said;
}

void Carrying::refresh() {
  const QString why = whyNot();
  if (std::exchange(why_not_, why) != why) Q_EMIT possibleChanged(why);
  const auto now = subject();
  if (looked_at_ && !(now && now->sameAs(*looked_at_)))
    forget(tr("The reference map was moved, or one of the maps is another one now. Check again."));
  updateStates();
  show();
}

void Carrying::updateStates() {
  if (!looked_at_ || rows().empty()) return;
  std::vector<CarryRow::State> states = statesNow();
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] == CarryRow::State::Open && left_out_.contains(rows()[i].id))
      states[i] = CarryRow::State::LeftOut;
  }
  dock_->model()->setStates(states);
}

void Carrying::show() {
  const auto now = subject();
  const bool any = !rows().empty(), changed = looked_at_ && now && !now->sameCells(*looked_at_);
  CarryShown shown{.said = said_, .editable = editable()};
  if (looked_at_ && !any) shown.said = words_.looking;
  if (any) shown.said = carrySumText(rows());
  if (any && !besides_.isEmpty()) shown.said = words::paragraph({words::asSentence(shown.said), besides_});
  if (any && changed)
    shown.said = tr("The map on screen has changed since then. As it was: %1").arg(shown.said);
  if (shown.said.isEmpty()) shown.said = words_.hint;
  shown.again = whyNot().isEmpty() && ((!looked_at_ && !said_.isEmpty()) || (any && changed));
  dock_->setState(shown);
}

void Carrying::goTo(int row) {
  if (row < 0 || std::size_t(row) >= rows().size()) return;
  const geometry::WorldRect there = boundsOf(row);
  context_.scene.setMarker(there.center());
  mark(row);
  context_.viewpoint.lookAt(there.grown(kAroundM));
}

void Carrying::carryOver(const std::vector<int>& wanted) {
  std::set<int> going;
  for (const int row : wanted) {
    going.insert(row);
    going.insert(rows()[std::size_t(row)].with.begin(), rows()[std::size_t(row)].with.end());
  }
  std::erase_if(going, [this](int row) { return !rows()[std::size_t(row)].goes(); });
  const std::vector<int> list(going.begin(), going.end());
  if (list.empty() || !put(list)) return;
  for (const int row : list) left_out_.erase(rows()[std::size_t(row)].id);
  mark(std::nullopt);
  Q_EMIT carried();
  refresh();
}

void Carrying::leaveOut(const std::vector<int>& wanted) {
  const auto is_open = [this](int row) { return rows()[std::size_t(row)].state == CarryRow::State::Open; };
  const bool out = std::any_of(wanted.begin(), wanted.end(), is_open);
  for (const int row : wanted) {
    std::vector<int> group = rows()[std::size_t(row)].with;
    group.push_back(row);
    for (const int one : group) {
      const std::string& id = rows()[std::size_t(one)].id;
      out ? (void)left_out_.insert(id) : (void)left_out_.erase(id);
    }
  }
  refresh();
}

}  // namespace mapwright::ui

#include "moc_carrying.cpp"
