#include "ui/maps/administration_controller.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "jobs/change_map.h"
#include "jobs/set_pose.h"
#include "map/live_state.h"
#include "map/waypoint.h"
#include "robot/sends_map.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "session/makes_new_map.h"
#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/panels.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/maps/mapping_dock.h"
#include "ui/shell/current_session.h"
#include "ui/shell/unsaved_changes.h"
#include "ui/view/map_overlay.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/shortened.h"

namespace mapwright::ui {

namespace {

using robot::MapChange;

constexpr int kSessionFollowsMs = 15'000;

QString called(const map::CatalogueEntry* map) {
  if (!map) return {};
  return map->name.empty() ? QString::fromStdString(map::toText(map->key)) : plainWords(map->name, 80);
}

/// What is said of the robot's new session when one follows from the change; empty: nothing. nullopt: none
/// does.
std::optional<QString> ofNewSession(MapChange change) {
  switch (change) {
    case MapChange::StartMapping:
      return AdministrationController::tr("Mapping has started: the robot is making a new map.");
    case MapChange::ContinueMapping:
    case MapChange::StopMapping:
    case MapChange::CancelMapping:
    case MapChange::Load:
      return QString();
    default:
      return std::nullopt;
  }
}

/// `map`: null for changes without a map. `current`: the robot's current map, if any.
ChangeQuestion questionFor(MapChange change, const map::CatalogueEntry* map,
                           const map::CatalogueEntry* current) {
  const QString name = called(map), present = called(current);
  ChangeQuestion question;
  question.order.change = change;
  if (map) question.order.key = map->key;
  const auto ask = [&](const QString& title, const QString& text, const QString& accept,
                       const QString& done) {
    question.title = title;
    question.text = text;
    question.accept = accept;
    question.done = done;
  };
  switch (change) {
    case MapChange::Rename:
      ask(ChangeDialog::tr("Rename on the robot"), ChangeDialog::tr("What should %1 be called?").arg(name),
          ChangeDialog::tr("Rename"), ChangeDialog::tr("It is now called %1."));
      question.name = map ? QString::fromStdString(map->name) : QString();
      break;
    case MapChange::Load:
      ask(ChangeDialog::tr("Load on the robot"),
          words::paragraph(
              {current
                   ? ChangeDialog::tr("The robot will switch from %2 to %1. Its current task may be aborted.")
                         .arg(name, present)
                   : ChangeDialog::tr("The robot will switch to %1. Its current task may be aborted.")
                         .arg(name),
               jobs::poseWarning()}),
          ChangeDialog::tr("Load"), ChangeDialog::tr("The robot now uses %1."));
      question.ends_something = true;
      break;
    case MapChange::Archive:
      ask(ChangeDialog::tr("Archive on the robot"),
          ChangeDialog::tr("%1 will be archived. It is not deleted and can be restored.").arg(name),
          ChangeDialog::tr("Archive"), ChangeDialog::tr("%1 was archived."));
      break;
    case MapChange::Unarchive:
      ask(ChangeDialog::tr("Restore from the archive"),
          ChangeDialog::tr("%1 will be listed among the robot's maps again.").arg(name),
          ChangeDialog::tr("Restore"), ChangeDialog::tr("%1 was restored from the archive."));
      break;
    case MapChange::Delete:
      ask(ChangeDialog::tr("Delete from the robot"),
          ChangeDialog::tr(
              "This deletes %1 (id %2) and everything on it from the robot. It cannot be undone.")
              .arg(name, map ? words::plainName(map->key.id) : QString()),
          ChangeDialog::tr("Delete"), ChangeDialog::tr("%1 was deleted."));
      question.ends_something = true;
      if (map && map->is_current) {
        question.text += QLatin1Char(' ') + ChangeDialog::tr("The robot is using it now.");
        question.typed = {words::plainName(map->name), words::plainName(map->key.id)};
        question.typed.removeAll(QString());
      }
      break;
    case MapChange::StartMapping:
      ask(ChangeDialog::tr("Start mapping"),
          current ? ChangeDialog::tr("The robot will leave %1 and start a new map.").arg(present)
                  : ChangeDialog::tr("The robot will start a new map."),
          ChangeDialog::tr("Start mapping"), ChangeDialog::tr("The robot is mapping."));
      question.ends_something = true;
      break;
    case MapChange::ContinueMapping:
      ask(ChangeDialog::tr("Extend the map"),
          ChangeDialog::tr("The robot will map more of %1, starting at its estimated position. The map does "
                           "not change until the result is saved.")
              .arg(present),
          ChangeDialog::tr("Start mapping"), ChangeDialog::tr("The robot is mapping."));
      question.ends_something = true;
      break;
    case MapChange::CancelMapping:
      ask(ChangeDialog::tr("Discard the mapping"),
          ChangeDialog::tr("The robot will stop mapping, and what it has mapped since the start is lost. It "
                           "cannot be undone."),
          ChangeDialog::tr("Discard"), ChangeDialog::tr("The mapping was discarded."));
      question.ends_something = true;
      break;
    case MapChange::StopMapping:
      ask(ChangeDialog::tr("Stop mapping"),
          ChangeDialog::tr("The robot will stop mapping. Save the map afterwards, or it may be lost."),
          ChangeDialog::tr("Stop mapping"), ChangeDialog::tr("Mapping has stopped."));
      question.ends_something = true;
      break;
    case MapChange::Save:
      ask(ChangeDialog::tr("Save the new map"), ChangeDialog::tr("What should the new map be called?"),
          ChangeDialog::tr("Save"), ChangeDialog::tr("The map was saved as %1."));
      question.name = QString();
      break;
  }
  return question;
}

/// The names of `points`, sorted by how likely the robot is there: those tagged for localization, then entry
/// points, then the others; each by name.
std::vector<std::string> placesToStand(const std::vector<map::Waypoint>& points) {
  const auto tagged = [](const map::Waypoint& point, const char* tag) {
    return std::find(point.tags.begin(), point.tags.end(), tag) != point.tags.end();
  };
  std::vector<std::tuple<int, std::string>> places;
  for (const map::Waypoint& point : points) {
    if (point.name.empty()) continue;
    const bool known = tagged(point, "localisation") || tagged(point, "localization");
    places.emplace_back(known ? 0 : tagged(point, "map_entry") ? 1 : 2, point.name);
  }
  std::sort(places.begin(), places.end());
  std::vector<std::string> names;
  for (auto& [rank, name] : places) names.push_back(std::move(name));
  return names;
}

}  // namespace

ChangeDialog::ChangeDialog(ChangeQuestion question, Ask ask, QWidget* parent)
    : QDialog(parent),
      question_(std::move(question)),
      ask_(std::move(ask)),
      text_(new QLabel(this)),
      error_(new QLabel(this)),
      accept_(new QPushButton(question_.accept, this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setWindowTitle(question_.title);
  setMinimumWidth(440);
  for (QLabel* label : {text_, error_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  }
  text_->setText(question_.text);
  error_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  if (question_.name) {
    name_ = new QLineEdit(*question_.name, this);
    name_->setObjectName(QStringLiteral("name"));
    name_->selectAll();
    form->addRow(tr("&Name"), name_);
    connect(name_, &QLineEdit::textChanged, this, &ChangeDialog::check);
  }
  if (question_.asks_place) {
    places_ = new QComboBox(this);
    places_->setObjectName(QStringLiteral("place"));
    places_->setEditable(true);
    places_->setInsertPolicy(QComboBox::NoInsert);
    places_->setMinimumContentsLength(24);
    setPlaces({});
    form->addRow(tr("The robot stands at &waypoint"), places_);
  }
  if (!question_.typed.isEmpty()) {
    typed_ = new QLineEdit(this);
    typed_->setObjectName(QStringLiteral("typed"));
    typed_->setPlaceholderText(question_.typed.first());
    auto* const copy = new QPushButton(tr("&Copy name"), this);
    copy->setAutoDefault(false);
    connect(copy, &QPushButton::clicked, this, [this] {
      QGuiApplication::clipboard()->setText(question_.typed.first());
      typed_->setFocus();
    });
    auto* const row = new QHBoxLayout;
    row->addWidget(typed_, 1);
    row->addWidget(copy);
    auto* const label = new QLabel(tr("&Type its name or id"), this);
    label->setBuddy(typed_);
    form->addRow(label, row);
    connect(typed_, &QLineEdit::textChanged, this, &ChangeDialog::check);
  }
  if (question_.ends_something) {
    giveCarefulRoles(*accept_, *cancel_);
  } else {
    giveRoles(*accept_, {cancel_});
  }
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addStretch();
  buttons->addWidget(cancel_);
  buttons->addWidget(accept_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(10);
  column->addWidget(text_);
  if (form->rowCount() > 0) {
    column->addLayout(form);
  } else {
    delete form;
  }
  column->addWidget(error_);
  column->addLayout(buttons);
  connect(accept_, &QPushButton::clicked, this, &ChangeDialog::send);
  connect(cancel_, &QPushButton::clicked, this, &ChangeDialog::reject);
  // Enter after the name neither ends something nor throws the name away.
  if (name_ && question_.ends_something) letEnterPress(*cancel_, false);
  if (QLineEdit* const field = name_ ? name_ : typed_) field->setFocus();
  check();
}

void ChangeDialog::setPlaces(const std::vector<std::string>& names) {
  if (!places_) return;
  const QString typed = place().empty() ? QString() : places_->currentText();
  places_->clear();
  places_->addItem(tr("not stated"), QString());
  for (const std::string& name : names)
    places_->addItem(words::plainName(name), QString::fromStdString(name));
  if (!typed.isEmpty()) places_->setEditText(typed);
}

/// Empty: not stated.
std::string ChangeDialog::place() const {
  const QString text = places_->currentText();
  const int chosen = places_->currentIndex();
  const int at = chosen >= 0 && places_->itemText(chosen) == text ? chosen : places_->findText(text);
  return (at >= 0 ? places_->itemData(at).toString() : text.trimmed()).toStdString();
}

QString ChangeDialog::textShown() const { return text_->text(); }
QString ChangeDialog::errorShown() const { return error_->text(); }

QString ChangeDialog::unavailableReason() const {
  if (name_) {
    if (QString why = jobs::noMapNameReason(name_->text()); !why.isEmpty()) return why;
    if (question_.order.change == robot::MapChange::Rename && name_->text() == *question_.name)
      return tr("It already has this name.");
  }
  if (typed_ && !question_.typed.contains(typed_->text().simplified()))
    return tr("Type the name or the id of the map to delete it.");
  return {};
}

void ChangeDialog::check() {
  const QString why = unavailableReason();
  // The initial text is not an error yet.
  const bool touched = (name_ && name_->isModified()) || (typed_ && !typed_->text().isEmpty());
  accept_->setEnabled(why.isEmpty() && !waiting());
  if (waiting()) return;
  robot::MapOrder order = question_.order;
  if (name_) order.name = name_->text().toStdString();
  const QString remark = why.isEmpty() && name_ && question_.remark ? question_.remark(order) : QString();
  setTextColor(*error_, remark.isEmpty() ? appColors().secondary_text : appColors().warning_text);
  error_->setText(touched ? why + remark : remark);
}

void ChangeDialog::send() {
  if (waiting() || !unavailableReason().isEmpty()) return;
  robot::MapOrder& order = question_.order;
  if (name_) order.name = name_->text().toStdString();
  if (places_) order.place = place();
  for (QWidget* field :
       {static_cast<QWidget*>(name_), static_cast<QWidget*>(typed_), static_cast<QWidget*>(places_)})
    if (field) field->setEnabled(false);
  call_.emplace();  // before the request: nothing is sent twice
  *call_ = ask_(order, [self = QPointer<ChangeDialog>(this)](const Outcome& outcome) {
    if (self) self->onOutcome(outcome);
  });
  check();
  setTextColor(*error_, appColors().secondary_text);
  error_->setText(tr("Waiting for the robot…"));
}

void ChangeDialog::onOutcome(const Outcome& outcome) {
  call_.reset();
  for (QWidget* field :
       {static_cast<QWidget*>(name_), static_cast<QWidget*>(typed_), static_cast<QWidget*>(places_)})
    if (field) field->setEnabled(true);
  check();
  if (outcome) {
    QString said = jobs::oddity(question_.order, *outcome);
    const bool as_asked = said.isEmpty();
    if (as_asked) said = question_.done;
    if (as_asked && said.contains(QLatin1String("%1"))) said = said.arg(plainWords(outcome->name, 80));
    Q_EMIT done(*outcome, said, as_asked);
    accept();
    return;
  }
  setTextColor(*error_, appColors().error_text);
  error_->setText(QString::fromStdString(sentences::sentenceOf(outcome.error())));
}

void ChangeDialog::reject() {
  // The robot reports the result: the dialog closes then.
  if (waiting()) {
    call_->cancel();
    error_->setText(tr("Cancelling: checking whether the change took effect…"));
    return;
  }
  QDialog::reject();
}

using robot::Obstacle;

constexpr int kLookEveryMs = 3'000;

AdministrationController::AdministrationController(WindowContext& context, QObject* parent)
    : Controller(parent), context_(context), look_(new QTimer(this)) {
  const auto add = [this](MapChange change, const char* id, const QString& text, const QString& tip,
                          int rank) {
    QAction* const action =
        context_.actions.add({.id = id, .text = text, .tip = tip, .menu = {MenuGroup::Mapping, rank}}, this,
                             [this, change] { ask(change, nullptr); });
    mapping_.push_back({change, action});
  };
  add(MapChange::StartMapping, "startMapping", tr("Start &mapping…"), tr("Make the robot start a new map"),
      10);
  add(MapChange::ContinueMapping, "extendMap", tr("E&xtend the map…"),
      tr("Make the robot map more of its current map"), 15);
  add(MapChange::StopMapping, "stopMapping", tr("S&top mapping…"), tr("Make the robot finish its new map"),
      20);
  add(MapChange::CancelMapping, "cancelMapping", tr("&Discard mapping…"),
      tr("Make the robot discard what it has mapped since the start"), 25);
  add(MapChange::Save, "saveNewMap", tr("Save the &new map…"),
      tr("Store the map that the robot has made, under a name"), 30);
  QList<QAction*> actions;
  for (const Row& row : mapping_) actions << row.action;
  mapping_dock_ = new MappingDock(actions, &context.window);
  context_.panels.add(
      mapping_dock_,
      {.side = PanelPosition::Side::Right,
       .tab = 71,
       .menu_rank = 38,
       .open = false,
       .idle = [this, lacks = lacksForGood(context_.current, {robot::Capability::Administration})] {
         return left_ || lacks();
       }});
  look_->setInterval(kLookEveryMs);
  connect(look_, &QTimer::timeout, this, &AdministrationController::lookAtMapping);
  connect(&context_.current, &CurrentSession::stateChanged, this, &AdministrationController::refresh);
  refresh();
}

robot::MapAdministration* AdministrationController::maps() const {
  session::Session* const session = context_.current.session();
  return session ? session->robot().mapAdministration() : nullptr;
}

QString AdministrationController::unconfirmed() const {
  session::Session* const session = context_.current.session();
  return session ? sentences::unconfirmedOf(session->robot(), robot::Capability::Administration) : QString();
}

/// The same tool tip, with the remark that it is not confirmed where that is so.
QString AdministrationController::withUnconfirmed(const QString& tip) const {
  const QString remark = unconfirmed();
  if (remark.isEmpty()) return tip;
  if (tip.isEmpty()) return plainToolTip(remark);
  return QString(tip).replace(QLatin1String("</qt>"),
                              QStringLiteral("<br>%1</qt>").arg(remark.toHtmlEscaped()));
}

void AdministrationController::setSession(session::Session* session) {
  delete dialog_;  // its question concerns the robot that is left
  looking_ = {};
  progress_.reset();
  trouble_.clear();
  was_mapping_.reset();
  ended_.reset();
  used_.reset();
  if (session) {
    // A mapping of another robot brought it to the front. It is known now what else is there: once.
    left_ = std::exchange(came_, false);
    QMetaObject::invokeMethod(
        this, [this] { left_ = false; }, Qt::QueuedConnection);
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &AdministrationController::refresh);
    connect(&session->robot(), &robot::Robot::mapsChanged, this, &AdministrationController::refresh);
  }
  refresh();
}

/// True also while it is not known.
bool AdministrationController::anyFinishedMapping() const {
  const session::Catalogue& catalogue = context_.current.session()->catalogue();
  const auto& entries = catalogue.entries();
  return !catalogue.asOf() || std::any_of(entries.begin(), entries.end(), [](const auto& entry) {
    return entry.key.kind == map::MapKind::Mapping && entry.state == "finished";
  });
}

void AdministrationController::refresh() {
  const robot::MapAdministration* const robots = maps();
  for (const Row& row : mapping_) {
    auto obstacle = robots ? robots->obstacle(row.change, nullptr) : Obstacle::NotOffered;
    if (!obstacle && row.change == MapChange::Save && robots->savesListed() && !anyFinishedMapping())
      obstacle = Obstacle::NothingToSave;
    row.action->setVisible(obstacle != Obstacle::NotOffered);
    const bool over = ended_ && row.change == MapChange::Save;
    const QString why = obstacle                    ? sentences::notNowReason(row.change, *obstacle)
                        : !over                     ? QString()
                        : ended_ == MapChange::Save ? tr("The new map is saved.")
                                                    : tr("The mapping was discarded: there is no new map.");
    allow(row.action, why.isEmpty(), why);
    if (why.isEmpty()) row.action->setToolTip(withUnconfirmed(row.action->toolTip()));
  }
  mapping_dock_->setUnconfirmed(unconfirmed());
  onMapping();
}

/// Notices when a mapping begins or ends, whoever did it.
void AdministrationController::onMapping() {
  session::Session* const session = context_.current.session();
  const robot::MapAdministration* const robots = maps();
  if (!session) was_mapping_.reset();  // the robot is being left
  const auto starts = robots ? robots->obstacle(MapChange::StartMapping, nullptr) : Obstacle::NotOffered;
  const auto stops = robots ? robots->obstacle(MapChange::StopMapping, nullptr) : Obstacle::NotOffered;
  const auto ends = robots ? robots->obstacle(MapChange::CancelMapping, nullptr) : Obstacle::NotOffered;
  const bool running = starts == Obstacle::WhileMapping;
  const bool none = stops == Obstacle::NotMapping || ends == Obstacle::NotMapping;
  const bool online = session && session->connection().phase == robot::ConnectionPhase::Online;
  if (running || !online) ended_.reset();  // there may be another one
  if (running && was_mapping_ != true) {
    was_mapping_ = true;
    noticed_.start();
    mapping_dock_->show();  // once: whoever closes it has seen it
    context_.panels.suggest(mapping_dock_);
    came_ = true;
    new_map_shown_ = false;
    // A change made here says so itself.
    if (!dialog_ || !dialog_->waiting())
      context_.overlay.toasts()->add(Mark::Neutral, tr("The robot is mapping: see the panel Mapping."));
    session->catalogue().refresh();
    lookAtMapping();
  } else if (none && was_mapping_ != false) {
    if (was_mapping_ == true) session->catalogue().refresh();
    was_mapping_ = false;
    progress_.reset();
    trouble_.clear();
  }
  if (const map::CatalogueEntry* const current = session ? session->catalogue().current() : nullptr;
      current && !running)
    used_ = current->key;
  if (running) showNewMap();
  const bool looks = running && online;
  if (looks != look_->isActive()) looks ? look_->start() : look_->stop();
  showMapping();
}

/// Instead of the map that the robot has left for it. What is edited there stays on screen.
void AdministrationController::showNewMap() {
  session::Session* const session = context_.current.session();
  const bool left = used_ && session->wholeMap().key() == *used_ &&
                    session::makesNewMap(session->robot(), session->live(), session->submaps());
  if (!left || std::exchange(new_map_shown_, true)) return;
  if (robot::sendsItsMap(session->robot()) && !context_.unsaved.any())
    session->openMap({map::MapKind::Live, {}});
}

void AdministrationController::lookAtMapping() {
  robot::MapAdministration* const robots = maps();
  if (robots && !robots->tellsProgress()) return showMapping();  // it lasts longer
  if (!robots || !looking_.over()) return;
  looking_ = robots->progress([this](const robot::Outcome<std::optional<robot::MappingProgress>>& told) {
    trouble_ = told ? QString() : QString::fromStdString(sentences::sentenceOf(told.error()));
    if (told) progress_ = *told;
    showMapping();
  });
}

void AdministrationController::showMapping() {
  session::Session* const session = context_.current.session();
  const bool online = session && session->connection().phase == robot::ConnectionPhase::Online;
  MappingState state;
  if (session && was_mapping_ == true) {
    state.phase = online ? MappingState::Phase::Running : MappingState::Phase::Away;
  } else if (maps() && !was_mapping_) {
    state.phase = MappingState::Phase::Unknown;
  }
  if (session && was_mapping_ == true) {
    if (online) state.trouble = trouble_;
    if (online && trouble_.isEmpty() && !session->robot().submapSource() &&
        !robot::sendsItsMap(session->robot()))
      state.trouble =
          tr("This robot does not send the map while it makes it. It can be seen once it is saved.");
    state.seen_s = double(noticed_.elapsed()) / 1000;
    state.submaps = session->counts().listed;
    const geometry::WorldRect bounds = session->contentBounds();
    if (!bounds.empty()) {
      state.width_m = bounds.width();
      state.height_m = bounds.height();
    }
    if (progress_) {
      state.lasts_s = progress_->lasts_s;
      const map::CatalogueEntry* const current = session->catalogue().current();
      if (progress_->continues.value_or(false) && current) state.extends = called(current);
    }
  }
  const robot::MapAdministration* const robots = maps();
  if (robots && online) state.manager = words::shortened(words::plainName(robots->managerState()), 40);
  mapping_dock_->setState(state);
}

void AdministrationController::fillMenu(QMenu* menu, const map::MapKey& key) {
  const robot::MapAdministration* const robots = maps();
  session::Session* const session = context_.current.session();
  const map::CatalogueEntry* const map = session ? session->catalogue().find(key) : nullptr;
  if (!robots || !map) return;
  struct Entry {
    MapChange change;
    QString text;
  };
  bool first = true;
  for (const Entry& entry :
       {Entry{MapChange::Load, tr("Load on the robot…")},
        Entry{MapChange::Rename, tr("Rename on the robot…")}, Entry{MapChange::Archive, tr("Archive…")},
        Entry{MapChange::Unarchive, tr("Restore from the archive…")},
        Entry{MapChange::Delete, tr("Delete from the robot…")}}) {
    const auto obstacle = robots->obstacle(entry.change, map);
    const bool pointless = obstacle == Obstacle::NotOffered || obstacle == Obstacle::IsNotArchived ||
                           (entry.change == MapChange::Archive && obstacle == Obstacle::IsArchived);
    if (pointless) continue;
    if (std::exchange(first, false)) menu->addSeparator();
    QAction* const action = menu->addAction(entry.text, this, [this, change = entry.change, key] {
      session::Session* const now = context_.current.session();
      if (const map::CatalogueEntry* const entry_now = now ? now->catalogue().find(key) : nullptr)
        ask(change, entry_now);
    });
    action->setEnabled(!obstacle);
    action->setToolTip(obstacle ? plainToolTip(sentences::notNowReason(entry.change, *obstacle))
                                : withUnconfirmed({}));
  }
}

void AdministrationController::ask(MapChange change, const map::CatalogueEntry* map) {
  const session::Session* const session = context_.current.session();
  const bool takes_map_away = session && session->wholeMap().key().kind == map::MapKind::Live &&
                              (change == MapChange::Load || change == MapChange::StartMapping);
  const auto then = [this, change, key = map ? std::optional(map->key) : std::nullopt] {
    const session::Session* const now = context_.current.session();
    const map::CatalogueEntry* const entry = now && key ? now->catalogue().find(*key) : nullptr;
    if (now && bool(entry) == key.has_value()) showQuestion(change, entry);
  };
  // What is edited goes with the map that the robot is in.
  takes_map_away ? context_.unsaved.whenMayLeave(then) : then();
}

void AdministrationController::showQuestion(MapChange change, const map::CatalogueEntry* map) {
  robot::MapAdministration* const robots = maps();
  session::Session* const session = context_.current.session();
  if (!robots || !session || (dialog_ && dialog_->waiting())) return;
  delete dialog_;
  ChangeQuestion question = questionFor(change, map, session->catalogue().current());
  question.asks_place = change == MapChange::Load && robots->loadAsksForPlace();
  if (change == MapChange::Save &&
      robots->obstacle(MapChange::StopMapping, nullptr) == Obstacle::EndsBySaving) {
    question.text = words::paragraph(
        {question.text,
         ChangeDialog::tr("Saving ends the mapping: the robot cannot continue it afterwards.")});
    question.accept = ChangeDialog::tr("Save and end the mapping");
    question.ends_something = true;
  }
  if (const QString remark = unconfirmed(); !remark.isEmpty()) question.text += QLatin1Char('\n') + remark;
  question.remark = [this](const robot::MapOrder& order) {
    session::Session* const now = context_.current.session();
    return now ? jobs::alsoCalledSo(order, now->catalogue().entries()) : QString();
  };
  const bool places = question.asks_place;
  dialog_ = new ChangeDialog(
      std::move(question),
      [this](const robot::MapOrder& order, robot::OutcomeTo<map::CatalogueEntry> reply) {
        // It may have disappeared since the question was asked; then its answer says so, later, as always.
        if (robot::MapAdministration* const now = maps()) {
          const auto expected = ofNewSession(order.change);
          if (!expected) return now->carryOut(order, std::move(reply));
          Q_EMIT sessionExpected(expected);
          return now->carryOut(order,
                               [self = QPointer<AdministrationController>(this),
                                reply = std::move(reply)](robot::Outcome<map::CatalogueEntry> outcome) {
                                 if (self && !outcome && outcome.error().applied == map::Applied::No)
                                   Q_EMIT self->sessionExpected(std::nullopt);
                                 // A later one has another cause.
                                 if (self && outcome)
                                   QTimer::singleShot(kSessionFollowsMs, self.data(),
                                                      [self] { Q_EMIT self->sessionExpected(std::nullopt); });
                                 reply(std::move(outcome));
                               });
        }
        QMetaObject::invokeMethod(
            this,
            [order, reply = std::move(reply)] {
              reply(tl::make_unexpected(map::Failure{.kind = map::FailureKind::Unsupported,
                                                     .subject = map::subjectOf(order.key),
                                                     .asked_for = map::AskedFor::Change,
                                                     .reason = map::FailureReason::NotOffered}));
            },
            Qt::QueuedConnection);
        return robot::Call();
      },
      &context_.window);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(&session->catalogue(), &session::Catalogue::changed, dialog_, &ChangeDialog::check);
  if (dialog_->nameEdit()) session->catalogue().refresh();  // names that others have given
  connect(dialog_, &ChangeDialog::done, this,
          [this, change](const map::CatalogueEntry& changed, const QString& said, bool as_asked) {
            context_.overlay.toasts()->add(as_asked ? Mark::Good : Mark::Warning, said,
                                           change == MapChange::Save ? offerToLoad(changed) : ToastOffer());
            if (session::Session* const now = context_.current.session()) now->catalogue().refresh();
            if (change == MapChange::Save || change == MapChange::CancelMapping) ended_ = change;
            if (change == MapChange::StartMapping || change == MapChange::ContinueMapping)
              context_.panels.open(mapping_dock_);
            refresh();
            // After mapping the user usually wants to save the map; not within this call, since its dialog is
            // closing.
            if (change == MapChange::StopMapping) {
              QMetaObject::invokeMethod(
                  this,
                  [this] {
                    const robot::MapAdministration* const still = maps();
                    if (still && !still->obstacle(MapChange::Save, nullptr)) ask(MapChange::Save, nullptr);
                  },
                  Qt::QueuedConnection);
            }
          });
  if (places) askForPlaces(map->key);
  dialog_->open();
}

/// Of the map that was saved.
ToastOffer AdministrationController::offerToLoad(const map::CatalogueEntry& map) {
  const robot::MapAdministration* const robots = maps();
  if (!robots || map.key.id.empty()) return {};
  const auto obstacle = robots->obstacle(MapChange::Load, &map);
  const bool ends = robots->obstacle(MapChange::StopMapping, nullptr) == Obstacle::EndsBySaving;
  if (obstacle && !(ends && obstacle == Obstacle::WhileMapping)) return {};
  return {tr("Load it now…"), [this, key = map.key, of = QPointer(context_.current.session())] {
            session::Session* const session = context_.current.session();
            if (!session || session != of) return;  // of another robot
            const map::CatalogueEntry* const entry = session->catalogue().find(key);
            const robot::MapAdministration* const now = maps();
            const auto why = entry && now ? now->obstacle(MapChange::Load, entry) : Obstacle::NotOfThisMap;
            why ? context_.overlay.toasts()->add(Mark::Bad, sentences::notNowReason(MapChange::Load, *why))
                : ask(MapChange::Load, entry);
          }};
}

void AdministrationController::askForPlaces(const map::MapKey& key) {
  session::Session* const session = context_.current.session();
  robot::WaypointSource* const points = session ? session->robot().waypointSource() : nullptr;
  if (!points) return;
  points->waypoints(key, [dialog = dialog_](const robot::Outcome<map::WaypointList>& list) {
    if (dialog && list) dialog->setPlaces(placesToStand(list->points));
  });
}

}  // namespace mapwright::ui

#include "moc_administration_controller.cpp"
