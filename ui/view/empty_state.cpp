#include "ui/view/empty_state.h"

#include <algorithm>

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>

#include "robot/map_dispatch.h"
#include "robot/sends_map.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "sentences/problem_sentence.h"
#include "session/lacks_picture.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

using robot::ConnectionPhase;

namespace {

/// There is a map to open under *Maps*.
bool storesMaps(const session::Catalogue& catalogue) {
  return std::any_of(catalogue.entries().begin(), catalogue.entries().end(),
                     [](const map::CatalogueEntry& entry) { return entry.key.kind != map::MapKind::Live; });
}

/// It has a 3D map but no 2D map.
bool givesCloudsOnly(robot::Robot& robot) {
  using robot::DispatchService;
  const robot::MapDispatch* const dispatch = robot.mapDispatch();
  if (!dispatch || dispatch->offered(DispatchService::Grid) || dispatch->offered(DispatchService::GridRegion))
    return false;
  return dispatch->offered(DispatchService::Cloud) || dispatch->offered(DispatchService::CloudRegion) ||
         dispatch->offered(DispatchService::Occupancy) || dispatch->offered(DispatchService::OccupancyRegion);
}

EmptyState cloudsInstead() {
  EmptyState state;
  state.kind = EmptyState::Kind::NoMap;
  state.icon = QStringLiteral("map");
  state.title = QCoreApplication::translate("window", "No 2D map");
  state.text = QCoreApplication::translate(
      "window", "This robot provides point clouds. If it sends a map, the map appears automatically.");
  state.offers = {CardOffer::Clouds};
  return state;
}

/// Of files nobody is connected to.
void sayOfFile(EmptyState& state, const Fault& reason) {
  if (state.kind == EmptyState::Kind::Connecting)
    state.title = QCoreApplication::translate("window", "Opening…");
  if (state.kind == EmptyState::Kind::WaitingForList)
    state.text = QCoreApplication::translate("window", "It has not reported any yet.");
  if (state.kind == EmptyState::Kind::NoMap)
    state.text = QCoreApplication::translate("window", "Double-click one under Maps.");
  if (state.kind != EmptyState::Kind::Failed) return;
  state.title = QCoreApplication::translate("window", "This cannot be opened");
  // Most reasons name the file, which is its address, too.
  const QString why = reason.any() ? sentences::sentenceOf(reason) : QString();
  const QString path = state.text.section(QLatin1Char('\n'), 0, 0).section(QLatin1Char(':'), 1);
  if (!path.isEmpty() && why.contains(path)) state.text = why;
  state.offers = {CardOffer::Retry, CardOffer::File};
}

}  // namespace

std::optional<EmptyState> emptyState(session::Session* session, const MapsInView& in_view) {
  if (!session) return emptyState({}, {}, nullptr);
  const session::SubmapCounts counts = session->counts();
  const session::MapSlot& slot = session->wholeMap();
  if (in_view.whole && slot.cells()) return std::nullopt;
  if (in_view.regions_held || in_view.clouds_held || in_view.scans) return std::nullopt;
  // Missing regions are marked on the map.
  if (in_view.regions && session->connection().phase == ConnectionPhase::Online) return std::nullopt;
  // Its waypoints are visible: the notice says what is missing.
  if (in_view.whole && session::lacksPicture(slot) && session->robot().waypointStore()) return std::nullopt;
  auto of_submaps = emptyState(session->robot().address(), session->connection(), &counts);
  if (of_submaps && session->robot().isLocal()) sayOfFile(*of_submaps, session->connection().reason);
  const bool has_submaps = session->robot().submapSource() != nullptr;
  if (in_view.submaps && has_submaps) return of_submaps;
  if (!in_view.whole) return std::nullopt;  // nothing is requested
  using Phase = session::MapSlot::Phase;
  // Before any request, the connection state is more informative than that no map is open.
  const bool online = session->connection().phase == ConnectionPhase::Online;
  if (!online && (slot.phase() == Phase::Empty || slot.key().kind == map::MapKind::Live)) {
    if (of_submaps) return of_submaps;
  }
  const bool none_chosen = slot.phase() == Phase::Empty || slot.key().kind == map::MapKind::Live;
  if (online && none_chosen && givesCloudsOnly(session->robot())) return cloudsInstead();
  auto of_map = wholeMapState(slot, storesMaps(session->catalogue()), robot::sendsItsMap(session->robot()));
  if (of_map && session->robot().isLocal()) sayOfFile(*of_map, {});
  return of_map;
}

std::optional<EmptyState> wholeMapState(const session::MapSlot& slot, bool stored, bool live) {
  using Phase = session::MapSlot::Phase;
  if (slot.cells()) return std::nullopt;
  EmptyState state;
  state.icon = QStringLiteral("map");
  const QString name = mapCalled(slot.name(), slot.key());
  switch (slot.phase()) {
    case Phase::Failed:
      state.kind = EmptyState::Kind::MapFailed;
      state.icon = QStringLiteral("error");
      state.title = QCoreApplication::translate("window", "This map cannot be shown");
      state.text = words::about(name, sentences::sentenceOf(slot.remark()));
      state.offers = {CardOffer::Retry};
      return state;
    case Phase::Fetching:
    case Phase::Reading:
      if (slot.key().kind == map::MapKind::Live) break;
      state.kind = EmptyState::Kind::LoadingMap;
      state.icon = QStringLiteral("fetching");
      state.title = QCoreApplication::translate("window", "Loading %1").arg(name);
      state.busy = true;
      return state;
    case Phase::Empty:
    case Phase::Ready:
      break;
  }
  if (live) {
    state.kind = EmptyState::Kind::LoadingMap;
    state.title = QCoreApplication::translate("window", "Waiting for the robot's map");
    state.text =
        stored ? QCoreApplication::translate(
                     "window", "It appears as soon as the robot sends it. Stored maps are listed under Maps.")
               : QCoreApplication::translate("window", "It appears as soon as the robot sends it.");
    return state;
  }
  state.kind = EmptyState::Kind::NoMap;
  state.title = QCoreApplication::translate("window", "No map is open");
  state.text =
      stored ? QCoreApplication::translate(
                   "window", "Double-click one under Maps. This loads and changes nothing on the robot.")
             : QCoreApplication::translate("window", "The robot sends no map, and none is stored here.");
  return state;
}

std::optional<EmptyState> emptyState(const QString& address, const robot::ConnectionState& connection,
                                     const session::SubmapCounts* counts) {
  EmptyState state;
  if (!counts) {
    state.kind = EmptyState::Kind::NoRobot;
    state.icon = QStringLiteral("robot");
    state.title = QCoreApplication::translate("window", "No robot connected");
    state.text = QCoreApplication::translate("window",
                                             "Connect to a robot by its address, try the simulated one, or "
                                             "open a map file (you can also drop it here).");
    state.offers = {CardOffer::Connect, CardOffer::Demo, CardOffer::File};
    return state;
  }
  // Received data stays on the map; the notice above reports a lost connection.
  if (counts->shown > 0) return std::nullopt;
  switch (connection.phase) {
    case ConnectionPhase::Offline:
      state.kind = EmptyState::Kind::Failed;
      state.icon = QStringLiteral("disconnect");
      state.title = QCoreApplication::translate("window", "Not connected");
      state.text = address;
      state.offers = {CardOffer::Retry, CardOffer::Connect};
      return state;
    case ConnectionPhase::Connecting:
      state.kind = EmptyState::Kind::Connecting;
      state.icon = QStringLiteral("connect");
      state.title = QCoreApplication::translate("window", "Connecting…");
      state.text = address;
      state.busy = true;
      state.offers = {CardOffer::Cancel};
      return state;
    case ConnectionPhase::Interrupted:
    case ConnectionPhase::Refused: {
      state.kind = EmptyState::Kind::Failed;
      state.icon = QStringLiteral("error");
      state.title = connection.phase == ConnectionPhase::Refused
                        ? QCoreApplication::translate("window", "The robot refused the connection")
                        : QCoreApplication::translate("window", "Cannot reach the robot");
      state.text = connection.reason.any()
                       ? QStringLiteral("%1\n%2").arg(address, sentences::wordsOf(connection.reason))
                       : address;
      state.offers = {CardOffer::Retry, CardOffer::Connect};
      if (wantsSecret(connection)) state.offers.insert(CardOffer::Secret);
      if (connection.certificate) {
        // The fingerprint is in the dialog: it does not fit on a card.
        const bool changed = !connection.certificate->pinned_sha256.isEmpty();
        state.title = changed ? EmptyStateCard::tr("The certificate of the robot has changed")
                              : EmptyStateCard::tr("The certificate of the robot is not trusted");
        state.text = QStringLiteral("%1\n%2").arg(address, sentences::wordsOf(connection.certificate->why));
        state.offers.insert(CardOffer::Certificate);
        state.offers.erase(CardOffer::Retry);
      }
      return state;
    }
    case ConnectionPhase::Online:
      break;
  }
  if (!counts->list_received) {
    state.kind = EmptyState::Kind::WaitingForList;
    state.icon = QStringLiteral("submaps");
    state.title = QCoreApplication::translate("window", "Waiting for the list of submaps");
    state.text =
        QCoreApplication::translate("window", "Connected to %1. It has not sent its list yet.").arg(address);
    return state;
  }
  if (counts->listed == 0) {
    state.kind = EmptyState::Kind::NoSubmaps;
    state.icon = QStringLiteral("submaps");
    state.title = QCoreApplication::translate("window", "This robot lists no submaps");
    state.text = QCoreApplication::translate(
        "window",
        "They appear here as soon as the robot maps or localizes. Start mapping or load a map on the robot.");
    return state;
  }
  if (counts->pending > 0) {
    state.kind = EmptyState::Kind::Loading;
    state.icon = QStringLiteral("fetching");
    state.title = sentences::counted(
        QCoreApplication::translate("window", "Loading %1 submaps", nullptr, counts->listed), counts->listed);
    state.text = trafficText(*counts);
    state.busy = true;
    return state;
  }
  state.kind = EmptyState::Kind::NothingDrawable;
  // Neither is a problem.
  if (counts->missing + counts->failed + counts->corrupt == 0) {
    const bool hidden = counts->held > 0;
    state.icon = hidden ? QStringLiteral("eye-off") : QStringLiteral("empty");
    state.title = hidden ? QCoreApplication::translate("window", "All submaps are hidden")
                         : QCoreApplication::translate("window", "No submap has this slice");
    state.text = loadingText(*counts) +
                 (hidden ? QCoreApplication::translate("window", ". Show them again under Submaps.")
                         : QCoreApplication::translate("window", ". Choose another slice under Submaps."));
    return state;
  }
  state.icon = QStringLiteral("error");
  state.title = QCoreApplication::translate("window", "None of the submaps can be drawn");
  state.text =
      loadingText(*counts) + QCoreApplication::translate("window", ". See Problems for the reasons.");
  state.offers = {CardOffer::Retry};
  return state;
}

EmptyStateCard::EmptyStateCard(QWidget* parent)
    : QFrame(parent),
      icon_(new QLabel(this)),
      title_(wrappedLabel({}, this)),
      text_(textLabel({}, this)),
      progress_(new QProgressBar(this)) {
  setObjectName(QStringLiteral("card"));
  for (QLabel* label : {title_, text_}) label->setAlignment(Qt::AlignCenter);
  title_->setObjectName(QStringLiteral("title"));
  text_->setObjectName(QStringLiteral("text"));
  makeHeading(*title_, 1.3);
  icon_->setAlignment(Qt::AlignCenter);
  progress_->setRange(0, 0);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(4);
  const auto add = [this](CardOffer offer, const QString& words, bool primary) {
    auto* button = new QPushButton(words, this);
    setRole(button, primary);
    connect(button, &QPushButton::clicked, this, [this, offer] { Q_EMIT wanted(offer); });
    buttons_[offer] = button;
  };
  add(CardOffer::Secret, tr("Enter secret…"), true);
  add(CardOffer::Connect, tr("Connect…"), true);
  add(CardOffer::Demo, tr("Try the demo robot"), false);
  add(CardOffer::File, tr("Open a map file…"), false);
  add(CardOffer::Retry, tr("Retry"), true);
  add(CardOffer::Cancel, tr("Cancel"), false);
  add(CardOffer::Certificate, tr("Certificate…"), true);
  add(CardOffer::Clouds, tr("Fetch clouds…"), true);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addStretch();
  for (const CardOffer offer :
       {CardOffer::Secret, CardOffer::Clouds, CardOffer::Certificate, CardOffer::Retry, CardOffer::Connect,
        CardOffer::Demo, CardOffer::File, CardOffer::Cancel})
    buttons->addWidget(buttons_.at(offer));
  buttons->addStretch();
  setLayout(columnOf({icon_, title_, text_, LayoutItem::gap(4), progress_, LayoutItem::gap(4), buttons}, 8,
                     QMargins(32, 24, 32, 24)));
  setFixedWidth(460);
  hide();
}

void EmptyStateCard::setState(const std::optional<EmptyState>& state) {
  if (state == state_) return;
  state_ = state;
  if (!state) {
    hide();
    return;
  }
  title_->setText(words::plainText(state->title));
  text_->setText(words::plainText(state->text));
  text_->setVisible(!state->text.isEmpty());
  progress_->setVisible(state->busy);
  for (const auto& [offer, button] : buttons_) button->setVisible(state->offers.contains(offer));
  // The first button is about this robot.
  const bool second =
      state->offers.contains(CardOffer::Retry) || state->offers.contains(CardOffer::Certificate);
  buttons_.at(CardOffer::Connect)->setText(second ? tr("Other robot…") : tr("Connect…"));
  setRole(buttons_.at(CardOffer::Connect), !second);
  setRole(buttons_.at(CardOffer::Retry), !state->offers.contains(CardOffer::Secret));
  if (icon_name_ != state->icon) {
    icon_name_ = state->icon;
    paintIcon();
  }
  setVisible(true);
  adjustSize();
}

void EmptyStateCard::setRole(QPushButton* button, bool primary) {
  const QString role = primary ? QStringLiteral("primary") : QStringLiteral("secondary");
  if (button->objectName() == role) return;
  button->setObjectName(role);
  button->style()->unpolish(button);
  button->style()->polish(button);
}

void EmptyStateCard::paintIcon() {
  const UiColors colors = appColors();
  const bool bad = icon_name_ == QLatin1String("error");
  icon_->setPixmap(
      iconPixmap(icon_name_, 40, devicePixelRatioF(), bad ? colors.error_text : colors.secondary_text));
}

void EmptyStateCard::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && !icon_name_.isEmpty()) paintIcon();
  QFrame::changeEvent(event);
}

}  // namespace mapwright::ui

#include "moc_empty_state.cpp"
