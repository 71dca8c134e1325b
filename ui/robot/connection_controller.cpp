#include "ui/robot/connection_controller.h"

#include <utility>

#include <QDir>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include "robot/second_server.h"
#include "sentences/absence_sentence.h"
#include "sentences/fault_sentence.h"
#include "session/session.h"
#include "submap/submap_store.h"
#include "ui/kit/actions.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/robot/certificate_dialog.h"
#include "ui/robot/connection_chip.h"
#include "ui/robot/robot_look.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/current_session.h"
#include "ui/shell/notices.h"
#include "ui/shell/unsaved_changes.h"
#include "ui/view/empty_state.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/notice_bar.h"
#include "ui/view/on_screen.h"
#include "ui/view/replay_state.h"
#include "ui/view/toast_stack.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

using robot::ConnectionPhase;

namespace {

constexpr int kTickMs = 1000;

/// Without submenus, which belong to the menu bar.
void addGroup(QMenu& menu, const Actions& actions, MenuGroup group) {
  for (const auto& [position, action] : actions.inMenus()) {
    if (position.group == group && !action->menu()) menu.addAction(action);
  }
}

}  // namespace

ConnectionController::ConnectionController(WindowContext& context, Means means, QObject* parent)
    : Controller(parent),
      context_(context),
      means_(std::move(means)),
      recents_(context.settings, context.addresses),
      secrets_(context.settings, context.addresses, means_.keys) {
  recents_.whenForgotten([this](const QString& address) { forget(address); });
  auto* const files = new QMenu(tr("Open &recent"), &context_.window);
  files->setToolTipsVisible(true);
  connect(files, &QMenu::aboutToShow, this, [this, files] {
    files->clear();
    addRecents(*files, true, {});
    if (files->isEmpty()) files->addAction(tr("None yet"))->setEnabled(false);
  });
  context_.actions.addToMenu({MenuGroup::Files, 20}, files->menuAction());
  addActions();
  connect(context_.overlay.card(), &EmptyStateCard::wanted, this, &ConnectionController::acceptOffer);
  connect(&context_.current, &CurrentSession::stateChanged, this, &ConnectionController::refresh);
  stale_tick_.setInterval(kTickMs);
  connect(&stale_tick_, &QTimer::timeout, this, [this] {
    if (chip_) refreshChip();
    refreshNotices();
  });
  context_.actions.addToBar({BarGroup::Robot, 10}, [this](QWidget* parent_widget) {
    chip_ = new ConnectionChip(parent_widget);
    auto* const menu = new QMenu(chip_);
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillChipMenu(*menu); });
    chip_->setMenu(menu);
    return chip_;
  });
}

void ConnectionController::addActions() {
  context_.actions.add({.id = "connect",
                        .text = tr("&Connect…"),
                        .icon = "connect",
                        .keys = {"Ctrl+O"},
                        .tip = tr("Connect to a robot"),
                        .menu = {MenuGroup::Robots, 10}},
                       this, &ConnectionController::openDialog);
  context_.actions.add({.id = "demo",
                        .text = tr("Try the &demo robot"),
                        .icon = "demo",
                        .tip = tr("Connect to a simulated robot inside this program"),
                        .menu = {MenuGroup::Robots, 40}},
                       this, [this] { goTo(QStringLiteral("demo:")); });
  retry_ = context_.actions.add({.id = "retry",
                                 .text = tr("&Retry now"),
                                 .icon = "retry",
                                 .keys = {"F5"},
                                 .tip = tr("Reconnect, and repeat every request that failed"),
                                 .menu = {MenuGroup::Link, 10}},
                                this, &ConnectionController::retry);
  disconnect_ = context_.actions.add({.id = "disconnect",
                                      .text = tr("D&isconnect"),
                                      .icon = "disconnect",
                                      .tip = tr("Disconnect from this robot"),
                                      .menu = {MenuGroup::Link, 20}},
                                     this, &ConnectionController::leave);
  close_file_ = context_.actions.add({.id = "closeFile",
                                      .text = tr("&Close file"),
                                      .icon = "disconnect",
                                      .tip = tr("Close this file"),
                                      .menu = {MenuGroup::Files, 30}},
                                     this, &ConnectionController::leave);
  read_again_ = context_.actions.add({.id = "readAgain",
                                      .text = tr("&Read again"),
                                      .icon = "retry",
                                      .tip = tr("Read this file again"),
                                      .menu = {MenuGroup::Files, 40}},
                                     this, &ConnectionController::retry);
  look_action_ = context_.actions.add({.id = "robotLook",
                                       .text = tr("&Name and colour…"),
                                       .icon = "robot",
                                       .tip = tr("Your own name and colour for this robot"),
                                       .needs_session = true,
                                       .menu = {MenuGroup::Link, 25}},
                                      this, &ConnectionController::editLook);
}

void ConnectionController::fillChipMenu(QMenu& menu) {
  menu.clear();
  addGroup(menu, context_.actions, MenuGroup::Robots);
  addRecents(menu, false, tr("Recent robots"));
  menu.addSection(tr("Files"));
  addGroup(menu, context_.actions, MenuGroup::Files);
  addRecents(menu, true, {});
  const session::Session* const session = context_.current.session();
  if (!session || session->robot().isLocal()) return;
  menu.addSeparator();
  addGroup(menu, context_.actions, MenuGroup::Link);
}

void ConnectionController::addRecents(QMenu& menu, bool files, const QString& title) {
  bool first = true;
  for (const RecentRobot& robot : recents_.list()) {
    const RecentWords words = wordsOf(robot, recents_.addresses());
    if (robot.address == context_.current.address() || words.file != files) continue;
    if (first && !title.isEmpty()) menu.addSection(title);
    first = false;
    QString label =
        words.detail.isEmpty() ? words.title : QStringLiteral("%1  %2").arg(words.title, words.detail);
    label.replace(QLatin1Char('&'), QLatin1String("&&"));  // no mnemonics from robots
    QAction* const action = menu.addAction(plainWords(label, 120));
    action->setToolTip(plainToolTip(robot.address));
    if (const QColor color = robotColor(robot.look.color); color.isValid())
      action->setIcon(robotColorIcon(color));
    connect(action, &QAction::triggered, this, [this, address = robot.address] { goTo(address); });
  }
}

void ConnectionController::acceptOffer(CardOffer offer) {
  switch (offer) {
    case CardOffer::Connect:
      return openDialog();
    case CardOffer::Secret:
      return enterSecret();
    case CardOffer::Demo:
      return goTo(QStringLiteral("demo:"));
    case CardOffer::Retry:
      return retry();
    case CardOffer::Certificate:
      return openCertificate();
    case CardOffer::Cancel:
      return leave();
    case CardOffer::File:
      return Q_EMIT fileWanted();
    case CardOffer::Clouds:
      break;  // not about the connection
  }
}

std::optional<QString> ConnectionController::connectTo(const QString& address, const QByteArray& secret) {
  const auto parsed = recents_.addresses().parse(address);
  return connectAs({address, secret, recents_.look(parsed ? parsed->text : address)});
}

std::optional<QString> ConnectionController::connectAs(const ConnectDialog::Wish& wish) {
  const int attempt = ++attempts_;
  const bool given = means_.has_secret && means_.has_secret(wish.address);
  typed_secret_ = !wish.secret.isEmpty();
  if (typed_secret_ || given || !secrets_.kept(wish.address))
    return connectWith(wish.address, wish.secret, wish.look);
  secrets_.read(wish.address, [this, attempt, wish](const keyring::KeyRingAnswer& answer) {
    if (attempt != attempts_) return;  // somebody wanted another robot meanwhile
    if (answer.reason.any())
      context_.overlay.toasts()->add(
          Mark::Warning,
          tr("The stored secret cannot be read. %1").arg(sentences::sentenceOf(answer.reason)));
    if (const auto error = connectWith(wish.address, answer.secret, wish.look))
      context_.overlay.toasts()->add(Mark::Bad, *error);
  });
  return std::nullopt;
}

std::optional<QString> ConnectionController::connectWith(const QString& address, const QByteArray& secret,
                                                         const RobotLook& look) {
  auto robot = means_.connect(address, secret);
  if (!robot) return robot.error();
  if (!*robot) return tr("No robot supports this address.");
  // A replay leads back to the robot before it, which needs its secret again.
  if (!(*robot)->isLocal()) {
    secret_of_ = (*robot)->address();
    secret_ = secret;
  }
  // Shared, because the callback has to be copyable.
  context_.unsaved.whenMayLeaveRobot(
      [this, made = std::make_shared<std::unique_ptr<robot::Robot>>(std::move(*robot)), look] {
        begin(std::move(*made), look);
      });
  return std::nullopt;
}

tl::expected<std::unique_ptr<robot::Robot>, QString> ConnectionController::another(
    const QString& address) const {
  auto robot = means_.connect(address, address == secret_of_ ? secret_ : QByteArray());
  if (robot && !*robot) return tl::make_unexpected(tr("No robot supports this address."));
  return robot;
}

std::vector<std::pair<QString, QString>> ConnectionController::named() const {
  std::vector<std::pair<QString, QString>> named;
  for (const RecentRobot& robot : recents_.list())
    named.emplace_back(robot.address, wordsOf(robot, recents_.addresses()).title);
  return named;
}

void ConnectionController::begin(std::unique_ptr<robot::Robot> robot, const RobotLook& look) {
  unproven_ = robot->address();
  look_ = look;
  recents_.tried(unproven_, look);
  context_.current.begin(std::move(robot));
  showLook();
  onWorks();
  context_.view.setFocus();
}

void ConnectionController::onWorks() {
  const session::Session* const session = context_.current.session();
  if (!session || unproven_.isEmpty() || session->connection().phase != ConnectionPhase::Online) return;
  const QString address = std::exchange(unproven_, QString());
  recents_.add(address, QDateTime::currentDateTime());
  saveIdentity();
  storeSettings();
  if (typed_secret_ && secrets_.kept(address)) {
    // It was agreed to, and this one works.
    secrets_.keep(address, secret_, [](const keyring::KeyRingAnswer&) {});
  } else if (typed_secret_ && secrets_.mayAsk(address)) {
    askToKeepSecret(address);
  }
}

void ConnectionController::askToKeepSecret(const QString& address) {
  auto* const question = new QMessageBox(
      QMessageBox::Question, tr("Keep the secret?"),
      tr("Keep the secret of %1 in the key ring of this computer?").arg(context_.current.called()),
      QMessageBox::NoButton, &context_.window);
  question->setTextFormat(Qt::PlainText);
  question->setInformativeText(
      tr("It will be used from there. It is stored nowhere else, and removed when you forget the robot."));
  question->setAttribute(Qt::WA_DeleteOnClose);
  question->setObjectName(QStringLiteral("keepSecret"));
  QPushButton* const keep = question->addButton(tr("Keep"), QMessageBox::AcceptRole);
  QPushButton* const never = question->addButton(tr("Never for this robot"), QMessageBox::DestructiveRole);
  QPushButton* const not_now = question->addButton(tr("Not now"), QMessageBox::RejectRole);
  question->setDefaultButton(keep);
  question->setEscapeButton(not_now);
  connect(never, &QPushButton::clicked, this, [this, address] { secrets_.neverAsk(address); });
  connect(keep, &QPushButton::clicked, this, [this, address, secret = secret_] {
    secrets_.keep(address, secret, [this](const keyring::KeyRingAnswer& answer) {
      const bool kept = !answer.reason.any();
      context_.overlay.toasts()->add(
          kept ? Mark::Good : Mark::Warning,
          kept ? tr("The secret is in the key ring.")
               : tr("The secret was not stored. %1").arg(sentences::sentenceOf(answer.reason)));
    });
  });
  question->open();
}

void ConnectionController::forget(const QString& address) {
  secrets_.forget(address, [this](const keyring::KeyRingAnswer& answer) {
    if (answer.reason.any())
      context_.overlay.toasts()->add(Mark::Warning,
                                     tr("The secret could not be removed from the key ring. %1")
                                         .arg(sentences::sentenceOf(answer.reason)));
  });
}

void ConnectionController::editLook() {
  const session::Session* const session = context_.current.session();
  if (!session) return;
  auto* const dialog =
      new RobotLookDialog(look_, robotCalled(session->robot(), recents_.addresses()), &context_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, address = context_.current.address()] {
    recents_.setLook(address, dialog->look());
    storeSettings();
    if (address != context_.current.address()) return;
    look_ = dialog->look();
    showLook();
  });
  dialog->open();
}

void ConnectionController::showLook() {
  context_.current.setCalled(look_.called);
  if (chip_) refreshChip();
}

void ConnectionController::leave() {
  context_.unsaved.whenMayLeaveRobot([this] { context_.current.leave(); });
}

void ConnectionController::goTo(const QString& address) {
  if (const auto error = connectTo(address)) context_.overlay.toasts()->add(Mark::Bad, *error);
}

void ConnectionController::goBackTo(const QString& address) {
  ++attempts_;
  typed_secret_ = false;  // it was asked before whether to keep it
  const QByteArray secret = address == secret_of_ ? secret_ : QByteArray();
  if (const auto error = connectWith(address, secret, recents_.look(address)))
    context_.overlay.toasts()->add(Mark::Bad, *error);
}

void ConnectionController::startWith(const QString& address) {
  const auto error = connectTo(address);
  if (!error) return;
  context_.notices.set(NoticeRank::Link,
                       {Mark::Bad, words::about(address, *error), tr("Connect…"), [this] { openDialog(); }});
}

void ConnectionController::retry() {
  session::Session* const session = context_.current.session();
  if (!session) return;
  const session::MapSlot& slot = session->wholeMap();
  const bool map_failed = slot.phase() == session::MapSlot::Phase::Failed || slot.broken();
  session->retryNow();
  if (map_failed) session->openMap(slot.key());
}

void ConnectionController::openDialog() {
  ConnectDialog dialog(
      recents_, [this](const ConnectDialog::Wish& wish) { return connectAs(wish); }, means_.probes,
      &context_.window);
  // Not a file: who connects wants a robot.
  const session::Session* const session = context_.current.session();
  const QString address = context_.current.address();
  if (session && !session->robot().isLocal() && !address.startsWith(QLatin1String("demo")))
    dialog.setAddress(address);
  dialog.exec();
  // Its name may have been changed there.
  if (session && session == context_.current.session()) {
    look_ = recents_.look(context_.current.address());
    showLook();
  }
}

ConnectDialog* ConnectionController::secretDialog() const {
  return context_.window.findChild<ConnectDialog*>();
}

void ConnectionController::enterSecret() {
  const session::Session* const session = context_.current.session();
  if (!session || secretDialog()) return;
  auto* const dialog = new ConnectDialog(
      recents_, [this](const ConnectDialog::Wish& wish) { return connectAs(wish); }, means_.probes,
      &context_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
  // After showing it, so that the focus stays.
  dialog->askForSecret(context_.current.address(), sentences::wordsOf(session->connection().reason), look_);
}

std::optional<robot::UntrustedCertificate> ConnectionController::certificateBeside() const {
  session::Session* const session = context_.current.session();
  robot::SecondServer* const second = session ? robot::secondServerOf(session->robot()) : nullptr;
  return second ? second->certificateBeside() : std::nullopt;
}

void ConnectionController::openCertificate() {
  const session::Session* const session = context_.current.session();
  if (!session || context_.window.findChild<CertificateDialog*>()) return;
  // Its own certificate comes before that of the second server.
  const auto own = session->connection().certificate, certificate = own ? own : certificateBeside();
  if (!certificate) return;
  auto* const dialog = new CertificateDialog(*certificate, &context_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, decided = *certificate, is_own = own.has_value()] {
    // The robot may have been left meanwhile, or shows yet another one.
    session::Session* const present = context_.current.session();
    if (!present || (is_own ? present->connection().certificate : certificateBeside()) != decided) return;
    TrustedCertificates(context_.settings).trust(decided.host, decided.sha256);
    is_own ? present->robot().trustCertificate(decided.sha256)
           : robot::secondServerOf(present->robot())->trustBeside(decided.sha256);
  });
  dialog->open();
}

void ConnectionController::setSession(session::Session* session) {
  last_uuid_.clear();
  expected_.reset();
  if (!session) return;
  connect(session, &session::Session::identityChanged, this, &ConnectionController::saveIdentity);
  connect(session, &session::Session::sessionRestarted, this, &ConnectionController::updateRestart);
}

void ConnectionController::storeSettings() {
  QSettings& settings = context_.settings;
  settings.sync();
  if (settings.status() == QSettings::NoError || std::exchange(settings_told_, true)) return;
  context_.overlay.toasts()->add(
      Mark::Warning,
      tr("The layout and the recent robots cannot be saved: %1 is not writable. Is the disk full?")
          .arg(QDir::toNativeSeparators(settings.fileName())));
}

void ConnectionController::saveIdentity() {
  const session::Session* const session = context_.current.session();
  if (!session) return;
  const robot::RobotIdentity identity = session->robot().identity();
  const QString name = identity.name.isEmpty() ? identity.serial : identity.name;
  if (!name.isEmpty()) recents_.setName(context_.current.address(), name);
}

void ConnectionController::updateRestart() {
  const session::Session* const session = context_.current.session();
  if (!session) return;
  const QString uuid = QString::fromStdString(session->submaps().uuid());
  if (uuid == last_uuid_) return;
  if (!last_uuid_.isEmpty() && !uuid.isEmpty()) {
    if (const auto expected = std::exchange(expected_, std::nullopt)) {
      if (!expected->isEmpty()) context_.overlay.toasts()->add(Mark::Neutral, *expected);
    } else {
      context_.overlay.toasts()->add(Mark::Warning,
                                     tr("The robot started a new SLAM session. The previous map is gone."));
    }
  }
  last_uuid_ = uuid;
}

void ConnectionController::setSafety(const SafetyText& text) {
  if (chip_) chip_->setSafety(text);
}

void ConnectionController::refresh() {
  onWorks();
  const session::Session* const session = context_.current.session();
  const bool local = session && session->robot().isLocal();
  const QString no_robot =
      local ? tr("A file is open, and no robot connected: see the menu File.") : QString();
  allow(retry_, session && !local, no_robot);
  allow(disconnect_, session && !local, no_robot);
  close_file_->setEnabled(local);
  read_again_->setEnabled(local);
  // One key for both: that of what is there.
  QAction* const has_key = local ? read_again_ : retry_;
  (local ? retry_ : read_again_)->setShortcut({});
  has_key->setShortcut(QKeySequence(Qt::Key_F5));
  look_action_->setVisible(!local);
  const bool stale = session && session->staleSince().has_value();
  context_.scene.setStale(stale);
  // Updates the elapsed time.
  const bool counts = session && valuesAsOf(*session).has_value();
  if (counts && !stale_tick_.isActive()) stale_tick_.start();
  if (!counts) stale_tick_.stop();
  if (chip_) refreshChip();
  refreshNotices();
}

void ConnectionController::refreshChip() {
  const session::Session* const session = context_.current.session();
  chip_->setColor(session ? robotColor(look_.color) : QColor());
  if (!session) {
    chip_->setRobot(tr("No robot"), Mark::Neutral, {}, tr("Connect to a robot"));
    return;
  }
  const robot::RobotIdentity identity = session->robot().identity();
  const robot::ConnectionState connection = session->connection();
  QStringList detail{context_.current.address()};
  if (!identity.model.isEmpty()) detail << tr("Model %1").arg(identity.model);
  if (!identity.serial.isEmpty()) detail << tr("Serial number %1").arg(identity.serial);
  if (!identity.version.isEmpty()) detail << tr("Version %1").arg(identity.version);
  const StateText state = sourceText(session).value_or(linkText(connection, silentOnline(*session)));
  detail << state.text;
  if (replayText(session)) {
    chip_->setRobot(bagCalled(*replayOf(session)), state.mark, tr("replay"), detail.join(QLatin1Char('\n')));
    return;
  }
  if (session->robot().isLocal()) {
    const bool open = connection.phase == ConnectionPhase::Online;
    chip_->setRobot(context_.current.called(), state.mark, open ? tr("file") : tr("file, not open"),
                    detail.join(QLatin1Char('\n')));
    return;
  }
  if (const auto since = session->staleSince())
    detail << tr("No connection since %1, %2")
                  .arg(QLocale::c().toString(*since, QStringLiteral("HH:mm:ss")),
                       lengthText(since->secsTo(QDateTime::currentDateTime())));
  chip_->setRobot(context_.current.called(), state.mark, linkWord(connection, silentOnline(*session)),
                  detail.join(QLatin1Char('\n')));
}

void ConnectionController::refreshNotices() {
  session::Session* const session = context_.current.session();
  Notice link, limits;
  const auto since = session ? session->staleSince() : std::nullopt;
  if (since && (session->counts().held > 0 || session->wholeMap().cells())) {
    const robot::ConnectionState connection = session->connection();
    const bool refused = connection.phase == ConnectionPhase::Refused;
    link.mark = refused ? Mark::Bad : Mark::Warning;
    const bool local = session->robot().isLocal();
    link.sentence = lostConnectionSentence(*since, QDateTime::currentDateTime(),
                                           local ? context_.current.called() : QString());
    if (refused && connection.reason.any())
      link.sentence = words::paragraph({link.sentence, sentences::sentenceOf(connection.reason)});
    if (wantsSecret(connection)) {
      link.offer = tr("Enter secret…");
      link.accept = [this] { enterSecret(); };
    } else if (connection.certificate) {
      link.offer = tr("Certificate…");
      link.accept = [this] { openCertificate(); };
    } else {
      link.offer = local ? tr("Read again") : tr("Retry now");
      link.accept = [this] { retry(); };
    }
  }
  if (const auto beside = certificateBeside(); beside && link.sentence.isEmpty()) {
    link = {Mark::Warning,
            tr("The certificate of %1 is not trusted: the robot's pose and sensor data are missing.")
                .arg(beside->host),
            tr("Certificate…"), [this] { openCertificate(); }};
  }
  if (session) limits = {.sentence = sentences::limitsOf(session->robot()), .closable = true};
  context_.notices.set(NoticeRank::Link, std::move(link));
  context_.notices.set(NoticeRank::Limits, std::move(limits));
}

}  // namespace mapwright::ui

#include "moc_connection_controller.cpp"
